/* mesh_rows.h - all crossings of a surface with a row of parallel lattice lines, and the signs they prove.
 *
 * A row is the lines along one axis in one plane of the lattice.  Crossings come from algsurf_intersect_all,
 * so that none is missed however close two are.  Whether a point of the lattice is inside is decided once, by
 * the lines along x; lines along y and z only say where between an inner and an outer point the boundary is.
 * So the signs always fit together, whatever rounding does.
 */
#ifndef MESH_ROWS_H
#define MESH_ROWS_H
#include "mesh_space.h"

/* What a lattice cannot show: how many, and where the first one is. */
typedef struct mesh_doubt {
    size_t count;
    double at[3];
} mesh_doubt;

enum {
    MESH_CROWDED,   /* edges of the lattice that the surface crosses more than once */
    MESH_TOUCHED,   /* points of lattice lines where they touch the surface: P has an even root */
    MESH_UNDECIDED, /* places of lattice lines where it is undecided whether there is a crossing */
    MESH_SHARP,     /* cells in which the surface turns by more than 60 degrees: singular, or too few cells */
    MESH_DOUBTS
};

void mesh_doubt_add(mesh_doubt *doubt, const double at[3]);
void mesh_doubts_join(mesh_doubt *sum, const mesh_doubt *more);

typedef struct mesh_hit {
    double t; /* the coordinate along the row's axis */
    float normal[3];
    signed char side; /* the sign of P before it; 0: undecided */
} mesh_hit;

typedef struct mesh_row {
    mesh_hit *hits; /* of all lines, in order; those at which P changes its sign, and undecided ones */
    size_t count, room;
    size_t *start; /* of each line's hits, and behind the last one */
    mesh_doubt doubts[MESH_DOUBTS];
} mesh_row;

/* The bits of a point of the lattice. */
enum { MESH_NEGATIVE = 1, MESH_IN_EXTENT = 2, MESH_INSIDE = 3 };

/* Finds the crossings of the lines along `axis` in plane `at` of the lattice: of the planes across z for axis
 * 0 and 1, which hold a line for each y or x; of those across y for axis 2, a line for each x.  The row is
 * empty or that of an earlier call.
 *   signs  for axis 0 the bits of the plane's points, x fastest; else null
 * Errors: E_NO_MEMORY, and those of algsurf_intersect_all. */
algsurf_status mesh_row_trace(const mesh_space *space, int axis, int at, const algsurf_intersect_options *how,
                              mesh_row *row, unsigned char *signs);
void mesh_row_free(mesh_row *row);

/* Where an edge of the lattice leaves the solid. */
typedef struct mesh_crossing {
    double at[3], normal[3]; /* the normal points outwards; 0 if there is none */
    int part;
} mesh_crossing;

/* The crossing of the edge from a point of the lattice to the next one along the row's axis, of which one
 * is inside.  low, high: the bits of both. */
void mesh_row_crossing(const mesh_space *space, const mesh_row *row, int axis, const int point[3], int low,
                       int high, mesh_crossing *crossing);

#endif
