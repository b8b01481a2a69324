/* beam.c - P in (u,v,z) once a frame, and about a row of tiles.
 *
 * Frame.  With x = u (1 + alpha z) + beta_0 z and y likewise, q_ij(z) x^i y^j is made in three steps:
 * Taylor's shift by beta_0 z in x and by beta_1 z in y, a factor (1 + alpha z)^(i+j), and Bernstein's basis
 * over -1 <= z <= 1.  A row of tiles is a shift by v_c in v and a factor h_v^j.
 *
 * Errors.  Take absolute values everywhere, as for a row of pixels (view.c): what q_ijk x^i y^j z^k
 * contributes to a coefficient b_k of a ray of the tile, however it is split up on its way, is at most
 * |q_ijk| X^i Y^j with X = U (1 + |alpha|) + |beta_0|, U the largest |u| of the tile, and Y likewise.  On
 * that way it meets these roundings:
 * - 1 of q;
 * - 2n + 2n in the shifts by beta z, n products and n sums each;
 * - 2n in the factors 1 + alpha z, a product and a sum each, i + j <= n of them;
 * - n + 2 in the basis: its entry, the product, n sums;
 * - 2n + n for v, the shift and the powers of h_v; 2n + n for u;
 * - 6n in a tile's cut to its chords;
 * - 5 (5n + 1) in up to five cells within cells;
 * - 6n in a cell cut from the tile for itself;
 * - 9 in the sums that make a range of the T.
 * Together less than 50 n + 17, each of relative size u.  Sizes of terms that become radii meet the same cuts
 * and sums once more, 31 n + 14, and are at most that bound themselves.  A depth is recorded but for 2^-51 of
 * where the cut was made, up to six times, which moves b_k by at most n 2^-51 of the bound each time, as
 * |dp/dz| <= n max|b_k|: 24 n.  The weight 112 (n + 1) takes all that in, with its higher orders.  Half sizes
 * are taken a little too large (picture/tiles.c), which takes in the rounding of u and v.
 *
 * Noise and errors of the surface's coefficients are those of a row of pixels, for the tile's X and Y.
 */
#include "../base/arithmetic.h"
#include "beam.h"

#include <math.h>
#include <string.h>

enum { SIDE = ALGSURF_MAX_VIEW_DEGREE + 1 };

/* to += factor from, for so many coefficients. */
static void add_multiple(double *to, const double *from, double factor, int count) {
    for (int k = 0; k < count; k++) to[k] += factor * from[k];
}

/* p_0 .. p_count, polynomials in z at multiples of `apart`, as coefficients of powers of x, become those of
 * powers of x - beta z; p_i has degree length - i at most. */
static void shift_by_depth(double *p, size_t apart, int count, int length, double beta) {
    if (beta == 0) return;
    for (int m = 0; m < count; m++)
        for (int i = count - 1; i >= m; i--)
            add_multiple(p + (size_t)i * apart + 1, p + (size_t)(i + 1) * apart, beta, length - i);
}

/* Powers of z, times (1 + alpha z)^times, to Bernstein's basis. */
static void finish_depth(const algsurf_i_frame_form *frame, int times, double *g) {
    int n = frame->degree;
    double power[SIDE];
    for (int t = 0; t < times; t++)
        for (int k = n; k > 0; k--) g[k] += frame->view.alpha * g[k - 1];
    memcpy(power, g, (size_t)(n + 1) * sizeof *power);
    for (int j = 0; j <= n; j++) {
        double sum = power[0];
        for (int k = 1; k <= n; k++) sum += frame->basis[j * (n + 1) + k] * power[k];
        g[j] = sum;
    }
}

void algsurf_i_beam_expand(const algsurf_i_frame_form *frame, double *g) {
    int n = frame->degree;
    size_t side = (size_t)n + 1;
    memcpy(g, frame->q, side * side * side * sizeof *g);
    for (int j = 0; j <= n; j++)
        shift_by_depth(g + (size_t)j * side, side * side, n - j, n - j, frame->view.beta[0]);
    for (int i = 0; i <= n; i++)
        shift_by_depth(g + (size_t)i * side * side, side, n - i, n - i, frame->view.beta[1]);
    for (int i = 0; i <= n; i++)
        for (int j = 0; i + j <= n; j++)
            finish_depth(frame, i + j, g + ((size_t)i * side + (size_t)j) * side);
}

/* row->beyond.  T_k,ij = h_u^i sum over m >= i of C(m,i) c_kjm u^(m-i); the sizes of c are taken at their
 * largest of all k. */
static void bound_beyond(algsurf_i_beam_row *row) {
    int n = row->degree;
    memset(row->beyond, 0, sizeof row->beyond);
    for (int j = 0; j <= n; j++)
        for (int m = 0; j + m <= n; m++) {
            double most = 0, choose = 1, power = 1; /* C(m,i), h_u^i */
            if (j + m <= ALGSURF_I_BEAM_ORDER) continue;
            for (int k = 0; k <= n; k++) most = fmax(most, fabs(row->c[(k * (n + 1) + j) * (n + 1) + m]));
            for (int i = 0; i <= m; i++) {
                if (i + j > ALGSURF_I_BEAM_ORDER) row->beyond[m - i] += choose * power * most;
                choose = choose * (m - i) / (i + 1);
                power *= row->hu;
            }
        }
}

void algsurf_i_beam_row_expand(const algsurf_i_frame_form *frame, const double *g, double v, double h,
                               double hu, double *memory, algsurf_i_beam_row *row) {
    int n = frame->degree;
    size_t side = (size_t)n + 1;
    const algsurf_i_view *view = &frame->view;
    row->degree = n;
    row->v = v;
    row->h = h;
    row->hu = fabs(hu);
    for (int i = 0; i <= n; i++) {
        double power = 1;
        memcpy(memory, g + (size_t)i * side * side, side * side * sizeof *memory);
        for (int m = 0; m < n - i; m++)
            for (int j = n - i - 1; j >= m; j--)
                add_multiple(memory + (size_t)j * side, memory + (size_t)(j + 1) * side, v, n + 1);
        for (int j = 0; i + j <= n; j++, power *= h)
            for (int k = 0; k <= n; k++)
                row->c[((size_t)k * side + (size_t)j) * side + (size_t)i] =
                    power * memory[(size_t)j * side + (size_t)k];
    }
    bound_beyond(row);
    double most = fabs(v) + fabs(h);
    algsurf_i_view_radius(frame, most + fabs(view->alpha) * most + fabs(view->beta[1]) + view->noise, 0,
                          112 * (n + 1), row->radius);
}
