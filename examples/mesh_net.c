/* mesh_net.c - see mesh_net.h. */
#include "mesh_net.h"

#include <stdlib.h>
#include <string.h>

/* ---- the table ---- */

int mesh_edge_corner(int edge) {
    const int a = edge / 4, o = edge % 4;
    return (o & 1) << (a + 1) % 3 | (o >> 1) << (a + 2) % 3;
}

static int edge_between(int corner, int other) {
    const int a = (corner ^ other) >> 1, low = corner & other; /* 1, 2, 4 to 0, 1, 2 */
    return 4 * a + ((low >> (a + 1) % 3 & 1) | (low >> (a + 2) % 3 & 1) << 1);
}

static int root(const int parent[MESH_EDGES], int edge) {
    while (parent[edge] != edge) edge = parent[edge];
    return edge;
}

/* The corners and edges around a face; edge i is between corners i and i + 1. */
static void walk_face(int face, int corner[4], int edge[4]) {
    const int a = face / 2, b = 1 << (a + 1) % 3, c = 1 << (a + 2) % 3, base = (face & 1) << a;
    const int around[4] = {base, base | b, base | b | c, base | c};
    for (int i = 0; i < 4; i++) {
        corner[i] = around[i];
        edge[i] = edge_between(around[i], around[(i + 1) % 4]);
    }
}

/* Joins the edges that segments of a face connect; returns whether it is ambiguous. */
static int join_face(int inside, int face, int turned, int parent[MESH_EDGES]) {
    int corner[4], edge[4], crossed[4], count = 0;
    walk_face(face, corner, edge);
    for (int i = 0; i < 4; i++)
        if ((inside >> corner[i] ^ inside >> corner[(i + 1) % 4]) & 1) crossed[count++] = edge[i];
    if (count == 2) parent[root(parent, crossed[0])] = root(parent, crossed[1]);
    for (int i = 0; i < 4 && count == 4; i++)
        if ((inside >> corner[i] & 1) != turned)
            parent[root(parent, edge[i])] = root(parent, edge[(i + 3) % 4]);
    return count == 4;
}

/* The sheets of a cell with one face turned, or none: -1; returns the ambiguous faces, a bit each. */
static int find_sheets(int inside, int turned_face, int parent[MESH_EDGES], mesh_sheets *sheets) {
    int ambiguous = 0, number[MESH_EDGES];
    for (int e = 0; e < MESH_EDGES; e++) parent[e] = e;
    for (int f = 0; f < 6; f++) ambiguous |= join_face(inside, f, f == turned_face, parent) << f;
    sheets->count = 0;
    memset(number, -1, sizeof number);
    for (int e = 0; e < MESH_EDGES; e++) {
        const int low = mesh_edge_corner(e), high = low | 1 << e / 4, r = root(parent, e);
        sheets->of[e] = -1;
        if (!((inside >> low ^ inside >> high) & 1)) continue;
        if (number[r] < 0) number[r] = sheets->count++;
        sheets->of[e] = (signed char)number[r];
    }
    return ambiguous;
}

void mesh_table_make(mesh_table *table) {
    int parent[MESH_EDGES], corner[4], edge[4];
    for (int inside = 0; inside < 256; inside++) {
        const int ambiguous = find_sheets(inside, -1, parent, &table->sheets[inside]);
        table->turning[inside] = -1;
        for (int f = 0; f < 6; f++) {
            if (!(ambiguous >> f & 1)) continue;
            walk_face(f, corner, edge);
            if (root(parent, edge[0]) == root(parent, edge[2]) &&
                root(parent, edge[0]) == root(parent, edge[1]))
                table->turning[inside] = (signed char)f;
        }
        (void)find_sheets(inside, table->turning[inside], parent, &table->sheets[256 + inside]);
    }
}

/* ---- sheets of a slab ---- */

typedef struct window {
    const unsigned char *const *layer; /* of four */
    int nx, ny, mask;
} window;

static int is_inside(const window *w, const unsigned char *layer, int i, int j) {
    return (layer[(size_t)j * ((size_t)w->nx + 1) + (size_t)i] & w->mask) == w->mask;
}

/* Four corners of a cell, those at its lower x, where the cell has them. */
static int column(const window *w, int below, int i, int j) {
    const unsigned char *low = w->layer[below], *high = w->layer[below + 1];
    return is_inside(w, low, i, j) | is_inside(w, low, i, j + 1) << 2 | is_inside(w, high, i, j) << 4 |
           is_inside(w, high, i, j + 1) << 6;
}

