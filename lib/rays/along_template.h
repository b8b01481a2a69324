/* along_template.h - P along the chords of LANES rays, and its first roots (roots/first_walk_template.h).
 *
 * The chord [near, far] has the middle t_c and half the length h, both doubles; its points are
 * X(v) = (o + t_c d) + v (h d), -1 <= v <= 1, where the middle M = o + t_c d comes from double-double: a far
 * origin costs no digits.
 *
 * Two ways lead to Bernstein coefficients.  Up to ALGSURF_MAX_NODE_DEGREE P is evaluated at nodes
 * (nodes_template.h).  Lanes that this leaves undecided, and all lanes of higher degrees, take powers of v
 * (powers_template.h) and a radius for each coefficient (roots/descartes_template.h): the nodes' matrix
 * amplifies rounding by a factor that doubles with each degree, powers do not.
 *
 * Rounding of M.  It is within u |M| and 2^-100 (|o| + |t_c d|) of the point.  As blur is below 2^-16, |t_c|
 * is below 2^36 h, so the latter is less than 2^-63 (|M| + |h d|).
 *
 * Error of the ends.  The computed chord is within `off` of the exact one, t_c - h and t_c + h within
 * u (|t_c| + h) of the computed one.  The sum goes to packet.blur: where p keeps its sign that far about both
 * ends, both chords have the same roots.  Where it grows all along, on the wanted side of the surface, roots
 * there do not count (first_walk_template.h, Sides). */
#ifndef ALGSURF_RAYS_ALONG_TEMPLATE_H
#define ALGSURF_RAYS_ALONG_TEMPLATE_H
#include "packets.h"
#define SIDED 1
#if LANES > 4
#define MOST_DEGREE ALGSURF_MAX_WIDE_DEGREE
#endif
#include "../roots/first_walk_template.h"
#include "../simd/lanes.h"
#include "chord_template.h"
#include "nodes_template.h"
#include "powers_template.h"

#define MOST_BLUR 0x1p-16 /* above, the bound on p' holds no more */

#define NODE_DEGREES(statement)                                                                              \
    DEGREES_2_TO_4(statement)                                                                                \
    FOR_ONE_DEGREE(6, statement) FOR_ONE_DEGREE(8, statement) FOR_ONE_DEGREE(10, statement)

INLINE void coefficients(const algsurf_surface *s, const chord_line *line, int alone, lanes *b, int n) {
    if (alone)
        coefficients_of_one(s, line->middle, line->half, b, n);
    else
        coefficients_from_nodes(s, line->middle, line->half, b, n);
}

/* b from nodes, and one radius for all of them. */
APART void set_coefficients(const algsurf_i_rays_job *job, const chord_line *line, packet *k, int n) {
    const algsurf_surface *s = job->surface;
    const int alone = LANES == 2 && job->rays->count == 1;
    lanes reach[3];
    if (n > ALGSURF_MAX_NODE_DEGREE) __builtin_unreachable();
    FOR_DEGREES(COMMON_DEGREES, n, coefficients(s, line, alone, k->b, N),
                NODE_DEGREES(coefficients(s, line, alone, k->b, N)))
    for (int i = 0; i < 3; i++) reach[i] = absolute(line->middle[i]) + absolute(line->half[i]);
    double factor = (10 * n + 20) * 0x1p-53 + s->error;
    k->e[0] = factor * s->amplification * surface_magnitude(s, reach) + LOST_BY_UNDERFLOW;
}

/* The chords of open lanes, which [0,1] stands for; those that are too long or too blurred are undecided. */
INLINE void set_chords(const algsurf_i_rays_job *job, const ray_lanes *r, chord_line *line, packet *k) {
    lanes reach[3];
    for (int i = 0; i < 3; i++) {
        line->middle[i] = along(r->origin[i], all_lanes(0), line->t_c, r->direction[i]);
        line->half[i] = line->h * r->direction[i];
        reach[i] = absolute(line->middle[i]) + absolute(line->half[i]);
    }
    k->blur = (r->off + 0x1p-52 * (absolute(line->t_c) + line->h)) / absolute(line->h);
    k->undecided |= k->open & ~less(largest_size(reach), all_lanes(job->surface->most_reach));
    k->undecided |= k->open & ~less(k->blur, all_lanes(MOST_BLUR));
    k->open &= ~k->undecided;
    k->start = all_lanes(-1); /* all of [0,1] is searched, and solve_chords looks at its ends */
    k->stop = all_lanes(2);
}

/* What p changes by within blur of an end where the last coefficients are b, then next, known to e, next_e.
 * There p' = n sum B_j(x) (b_(j+1) - b_j) with |x| <= blur < 2^-16: the first B is below 1 + 2^-10 and the
 * others together below 2 n blur. */
INLINE lanes change_at_end(const packet *k, int n, lanes b, lanes next, lanes e, lanes next_e) {
    lanes slope = absolute(next - b) + (e + next_e) + 4 * n * k->blur * k->largest;
    return (1 + 0x1p-9) * n * k->blur * slope;
}

/* Where a side is wanted: of `which` lanes, of which p's sign where the chord begins is not known, those that
 * grow on that side within blur of there: p' > 0 follows as in change_at_end.  The first coefficient is moved
 * to 0 if it is below, and its radius grows by that; so the control polygon has no dip before the second one,
 * which is surely above 0. */
