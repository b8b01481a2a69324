/* mesh_data.c - see mesh_data.h. */
#include "mesh_data.h"

#include <stdlib.h>
#include <string.h>

/* ---- room ---- */

static size_t room_for(size_t count) {
    size_t room = 1024;
    while (room < count) room += room / 2;
    return room;
}

static int reserve_points(mesh *m, size_t room) {
    void *at = realloc(m->at, room * sizeof *m->at);
    if (!at) return 0;
    m->at = at;
    void *normal = realloc(m->normal, room * sizeof *m->normal);
    if (!normal) return 0;
    m->normal = normal;
    void *kind = realloc(m->kind, room);
    if (!kind) return 0;
    m->kind = kind;
    return 1;
}

static int reserve_triangles(mesh *m, size_t room) {
    void *corner = realloc(m->corner, room * sizeof *m->corner);
    if (!corner) return 0;
    m->corner = corner;
    void *closing = realloc(m->closing, room);
    if (!closing) return 0;
    m->closing = closing;
    return 1;
}

int mesh_reserve(mesh *m, size_t points, size_t triangles) {
    const size_t p = room_for(points), t = room_for(triangles);
    if ((!m->kind || p > room_for(m->points)) && !reserve_points(m, p)) return 0;
    return (m->closing && t <= room_for(m->triangles)) || reserve_triangles(m, t);
}

void mesh_free(mesh *m) {
    free(m->at);
    free(m->normal);
    free(m->kind);
    free(m->corner);
    free(m->closing);
    memset(m, 0, sizeof *m);
}

void mesh_normal(const mesh *m, const uint32_t corner[3], double normal[3]) {
    const double *o = m->at[corner[0]], *p = m->at[corner[1]], *q = m->at[corner[2]];
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        normal[k] = (p[i] - o[i]) * (q[j] - o[j]) - (p[j] - o[j]) * (q[i] - o[i]);
    }
}

uint32_t mesh_root(uint32_t *parent, uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/* ---- edges ---- */

uint32_t mesh_next_corner(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

static uint32_t point_at(const mesh *m, uint32_t corner) { return m->corner[corner / 3][corner % 3]; }

/* Sorts the few edges of one lower end, those with equal ends in their order. */
static void sort(mesh_use *use, size_t count) {
    for (size_t i = 1; i < count; i++) {
        const mesh_use moved = use[i];
        size_t k = i;
        for (; k > 0 && use[k - 1].high > moved.high; k--) use[k] = use[k - 1];
        use[k] = moved;
    }
}

static int tell(uint32_t low, mesh_use *use, size_t count, mesh_take_edge *take, void *data) {
    sort(use, count);
    for (size_t i = 0, next; i < count; i = next) {
        for (next = i + 1; next < count && use[next].high == use[i].high; next++) {
        }
        if (!take(low, use + i, (int)(next - i), data)) return 0;
    }
    return 1;
}

int mesh_each_edge(const mesh *m, mesh_take_edge *take, void *data) {
    const uint32_t corners = (uint32_t)(3 * m->triangles);
    uint32_t *end = calloc(m->points + 1, sizeof *end); /* of each lower end's edges */
    mesh_use *use = malloc((corners + (size_t)1) * sizeof *use);
    int done = end && use;
    for (int pass = 0; pass < 2 && done; pass++) { /* counts, then fills from the back */
        for (uint32_t c = corners; c-- > 0;) {
            const uint32_t a = point_at(m, c), b = point_at(m, mesh_next_corner(c));
            const uint32_t low = a < b ? a : b;
            if (pass == 0)
                end[low]++;
            else
                use[--end[low]] = (mesh_use){a < b ? b : a, c};
        }
        for (size_t i = 0; i < m->points && pass == 0; i++) end[i + 1] += end[i];
    }
    for (size_t i = 0; i < m->points && done; i++) {
        const uint32_t last = i + 1 < m->points ? end[i + 1] : corners;
        done = tell((uint32_t)i, use + end[i], last - end[i], take, data);
    }
    free(end);
    free(use);
    return done;
}