/* Which corners of a cell are inside; below: the layer under it. */
static int corners(const window *w, int below, int i, int j) {
    return column(w, below, i, j) | column(w, below, i + 1, j) << 1;
}

/* Is the turning face of this cell that of the cell on its other side, too? */
static int is_turned(const mesh_table *table, const window *w, int inside, int i, int j) {
    const int face = table->turning[inside];
    if (face < 0) return 0;
    const int step = face & 1 ? 1 : -1, axis = face / 2;
    const int other =
        corners(w, 1 + (axis == 2 ? step : 0), i + (axis == 0 ? step : 0), j + (axis == 1 ? step : 0));
    return table->turning[other] == (face ^ 1);
}

static int add_active(mesh_slab *slab, uint32_t index) {
    if (slab->active_count == slab->active_room) {
        const size_t room = slab->active_room ? 2 * slab->active_room : 256;
        uint32_t *active = realloc(slab->active, room * sizeof *active);
        if (!active) return 0;
        slab->active = active;
        slab->active_room = room;
    }
    slab->active[slab->active_count++] = index;
    return 1;
}

int mesh_slab_fill(const mesh_table *table, int nx, int ny, const unsigned char *const layer[4], int mask,
                   mesh_slab *slab) {
    const window w = {layer, nx, ny, mask};
    slab->active_count = 0;
    slab->sheets = 0;
    if (!slab->cells) slab->cells = malloc((size_t)nx * (size_t)ny * sizeof *slab->cells);
    if (!slab->cells) return 0;
    for (int j = 0; j < ny; j++) {
        int left = column(&w, 1, 0, j);
        for (int i = 0; i < nx; i++) {
            const int right = column(&w, 1, i + 1, j), inside = left | right << 1;
            const size_t index = (size_t)j * (size_t)nx + (size_t)i;
            left = right;
            if (inside == 0 || inside == 255) continue;
            const int entry = inside + (is_turned(table, &w, inside, i, j) ? 256 : 0);
            slab->cells[index] = (mesh_cell){slab->sheets, (uint16_t)entry};
            if (!add_active(slab, (uint32_t)index)) return 0;
            slab->sheets += table->sheets[entry].count;
        }
    }
    return 1;
}

void mesh_slab_free(mesh_slab *slab) {
    free(slab->cells);
    free(slab->active);
    memset(slab, 0, sizeof *slab);
}

/* ---- quads ---- */

typedef struct walk {
    const mesh_table *table;
    const mesh_slab *slab[2]; /* below, and the slab itself */
    int nx;
} walk;

/* The quad about the edge from point (i, j) of the slab's lower layer along an axis. */
static mesh_quad quad_about(const walk *w, int axis, int i, int j) {
    static const int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh_quad quad = {.axis = axis, .at = {i, j}};
    for (int k = 0; k < 4; k++) {
        int at[3] = {i, j, 1};
        at[(axis + 1) % 3] += around[k][0] - 1;
        at[(axis + 2) % 3] += around[k][1] - 1;
        const mesh_slab *slab = w->slab[at[2]];
        const mesh_cell *cell = &slab->cells[(size_t)at[1] * (size_t)w->nx + (size_t)at[0]];
        const int edge = 4 * axis + (1 - around[k][0]) + 2 * (1 - around[k][1]);
        const int sheet = w->table->sheets[cell->sheets].of[edge];
        quad.point[k] = slab->base + cell->first + (uint32_t)sheet;
    }
    return quad;
}

int mesh_slab_quads(const mesh_table *table, int nx, int ny, const unsigned char *const layer[2], int mask,
                    const mesh_slab *below, const mesh_slab *slab, mesh_take_quad *take, void *data) {
    const walk w = {table, {below, slab}, nx};
    const window v = {layer, nx, ny, mask};
    for (int j = 0; j < ny; j++) {
        for (int i = 0; i < nx; i++) {
            const int here = is_inside(&v, layer[0], i, j);
            const int next[3] = {is_inside(&v, layer[0], i + 1, j), is_inside(&v, layer[0], i, j + 1),
                                 is_inside(&v, layer[1], i, j)};
            for (int axis = 0; axis < 3; axis++) {
                if (here == next[axis]) continue;
                const mesh_quad quad = quad_about(&w, axis, i, j);
                if (!take(&quad, data)) return 0;
            }
        }
    }
    return 1;
}