APART void loosen(packet *k, mask which, int n, int own) {
    cell *c = &k->at;
    const words turn = (words)all_lanes(k->wanted < 0 ? -0.0 : 0.0);
    const lanes e = radius_of(k->e, 1, own), second = (lanes)((words)k->b[1] ^ turn);
    const lanes grown = (lanes)((words)(k->b[1] - k->b[0]) ^ turn);
    const lanes unknown = k->e[0] + e + 4 * n * k->blur * k->largest;
    k->loose = which & less((1 + 0x1p-9) * unknown, grown) & less(e, second);
    const words flip = (words)choose(k->loose, (lanes)(c->side ^ turn), all_lanes(0));
    c->side ^= flip;
    for (int j = 0; j <= n; j++) c->w[j] = (lanes)((words)c->w[j] ^ flip);
    const lanes below = choose(k->loose, larger(-c->w[0], all_lanes(0)), all_lanes(0));
    c->w[0] = choose(k->loose, larger(c->w[0], all_lanes(0)), c->w[0]);
    c->e[0] += (1 + 0x1p-50) * below;
    k->s = count_signs(c->w, c->e, n, own);
    k->s.one &= ~k->loose;
}

/* The first roots of open lanes; for `any` a change of sign from end to end is enough.  Undecided are those
 * whose sign at an end of the chord is not known. */
INLINE void solve_chords(const algsurf_i_rays_job *job, packet *k, int n, int own) {
    const lanes *b = k->b, *e = k->e;
    cell *c = &k->at;
    begin(k, n, own);
    if (watch_of(k)) tell_cell(k->watch, 0, 1, c->w, c->e, n, own, c->side[0] != 0);
    bound_errors(k, n, own);
    lanes near = e[0], far = radius_of(e, n, own);
    near += change_at_end(k, n, b[0], b[1], e[0], radius_of(e, 1, own));
    far += change_at_end(k, n, b[n], b[n - 1], far, radius_of(e, n - 1, own));
    mask known = less(near, absolute(b[0]));
    k->wanted = job->side;
    k->loose = no_lane();
    if (k->wanted && any(k->open & ~known)) loosen(k, k->open & ~known, n, own);
    leave_undecided(k, ~((known | k->loose) & less(far, absolute(b[n]))));
    k->open &= ~k->s.none;
    if (job->any) {
        k->hit = k->open & negative((words)c->w[n]) & ~off_side(k);
        k->open &= ~k->hit;
    }
    if (!any(k->open)) return;
    if (own)
        isolate_known(k, n);
    else
        isolate(k, n);
}

/* By powers, with a radius for each coefficient. */
APART void decide_from_powers(const algsurf_i_rays_job *job, const chord_line *line, packet *k, int n) {
    if (n < 1 || n > MOST_DEGREE) __builtin_unreachable();
    coefficients_from_powers(job->surface, line, n, k->b, k->e);
    solve_chords(job, k, n, 1);
}

/* Lanes that nodes and one radius for all coefficients left undecided. */
APART void decide_again(const algsurf_i_rays_job *job, const chord_line *line, packet *k, mask which, int n) {
    packet again;
    again.watch = k->watch;
    again.open = which;
    again.undecided = no_lane();
    again.start = k->start;
    again.stop = k->stop;
    again.blur = k->blur;
    decide_from_powers(job, line, &again, n);
    k->undecided = (k->undecided & ~which) | again.undecided;
    k->b[n] = choose(which, again.b[n], k->b[n]);
    close(k, n, again.hit, &again.at);
}

INLINE void decide_from_nodes(const algsurf_i_rays_job *job, const chord_line *line, packet *k, int n) {
    mask opened = k->open;
    set_coefficients(job, line, k, n);
    solve_chords(job, k, n, 0);
    mask again = opened & k->undecided;
    if (any(again)) decide_again(job, line, k, again, n);
}

/* Of a single ray, the first lane's: t along its chord; null where nobody looks. */
INLINE const algsurf_i_watch *watch_chord(const algsurf_i_rays_job *job, const ray_lanes *r,
                                          algsurf_i_watch *watch) {
    if (LANES != 2 || !job->observer) return NULL;
    *watch = (algsurf_i_watch){.observer = job->observer,
                               .lo = r->near[0] * r->t_unit[0],
                               .hi = r->far[0] * r->t_unit[0],
                               .exponent = -job->surface->scale};
    return watch;
}

/* The first roots along the rays' parts; returns the lanes whose chords were searched. */
INLINE mask search(const algsurf_i_rays_job *job, const ray_lanes *r, algsurf_i_watch *watch,
                   chord_line *line, packet *k, int n) {
    line->t_c = 0.5 * r->near + 0.5 * r->far;
    line->h = 0.5 * r->far - 0.5 * r->near;
    k->watch = watch_chord(job, r, watch);
    k->open = r->open;
    k->undecided = r->undecided;
    k->hit = no_lane();
    if (any(k->open)) set_chords(job, r, line, k);
    const mask opened = k->open;
    if (!any(opened)) return opened;
    if (!job->surface->nodes)
        decide_from_powers(job, line, k, n);
    else
        decide_from_nodes(job, line, k, n);
    return opened;
}

#endif
