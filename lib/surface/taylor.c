/* taylor.c - P in the caller's axes, in the unit of what is shown, once a frame.
 *
 * A segment is x + t d, 0 <= t <= 1; x is (X - centre) / size for a point X of doubles, in natural units,
 * which are exact, as the centre is; d is size's part of a direction of doubles, times how much of it there
 * is.
 *
 * Errors.  Let S(x,y,z) = sum |q_ijk| x^i y^j z^k.  Take absolute values everywhere: what all q_ijk
 * contribute to a coefficient of the segment, however they are split up on their way, adds up to S(|x_1| +
 * |d_1|, |x_2| + |d_2|, |x_3| + |d_3|) at most, and to S(|x_1|, |x_2|, |x_3|) for the first one, P at the
 * point.  On that way q meets these roundings:
 * - 1 of its own;
 * - 3 for each coordinate x_k, a difference, the inverse of size, a product, and 3 for each d_k, a quotient
 * and two products: 3n;
 * - 2n in the shift of each coordinate by x, a product and a sum each: 6n;
 * - n for a power of d_3, and a product; 2n in the steps by d_2, a product and a sum each, 2n in those by
 * d_1;
 * - n + 2 in the basis: its entry, the product, n sums.
 * Together 15 n + 4.  The weight 16 (n + 1) takes in the higher orders.
 */
#include "../base/arithmetic.h"
#include "taylor.h"

#include "../base/eft.h"

#define LOST_BY_UNDERFLOW 0x1p-500 /* far more than is lost by it */

void algsurf_i_taylor_expand(const algsurf_surface *s, algsurf_i_taylor *taylor, void *memory) {
    algsurf_i_view *view = &taylor->frame.view;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) view->axis[k][i] = i == k;
    view->alpha = view->beta[0] = view->beta[1] = view->noise = 0;
    taylor->usable = !(s->error > 0) && algsurf_i_frame_expand(s, &taylor->frame, memory);
    if (!taylor->usable) return;
    taylor->weight = 16 * (s->degree + 1) * ALGSURF_U;
    taylor->least_error = taylor->frame.error + LOST_BY_UNDERFLOW;
    double choose = 1; /* an exact integer */
    for (int k = 0; k <= s->degree; k++) {
        taylor->inverse[k] = 1 / choose;
        choose = choose * (s->degree - k) / (k + 1);
    }
}
