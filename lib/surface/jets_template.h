/* jets_template.h - P and its gradient at the points of one or two packets: LANES points each.
 *
 * The nested Horner scheme of eval.c.  Three things make it shorter here: a sum starts at its first
 * coefficient instead of at zero; where P has only even powers of a coordinate, as symmetric surfaces have,
 * the scheme runs in its square; and two packets go through it side by side, which share its loads and its
 * loops. */
#ifndef ALGSURF_JETS_TEMPLATE_H
#define ALGSURF_JETS_TEMPLATE_H
#include "../simd/lanes.h"
#include "impl.h"

/* One or two packets of values of a polynomial, and of its derivatives by x, y, z, or by their squares. */
typedef struct jets {
    lanes v[PAIR], x[PAIR], y[PAIR], z[PAIR];
} jets;

INLINE jets row_jets(const algsurf_surface *s, const algsurf_row *row, const lanes x[PAIR], int packets) {
    jets r;
    const double *c = s->coef + row->first;
    int i = row->length - 1, stride = s->stride[0];
    for (int w = 0; w < packets; w++) {
        r.v[w] = r.x[w] = all_lanes(0);
        if (i >= 0) r.v[w] = all_lanes(c[i]);
    }
    for (i -= stride; i >= 0; i -= stride)
        for (int w = 0; w < packets; w++) {
            r.x[w] = r.x[w] * x[w] + r.v[w];
            r.v[w] = r.v[w] * x[w] + all_lanes(c[i]);
        }
    return r;
}

INLINE jets level_jets(const algsurf_surface *s, const algsurf_level *level, const lanes x[PAIR],
                       const lanes y[PAIR], int packets) {
    const algsurf_row *row = s->rows + level->first, empty = {0, 0};
    int j = level->count - 1, stride = s->stride[1];
    jets p = row_jets(s, j >= 0 ? row + j : &empty, x, packets);
    for (int w = 0; w < packets; w++) p.y[w] = all_lanes(0);
    for (j -= stride; j >= 0; j -= stride) {
        jets r = row_jets(s, row + j, x, packets);
        for (int w = 0; w < packets; w++) {
            p.x[w] = p.x[w] * y[w] + r.x[w];
            p.y[w] = p.y[w] * y[w] + p.v[w];
            p.v[w] = p.v[w] * y[w] + r.v[w];
        }
    }
    return p;
}

/* P and its gradient. */
INLINE jets surface_jets(const algsurf_surface *s, lanes at[PAIR][3], int packets) {
    lanes power[3][PAIR];
    for (int i = 0; i < 3; i++)
        for (int w = 0; w < packets; w++) power[i][w] = s->stride[i] == 2 ? at[w][i] * at[w][i] : at[w][i];
    int k = s->level_count - 1, stride = s->stride[2];
    jets p = level_jets(s, s->levels + k, power[0], power[1], packets);
    for (int w = 0; w < packets; w++) p.z[w] = all_lanes(0);
    for (k -= stride; k >= 0; k -= stride) {
        jets level = level_jets(s, s->levels + k, power[0], power[1], packets);
        for (int w = 0; w < packets; w++) {
            lanes z = power[2][w];
            p.x[w] = p.x[w] * z + level.x[w];
            p.y[w] = p.y[w] * z + level.y[w];
            p.z[w] = p.z[w] * z + p.v[w];
            p.v[w] = p.v[w] * z + level.v[w];
        }
    }
    for (int w = 0; w < packets; w++) {
        if (s->stride[0] == 2) p.x[w] *= 2 * at[w][0];
        if (s->stride[1] == 2) p.y[w] *= 2 * at[w][1];
        if (s->stride[2] == 2) p.z[w] *= 2 * at[w][2];
    }
    return p;
}

#endif
