/* mesh_net.h - which sheets a lattice of signs separates: a closed manifold of quads, by dual contouring.
 *
 * The crossed edges of a cell fall into sheets, each a loop of segments on the cell's faces; each sheet is a
 * point of the net.  Each crossed edge of the lattice is a quad, between the sheets of its four cells (Ju,
 * Losasso, Schaefer, Warren 2002; several sheets a cell: Nielson 2004; Schaefer, Ju, Warren 2007).
 *
 * A face with four crossed edges is ambiguous: its segments cut off its inner corners, one each.  Where that
 * leaves both segments to one sheet, in both cells at the face, four quads would share an edge; there they
 * cut off the outer corners instead, which splits both sheets.  No cell has two such faces, so every edge of
 * the net is shared by two quads exactly (tests/test_mesh tries all cells and random signs).
 */
#ifndef MESH_NET_H
#define MESH_NET_H
#include <stddef.h>
#include <stdint.h>

enum { MESH_EDGES = 12 };

/* The sheets of a cell.  Corner c is at (c & 1, c >> 1 & 1, c >> 2); edge 4 a + o runs along axis a, at
 * offsets (o & 1, o >> 1) along the next two axes in cyclic order. */
typedef struct mesh_sheets {
    unsigned char count;
    signed char of[MESH_EDGES]; /* which sheet an edge belongs to; -1: it is not crossed */
} mesh_sheets;

typedef struct mesh_table {
    mesh_sheets sheets[512];  /* by which corners are inside; from 256 on with the face below turned */
    signed char turning[256]; /* the face whose segments belong to one sheet, 2 a + side; -1: there is none */
} mesh_table;

void mesh_table_make(mesh_table *table);

/* The corner at the lower end of an edge. */
int mesh_edge_corner(int edge);

typedef struct mesh_cell {
    uint32_t first;  /* of its sheets, among those of the slab */
    uint16_t sheets; /* index into the table */
} mesh_cell;

/* A layer of cells. */
typedef struct mesh_slab {
    mesh_cell *cells; /* nx ny of them, x fastest */
    uint32_t *active; /* those with sheets */
    size_t active_count, active_room;
    uint32_t sheets; /* their number */
    uint32_t base;   /* the number of the first one in the whole net: the caller's */
} mesh_slab;

/* A quad about an edge of the lattice, its corners anticlockwise as seen from the edge's upper end.  Points
 * are numbers in the whole net. */
typedef struct mesh_quad {
    uint32_t point[4];
    int axis, at[2]; /* of the edge; x and y of its lower end */
} mesh_quad;

/* What takes the quads; 0 ends the walk. */
typedef int mesh_take_quad(const mesh_quad *quad, void *data);

/* Finds the sheets of a slab of nx by ny cells.
 *   layer  which points are inside, (nx + 1)(ny + 1) each, x fastest: the layers below the slab's lower one,
 *          its lower one, its upper one, above that; null where there is none.  A point is inside if all bits
 *          of `mask` are set
 * Points on the lattice's border must not be inside.  Returns 0 without memory.  The slab is empty, or that
 * of an earlier call with the same size. */
int mesh_slab_fill(const mesh_table *table, int nx, int ny, const unsigned char *const layer[4], int mask,
                   mesh_slab *slab);
void mesh_slab_free(mesh_slab *slab);

/* The quads about the edges of the slab's lower layer and about those from there to its upper one.
 *   below  the slab below; null for the lowest one
 *   layer  the slab's two layers
 * Returns 0 if `take` did. */
int mesh_slab_quads(const mesh_table *table, int nx, int ny, const unsigned char *const layer[2], int mask,
                    const mesh_slab *below, const mesh_slab *slab, mesh_take_quad *take, void *data);

#endif
