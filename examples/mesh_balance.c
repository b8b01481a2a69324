/* mesh_balance.c - see mesh_balance.h. */
#include "mesh_balance.h"

#include <math.h>
#include <stdlib.h>

enum { CHUNK = 4096 };
static const double MOST = 1.0 / 8; /* of a cell */

typedef struct balance {
    const mesh *m;
    const algsurf_surface *surface;
    float *gap; /* of each triangle: its mean distance from the surface, along the gradient */
} balance;

/* Over a triangle with its corners on the surface the distance is a quadratic form of the barycentric
 * coordinates without squares, to third order; its mean is 3/4 of the value at the centre. */
static float gap_of(const balance *b, const uint32_t corner[3]) {
    double centre[3] = {0}, value, gradient[3];
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) centre[k] += b->m->at[corner[c]][k] / 3;
    if (algsurf_surface_gradient(b->surface, centre, &value, gradient, NULL, NULL) != ALGSURF_OK) return 0;
    const double steep = mesh_length(gradient);
    return steep > 0 ? (float)(0.75 * value / steep) : 0;
}

static void find_gaps(int index, void *data) {
    const balance *b = data;
    const size_t end = ((size_t)index + 1) * CHUNK;
    for (size_t i = (size_t)index * CHUNK; i < end && i < b->m->triangles; i++)
        b->gap[i] = b->m->closing[i] ? 0 : gap_of(b, b->m->corner[i]);
}

int mesh_balance(mesh *m, const algsurf_surface *surface, mesh_runner *run, void *run_data) {
    balance b = {m, surface, malloc((m->triangles + 1) * sizeof *b.gap)};
    double(*sum)[2] = calloc(m->points + 1, sizeof *sum); /* area times gap, and area, about each point */
    const int chunks = (int)((m->triangles + CHUNK - 1) / CHUNK), done = b.gap && sum;
    for (int i = 0; i < chunks && done && !run; i++) find_gaps(i, &b);
    if (done && run) run(find_gaps, chunks, &b, run_data);
    for (size_t i = 0; i < m->triangles && done; i++) {
        double n[3];
        mesh_normal(m, m->corner[i], n);
        const double area = mesh_length(n);
        for (int c = 0; c < 3; c++) {
            sum[m->corner[i][c]][0] += area * (double)b.gap[i];
            sum[m->corner[i][c]][1] += area;
        }
    }
    for (size_t i = 0; i < m->points && done; i++) {
        const double move = sum[i][1] > 0 ? -sum[i][0] / sum[i][1] : 0;
        if (m->kind[i] != MESH_SMOOTH || !(fabs(move) <= MOST * m->h)) continue;
        for (int k = 0; k < 3; k++) m->at[i][k] += move * (double)m->normal[i][k];
    }
    free(b.gap);
    free(sum);
    return done;
}
