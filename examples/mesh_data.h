/* mesh_data.h - triangles, what is known of them, and their edges. */
#ifndef MESH_DATA_H
#define MESH_DATA_H
#include <stddef.h>
#include <stdint.h>

#include "mesh_rows.h"

typedef struct mesh {
    size_t points, triangles;
    double (*at)[3];
    float (*normal)[3];     /* of the points, unit, towards P > 0 or out of the solid; 0: there is none */
    unsigned char *kind;    /* of the points: MESH_SMOOTH, ... */
    uint32_t (*corner)[3];  /* of the triangles, anticlockwise as seen from where the normals point */
    unsigned char *closing; /* of the triangles: 1 for what closes the surface */
    double h;               /* the edge of a cell */
    mesh_doubt doubts[MESH_DOUBTS];
} mesh;

/* What a point is on. */
enum {
    MESH_SMOOTH,  /* the surface, as one smooth sheet */
    MESH_CLOSING, /* what closes the surface, or a wall's inner side */
    MESH_FIXED    /* the surface, where it ends or is sharp */
};

/* Calls job(i, job_data) for all i below count, in any order, perhaps several at once. */
typedef void mesh_runner(void (*job)(int index, void *job_data), int count, void *job_data, void *data);

enum { MESH_MOST_POINTS = 1 << 28 }; /* so that corners of triangles have numbers in 32 bits */

/* Makes room for so many points and triangles altogether; 0: no memory.  Room grows by half each time. */
int mesh_reserve(mesh *m, size_t points, size_t triangles);
void mesh_free(mesh *m);

/* A triangle that has an edge. */
typedef struct mesh_use {
    uint32_t high;   /* the edge's end with the larger number */
    uint32_t corner; /* 3 triangle + corner: the edge goes from there to the triangle's next corner */
} mesh_use;

/* What is told of each edge: its end with the smaller number, and the triangles that have it; 0 ends the
 * walk. */
typedef int mesh_take_edge(uint32_t low, const mesh_use *use, int count, void *data);

/* Walks all edges, in the order of their ends; 0: no memory, or `take` returned 0.  Cost: linear. */
int mesh_each_edge(const mesh *m, mesh_take_edge *take, void *data);

/* The normal of a triangle, as long as twice its area. */
void mesh_normal(const mesh *m, const uint32_t corner[3], double normal[3]);

/* Sets of numbers: each names another one of its set, the first one itself, which is returned. */
uint32_t mesh_root(uint32_t *parent, uint32_t i);

/* The next corner of the same triangle. */
uint32_t mesh_next_corner(uint32_t corner);

#endif
