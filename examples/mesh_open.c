/* mesh_open.c - see mesh_open.h. */
#include "mesh_open.h"

#include <stdlib.h>
#include <string.h>

/* ---- points ---- */

/* Corners of triangles, in sets that share a point: each names another one of its set, the first one itself.
 */
typedef struct fans {
    const mesh *m;
    uint32_t *parent;
} fans;

static void join(uint32_t *parent, uint32_t a, uint32_t b) {
    a = mesh_root(parent, a);
    b = mesh_root(parent, b);
    if (a < b)
        parent[b] = a;
    else
        parent[a] = b;
}

/* Triangles on both sides of an edge belong together at both of its ends. */
static int join_across(uint32_t low, const mesh_use *use, int count, void *data) {
    const fans *f = data;
    for (int i = 1; i < count; i++) {
        uint32_t at_low[2], at_high[2];
        for (int k = 0; k < 2; k++) {
            const uint32_t c = use[k * i].corner;
            const int upwards = f->m->corner[c / 3][c % 3] == low;
            at_low[k] = upwards ? c : mesh_next_corner(c);
            at_high[k] = upwards ? mesh_next_corner(c) : c;
        }
        join(f->parent, at_low[0], at_low[1]);
        join(f->parent, at_high[0], at_high[1]);
    }
    return 1;
}

/* A point for each set of corners, in the order of the triangles. */
static int take_points(mesh *m, uint32_t *parent, uint32_t *number) {
    mesh taken = {.triangles = m->triangles, .corner = m->corner, .closing = m->closing};
    int done = 1;
    for (uint32_t c = 0; c < 3 * m->triangles && done; c++) {
        const uint32_t first = mesh_root(parent, c);
        uint32_t *corner = &m->corner[c / 3][c % 3];
        if (first == c) {
            done = mesh_reserve(&taken, taken.points + 1, taken.triangles);
            if (!done) break;
            memcpy(taken.at[taken.points], m->at[*corner], sizeof *m->at);
            memcpy(taken.normal[taken.points], m->normal[*corner], sizeof *m->normal);
            taken.kind[taken.points] = m->kind[*corner];
            number[c] = (uint32_t)taken.points++;
        }
        *corner = number[first];
    }
    free(m->at);
    free(m->normal);
    free(m->kind);
    m->at = taken.at;
    m->normal = taken.normal;
    m->kind = taken.kind;
    m->points = taken.points;
    return done;
}

int mesh_open_tidy(mesh *m) {
    const size_t corners = 3 * m->triangles;
    fans f = {m, malloc((corners + 1) * sizeof *f.parent)};
    uint32_t *number = malloc((corners + 1) * sizeof *number);
    int done = f.parent && number;
    for (size_t c = 0; c < corners && done; c++) f.parent[c] = (uint32_t)c;
    done = done && mesh_each_edge(m, join_across, &f) && take_points(m, f.parent, number);
    free(f.parent);
    free(number);
    return done;
}

void mesh_open_turn(mesh *m) {
    for (size_t i = 0; i < m->points; i++)
        for (int k = 0; k < 3; k++) m->normal[i][k] = -m->normal[i][k];
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t first = m->corner[i][1];
        m->corner[i][1] = m->corner[i][2];
        m->corner[i][2] = first;
    }
}

/* ---- a shell ---- */

typedef struct rim {
    mesh *m;
    uint32_t behind; /* added to a point's number: the same one on the other side */
} rim;

static int add(mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    if (!mesh_reserve(m, m->points, m->triangles + 1)) return 0;
    m->corner[m->triangles][0] = a;
    m->corner[m->triangles][1] = b;
    m->corner[m->triangles][2] = c;
    m->closing[m->triangles++] = 1;
    return 1;
}

/* Closes the gap between both sides at an edge of the boundary. */
static int close_edge(uint32_t low, const mesh_use *use, int count, void *data) {
    const rim *r = data;
    const uint32_t c = use->corner;
    if (count != 1) return 1;
    (void)low;
    const uint32_t a = r->m->corner[c / 3][c % 3], next = mesh_next_corner(c);
    const uint32_t b = r->m->corner[next / 3][next % 3];
    return add(r->m, b, a, a + r->behind) && add(r->m, b, a + r->behind, b + r->behind);
}

int mesh_open_thicken(mesh *m, double thickness) {
    const size_t points = m->points, triangles = m->triangles;
    rim r = {m, (uint32_t)points};
    if (2 * points > MESH_MOST_POINTS || !mesh_reserve(m, 2 * points, triangles)) return 0;
    if (!mesh_each_edge(m, close_edge, &r)) return 0;
    for (size_t i = 0; i < points; i++) {
        for (int k = 0; k < 3; k++) {
            const double move = 0.5 * thickness * (double)m->normal[i][k], x = m->at[i][k];
            m->at[i][k] = x + move;
            m->at[points + i][k] = x - move;
            m->normal[points + i][k] = -m->normal[i][k];
        }
        m->kind[points + i] = MESH_CLOSING;
    }
    m->points = 2 * points;
    for (size_t i = 0; i < triangles; i++) {
        const uint32_t *t = m->corner[i], back[3] = {t[0] + r.behind, t[1] + r.behind, t[2] + r.behind};
        if (!add(m, back[0], back[2], back[1])) return 0;
    }
    return 1;
}
