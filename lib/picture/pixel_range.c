/* pixel_range.c - the pixels of a row whose rays may meet the ball about what is shown.
 *
 * The rays of a row lie in the plane y = v + b z.  With m^2 = 1 + b^2 it cuts the ball of radius 1 about the
 * view's centre in a disc: h = |v| / m away from the ball's centre, the disc's centre at x = 0 and
 * z_c = -v b / m^2, its radius rho, rho^2 = 1 - h^2.  The line x = u + a z of that plane passes the disc's
 * centre at the signed distance
 *     d = (u + a z_c) / sqrt(1 + a^2 / m^2),
 * positive on the right, where pixels have larger numbers.
 *
 * Proof of a miss.  If d > rho, the disc lies on the left of the line.  A pinhole's rays leave from one
 * point, parallel rays never cross: so each ray of a pixel further right lies on the right of this line,
 * from the eye onwards, and misses too.  The same holds with left for right.  One line proves the misses of
 * all pixels on one side of it, wherever the eye is: before, in, beside or behind the ball.  The ends of the
 * range are guessed from a quadratic equation.  Nothing is assumed of the guess: the ends move outward until
 * their lines prove them, and without a proof the range goes to the end of the row.
 *
 * Roundings.  N = view->noise is at least 4u and below 2^-22.  Ideal rays start at the exact eye and have the
 * exact slopes of their pixels: they are the pencil of the proof.
 * - The numbers computed for u, a, v, b are within N of the ideal ray's (view.c).  Therefore u + a z_c
 *   is off by N + N |z_c|, and by N (|b| + |v|) / m times |a| / m through z_c; the root by 2 N of itself;
 *   h by 2 N.  Here |v| / m and |z_c| are at most 1 + 2^-15: otherwise no ray meets the ball, see below.
 * - Computing z_c and a z_c takes five roundings, 5u |a z_c|, at most 5u |b| times the root, and 4u |b| < N.
 *   All else takes fewer than eight, at most 2 N d.  With d = rho <= 1 + 2^-15 the sum of all this is below
 *   (2 + 2 + 2 + 5/4 + 2) N < 10 N in d, and 3 N in h.
 * - Where d > rho with rho^2 = 1 + MARGIN - h^2 as computed, the square of the ideal line's distance from the
 *   ball's centre is at least 1 + MARGIN - 2 (10 N rho + 3 N h) > 1 + MARGIN - 27 N > 1 + MARGIN - 2^-17.
 *   So the line misses the ball of radius 1, and so do the ideal rays beyond it.  It passes on the side that
 *   d says, as rho is never taken below 2^-10, which is more than 10 N.
 * - A point of a pixel's own ray is within N of the ideal one's in each of x, y, z, and what is shown is in
 *   a ball of radius (1 + 2^-45) / (1 + 2^-20) < 1 - sqrt(3) N: its size is rounded, and the axes are
 *   orthonormal to 2^-48.  Hence the pixel's own ray misses what is shown.
 * - Where h^2 > 1 + MARGIN, or the eye's depth is above 1 + MARGIN, no ray of the row meets the ball.
 * - NaN and infinity prove nothing.
 * MARGIN is eight times what is needed, and widens a range of 1000 pixels by 1/30 of one. */
#include "../base/arithmetic.h"
#include "packets.h"

#include <math.h>

#define MARGIN 0x1p-14
#define LEAST_SQUARE 0x1p-20 /* of the disc's radius */
#define SPARE 2              /* pixels added to each end of the guess: its first line is to prove it */

/* The disc in which the row's plane cuts the ball. */
typedef struct row_disc {
    double z, square; /* of its centre; of its radius */
    double m2;        /* 1 + b^2 */
} row_disc;

/* Returns 0 when no ray of the row meets the ball. */
static int set_disc(const algsurf_i_row_job *job, row_disc *disc) {
    double v = job->row->v, b = job->slope;
    disc->m2 = 1 + b * b;
    disc->z = -(v * b) / disc->m2;
    double square = 1 + MARGIN - v * v / disc->m2;
    disc->square = fmax(square, LEAST_SQUARE);
    return !(square < 0 || job->near > 1 + MARGIN);
}

/* Does the line of pixel x pass the disc on that side, -1: left, 1: right?  Then so do all beyond it. */
static int passes(const algsurf_i_row_job *job, const row_disc *disc, int x, int side) {
    double u = job->u0 + job->du * ((x + job->offset) * job->pixel);
    double a = job->view->alpha * u + job->view->beta[0], d = side * (u + a * disc->z);
    return d > 0 && d * d > disc->square * (1 + a * a / disc->m2);
}

/* Where lines touch the disc: (d0 + d1 x)^2 = rho^2 + (r0 + r1 x)^2.  The discriminant is written as a sum,
 * so that it does not cancel while there are two ends. */
static void guess_ends(const algsurf_i_row_job *job, const row_disc *disc, double ends[2]) {
    double alpha = job->view->alpha, rise = sqrt(disc->square / disc->m2);
    double u0 = job->u0 + job->du * (job->offset * job->pixel), u1 = job->du * job->pixel;
    double a0 = alpha * u0 + job->view->beta[0], a1 = alpha * u1;
    double d0 = u0 + a0 * disc->z, d1 = u1 + a1 * disc->z, r0 = rise * a0, r1 = rise * a1;
    double lead = (d1 - r1) * (d1 + r1), cross = r0 * d1 - r1 * d0;
    double middle = (r0 * r1 - d0 * d1) / lead, half = sqrt(cross * cross + disc->square * lead) / lead;
    ends[0] = lead > 0 ? floor(middle - half) : -INFINITY;
    ends[1] = lead > 0 ? ceil(middle + half) : INFINITY;
}

/* From pixel `guess` on, whatever number that is: a pixel that passes on that side; -1 or width if none was
 * found.  The steps double: a wrong guess costs few lines. */
static int proved_end(const algsurf_i_row_job *job, const row_disc *disc, double guess, int side, int width) {
    int x = (int)fmin(fmax(guess, side < 0 ? -1 : 0), side < 0 ? width - 1 : width);
    for (int step = side; x >= 0 && x < width; x += step, step *= 2)
        if (passes(job, disc, x, side)) return x;
    return side < 0 ? -1 : width;
}

void algsurf_i_packets_range(const algsurf_i_row_job *job, int width, int *begin, int *end) {
    row_disc disc;
    double ends[2];
    *begin = *end = 0;
    if (!set_disc(job, &disc)) return;
    guess_ends(job, &disc, ends);
    *begin = proved_end(job, &disc, ends[0] - SPARE, -1, width) + 1;
    *end = proved_end(job, &disc, ends[1] + SPARE, 1, width);
    if (*end < *begin) *end = *begin;
}
