/* mesh_measure.c - see mesh_measure.h. */
#include "mesh_measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct survey {
    const mesh *m;
    mesh_measures *measures;
    uint32_t *parent; /* points that edges connect, as sets: each names another one, the first one itself */
} survey;

static int take_edge(uint32_t low, const mesh_use *use, int count, void *data) {
    const survey *s = data;
    mesh_measures *of = s->measures;
    const uint32_t a = mesh_root(s->parent, low), b = mesh_root(s->parent, use->high);
    int forwards = 0;
    of->edges++;
    if (a != b) {
        s->parent[a > b ? a : b] = a > b ? b : a;
        of->pieces--;
    }
    for (int i = 0; i < count; i++) forwards += s->m->corner[use[i].corner / 3][use[i].corner % 3] == low;
    if (count == 1) {
        if (of->open++ == 0) memcpy(of->open_at, s->m->at[low], sizeof of->open_at);
    } else if (count > 2 || forwards != 1) {
        if (of->irregular++ == 0) memcpy(of->irregular_at, s->m->at[low], sizeof of->irregular_at);
    }
    return 1;
}

static void take_triangle(const mesh *m, const uint32_t corner[3], mesh_measures *of) {
    double n[3];
    mesh_normal(m, corner, n);
    of->area += 0.5 * mesh_length(n);
    for (int k = 0; k < 3; k++) /* from one of the points, so that little is lost far from the origin */
        of->volume += (m->at[corner[0]][k] - m->at[0][k]) * n[k] / 6;
}

int mesh_measure(const mesh *m, mesh_measures *measures) {
    survey s = {m, measures, malloc((m->points + 1) * sizeof *s.parent)};
    *measures = (mesh_measures){.pieces = (long)m->points};
    if (!s.parent) return 0;
    for (int k = 0; k < 3; k++) measures->low[k] = INFINITY, measures->high[k] = -INFINITY;
    for (size_t i = 0; i < m->points; i++) {
        s.parent[i] = (uint32_t)i;
        for (int k = 0; k < 3; k++) {
            measures->low[k] = fmin(measures->low[k], m->at[i][k]);
            measures->high[k] = fmax(measures->high[k], m->at[i][k]);
        }
    }
    const int done = mesh_each_edge(m, take_edge, &s);
    for (size_t i = 0; i < m->triangles; i++) take_triangle(m, m->corner[i], measures);
    measures->euler = (long)m->points - (long)measures->edges + (long)m->triangles;
    free(s.parent);
    return done;
}

static double distance(const algsurf_surface *surface, const double x[3]) {
    double value, gradient[3];
    if (algsurf_surface_gradient(surface, x, &value, gradient, NULL, NULL) != ALGSURF_OK) return 0;
    const double steep = mesh_length(gradient);
    return steep > 0 ? fabs(value) / steep : 0;
}

double mesh_deviation(const mesh *m, const algsurf_surface *surface) {
    double most = 0;
    for (size_t i = 0; i < m->points; i++)
        if (m->kind[i] == MESH_SMOOTH) most = fmax(most, distance(surface, m->at[i]));
    for (size_t i = 0; i < m->triangles; i++) {
        double centre[3] = {0};
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++) centre[k] += m->at[m->corner[i][c]][k] / 3;
        if (!m->closing[i]) most = fmax(most, distance(surface, centre));
    }
    return most;
}
