/* mesh_measure.h - what a mesh is: closed or not, its topology, its size, how near it is to the surface. */
#ifndef MESH_MEASURE_H
#define MESH_MEASURE_H
#include "mesh_data.h"

typedef struct mesh_measures {
    size_t edges;
    size_t open;                        /* edges with one triangle: the boundary */
    size_t irregular;                   /* edges with more than two, or with two that are not turned alike */
    double open_at[3], irregular_at[3]; /* a point of the first one */
    long pieces;
    long euler; /* points - edges + triangles */
    double low[3], high[3];
    double area, volume; /* volume: what a closed mesh encloses */
} mesh_measures;

/* 0: no memory. */
int mesh_measure(const mesh *m, mesh_measures *measures);

/* The largest distance from the surface to first order, |P| / |gradient|, of triangles' centres and smooth
 * points. */
double mesh_deviation(const mesh *m, const algsurf_surface *surface);

#endif
