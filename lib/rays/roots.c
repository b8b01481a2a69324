/* roots.c - the roots along a ray: first in double, and where that cannot tell, in double-double.
 *
 * Both rounds are the same: expand about the frame, walk the pieces, refine the brackets.  A round in
 * double ends as soon as a cell stays undecided.  What double-double leaves undecided at an end of the
 * ray is looked at once more: there the sign of P is computed exactly, and if it is zero the end is a
 * root and the walk is repeated knowing it. */
#include <float.h>
#include <math.h>

#include "intersect_impl.h"
#include "../roots/isolate_impl.h"
#include "../roots/refine_dd.h"

typedef struct search {
    const algsurf_surface *surface;
    const algsurf_ray *ray;
    const algsurf_intersect_options *options;
    algsurf_i_want want;
    algsurf_i_frame *frame;
    algsurf_i_piece pieces[3];
    int piece_count;
    algsurf_i_ray_root *roots;
    int count, capacity;
} search;

enum outcome { DONE, UNDECIDED, OVERFLOWED };

/* Local variable of a piece to offset from the centre. */
static algsurf_dd offset_of(const search *s, const algsurf_i_piece *piece, algsurf_dd v) {
    if (!piece->far) return algsurf_dd_scale(v, s->frame->step);
    return algsurf_dd_div(algsurf_dd_from(-s->frame->step), v);
}

/* The caller's t of a cell's end, moved outward by more than its rounding: the offset, the sum with the
 * centre and the pad round once each. */
static double t_outward(const search *s, const algsurf_i_piece *piece, algsurf_dd v, int side) {
    const double infinity = side < 0 ? -HUGE_VAL : HUGE_VAL;
    if (piece->far && v.hi == 0) return infinity;
    double size = fmax(fabs(piece->lo.hi), fabs(piece->hi.hi)); /* a cell's end is known to 2^-103 of this */
    double offset = offset_of(s, piece, algsurf_dd_add_d(v, side * 0x1p-100 * size)).hi;
    double pad = 4 * ALGSURF_U * (fabs(s->frame->centre) + fabs(offset));
    double t = ldexp(s->frame->centre + offset + side * pad, -s->frame->exponent);
    return nextafter(t, infinity);
}

static void set_interval(const search *s, const algsurf_i_cell *cell, algsurf_i_ray_root *root) {
    if (cell->kind == ALGSURF_ROOT_EXACT) {
        root->t_lo = root->t_hi = cell->at_lo ? s->ray->t_min : s->ray->t_max;
        return;
    }
    int first = cell->piece == s->pieces, last = cell->piece == s->pieces + s->piece_count - 1;
    root->t_lo =
        first && cell->at_lo ? s->ray->t_min : fmax(s->ray->t_min, t_outward(s, cell->piece, cell->lo, -1));
    root->t_hi =
        last && cell->at_hi ? s->ray->t_max : fmin(s->ray->t_max, t_outward(s, cell->piece, cell->hi, 1));
}

/* Is a cell, or an end of it that is not infinity itself, beyond the largest double?  Others may be there,
 * too. */
static int is_beyond(const algsurf_i_cell *cell, const algsurf_i_ray_root *root) {
    int from_infinity = cell->piece->far && cell->lo.hi == 0,
        to_infinity = cell->piece->far && cell->hi.hi == 0;
    return root->t_lo >= DBL_MAX || root->t_hi <= -DBL_MAX || (isinf(root->t_lo) && !from_infinity) ||
           (isinf(root->t_hi) && !to_infinity);
}

/* Appends a root; when there is no room the last one grows and becomes undecided (the fast tier does
 * not doubt). */
static algsurf_i_ray_root *append(search *s) {
    if (s->count < s->capacity) return s->roots + s->count++;
    algsurf_i_ray_root *last = s->roots + s->count - 1;
    if (s->options->tier == ALGSURF_TIER_FAST) return NULL;
    last->state = ALGSURF_UNCERTAIN;
    last->reason = ALGSURF_UNDECIDED_MULTIPLE;
    return NULL;
}

static void add_root(search *s, const algsurf_i_cell *cell, algsurf_dd v, int polish) {
    algsurf_i_ray_root *root = append(s), here;
    if (!root) {
        set_interval(s, cell, &here);
        s->roots[s->count - 1].t_hi = here.t_hi;
        return;
    }
    root->state = ALGSURF_HIT;
    root->reason = ALGSURF_OK;
    root->polish = polish;
    root->offset = offset_of(s, cell->piece, v);
    set_interval(s, cell, root);
    if (s->options->tier != ALGSURF_TIER_FAST && is_beyond(cell, root)) {
        root->state = ALGSURF_UNCERTAIN;
        root->reason = ALGSURF_UNDECIDED_RANGE;
    }
}

/* Why a cell stays undecided. */
static algsurf_status reason_for(const search *s, const algsurf_i_cell *cell) {
    int begin = cell->at_lo && cell->piece == s->pieces;
    int end = cell->at_hi && cell->piece == s->pieces + s->piece_count - 1;
    if (cell->at_lo && cell->at_hi) return ALGSURF_UNDECIDED_ZERO;
    return begin || end ? ALGSURF_UNDECIDED_END : ALGSURF_UNDECIDED_MULTIPLE;
}

/* Adds an undecided cell, or widens the one before it if they touch.  Returns 0 when the search ends
 * before it: a first root is known already, or where it may be. */
static int add_undecided(search *s, const algsurf_i_cell *cell) {
    algsurf_i_ray_root here = {ALGSURF_UNCERTAIN, reason_for(s, cell), 0, {0, 0}, 0, 0};
    set_interval(s, cell, &here);
    algsurf_dd middle = algsurf_dd_scale(algsurf_dd_add(cell->lo, cell->hi), 0.5);
    here.offset = offset_of(s, cell->piece,
                            isinf(here.t_lo)   ? cell->hi
                            : isinf(here.t_hi) ? cell->lo
                                               : middle);
    if (s->count > 0) {
        algsurf_i_ray_root *last = s->roots + s->count - 1;
        if (last->state == ALGSURF_UNCERTAIN && last->t_hi >= here.t_lo) {
            last->t_hi = here.t_hi;
            return 1;
        }
        if (s->want == ALGSURF_WANT_FIRST) return 0;
    }
    algsurf_i_ray_root *root = append(s);
    if (root)
        *root = here;
    else
        s->roots[s->count - 1].t_hi = here.t_hi;
    return 1;
}

/* The first point from an end of a bracket inward at which Horner's rule gives the sign that the end has; the
 * end itself if no step doubled from a rounding error's length finds one. */
static double end_with_sign(const double *c, int n, double end, double other, int sign) {
    double at = end, step = 0x1p-50 * (other - end);
    for (; fabs(step) < fabs(other - end); step *= 2) {
        double value = c[n];
        for (int k = n - 1; k >= 0; k--) value = value * at + c[k];
        if (sign * value > 0) return at;
        at = end + step;
    }
    return end;
}

/* The root in a bracket found in double.  The signs at the ends are known from the walk; where the computed
 * values disagree, or are zero, next to another root or to this one, the bracket begins where they agree, and
 * if they do nowhere the root is at that end as far as double can tell. */
static double refine_d(const search *s, const double *c, int n, const algsurf_i_cell *cell) {
    algsurf_refine_options options = {sizeof options, s->options->method, s->options->max_iterations, 0};
    double lo = cell->lo.hi, hi = cell->hi.hi, v = fmin(fabs(lo), fabs(hi));
    double tolerance = ldexp(s->options->tolerance, s->frame->exponent) / s->frame->step;
    algsurf_root root;
    /* half the wanted error, for the root is an end of the bracket; dt = dv / v^2 in a far piece */
    options.tolerance = 0.5 * tolerance * (cell->piece->far ? v * v : 1);
    algsurf_status status = algsurf_refine_poly(c, n, lo, hi, &options, &root);
    if (status >= ALGSURF_OK && root.root != lo && root.root != hi) return root.root;
    lo = end_with_sign(c, n, lo, hi, cell->sign);
    hi = end_with_sign(c, n, hi, lo, -cell->sign);
    if (lo < hi && algsurf_refine_poly(c, n, lo, hi, &options, &root) >= ALGSURF_OK) return root.root;
    return fabs(cell->value_lo) < fabs(cell->value_hi) ? lo : hi;
}

static int finite_all(const double *r, int n) {
    for (int i = 0; i <= n; i++)
        if (!isfinite(r[i])) return 0;
    return 1;
}

static enum outcome round_in_double(search *s) {
    double q[ALGSURF_MAX_DEGREE + 1], r[ALGSURF_MAX_DEGREE + 1];
    int n = s->surface->degree, bounded = s->options->tier != ALGSURF_TIER_FAST;
    double X[3] = {s->frame->X[0].hi, s->frame->X[1].hi, s->frame->X[2].hi};
    algsurf_i_walk_d walk;
    algsurf_i_cell cell;
    algsurf_i_expand_d(s->surface, X, s->frame->D, q, bounded ? r : NULL);
    if (!finite_all(q, n) || (bounded && !finite_all(r, n))) return OVERFLOWED;
    while (n > 0 && q[n] == 0 && (!bounded || r[n] == 0)) n--; /* the degree drops in this direction */
    if (n == 0 && q[0] == 0) n = s->surface->degree;           /* the ray lies in the surface */
    algsurf_i_walk_begin_d(&walk, q, bounded ? r : NULL, n, bounded, s->pieces, s->piece_count);
    walk.any = s->want == ALGSURF_WANT_ANY;
    while (algsurf_i_walk_next_d(&walk, &cell)) {
        if (cell.kind == ALGSURF_ROOT_BRACKET && s->want != ALGSURF_WANT_ANY)
            add_root(s, &cell, algsurf_dd_from(refine_d(s, walk.local, n, &cell)),
                     s->options->tolerance == 0);
        else if (cell.kind == ALGSURF_ROOT_UNDECIDED && bounded)
            return UNDECIDED;
        else
            add_root(s, &cell, algsurf_dd_scale(algsurf_dd_add(cell.lo, cell.hi), 0.5), 0);
        if (s->want != ALGSURF_WANT_ALL || s->count == n) break; /* n roots are all of them */
    }
    return DONE;
}

static void keep_only_last(search *s) {
    s->roots[0] = s->roots[s->count - 1];
    s->count = 1;
}

static enum outcome round_in_dd(search *s, int *open_lo, int *open_hi) {
    algsurf_dd q[ALGSURF_MAX_DEGREE + 1];
    double r[ALGSURF_MAX_DEGREE + 1];
    int n = s->surface->degree;
    algsurf_i_walk_dd walk;
    algsurf_i_cell cell;
    s->count = 0;
    *open_lo = *open_hi = 0;
    algsurf_i_expand_dd(s->surface, s->frame->X, s->frame->D, q, r);
    for (int i = 0; i <= n; i++)
        if (!isfinite(q[i].hi) || !isfinite(q[i].lo) || !isfinite(r[i])) return OVERFLOWED;
    if (fabs(q[n].hi) <= r[n] && !s->frame->one_piece && algsurf_i_top_vanishes(s->surface, s->ray)) n--;
    while (n > 0 && q[n].hi == 0 && r[n] == 0) n--;
    if (n == 0 && q[0].hi == 0) n = s->surface->degree;
    algsurf_i_walk_begin_dd(&walk, q, r, n, 1, s->pieces, s->piece_count);
    walk.any = s->want == ALGSURF_WANT_ANY;
    while (algsurf_i_walk_next_dd(&walk, &cell)) {
        if (cell.kind == ALGSURF_ROOT_UNDECIDED) {
            *open_lo |= cell.at_lo && cell.piece == s->pieces;
            *open_hi |= cell.at_hi && cell.piece == s->pieces + s->piece_count - 1;
            if (!add_undecided(s, &cell)) break;
            continue; /* the next cell may touch this one, and any certain hit settles WANT_ANY */
        }
        if (s->want == ALGSURF_WANT_FIRST && s->count > 0) break;
        if (cell.kind == ALGSURF_ROOT_EXACT || s->want == ALGSURF_WANT_ANY)
            add_root(s, &cell, cell.lo, 0);
        else
            add_root(s, &cell, algsurf_i_refine_dd(walk.local, n, cell.lo, cell.hi, cell.sign), 0);
        if (s->want == ALGSURF_WANT_ANY) keep_only_last(s);
        if (s->want != ALGSURF_WANT_ALL) break;
    }
    return DONE;
}

/* Is an end of the ray, finite, exactly a root? */
static int end_is_root(const search *s, double t) {
    return isfinite(t) && algsurf_i_exact_sign(s->surface, s->ray, t) == 0;
}

/* A linear polynomial that is zero at an end, and not everywhere, has no other root. */
static int settle_linear(search *s, int at_lo) {
    const algsurf_i_piece *piece = at_lo ? s->pieces : s->pieces + s->piece_count - 1;
    const algsurf_i_cell end = {.piece = piece, .kind = ALGSURF_ROOT_EXACT, .at_lo = at_lo, .at_hi = !at_lo};
    double t = at_lo ? s->ray->t_min : s->ray->t_max;
    int elsewhere = s->surface->degree == 1 ? algsurf_i_exact_sign(s->surface, s->ray, t == 0 ? 1 : -t) : 0;
    if (elsewhere != 1 && elsewhere != -1) return 0;
    s->count = 0;
    add_root(s, &end, at_lo ? piece->lo : piece->hi, 0);
    return 1;
}

static void whole_ray_undecided(search *s, algsurf_status reason) {
    algsurf_dd middle = algsurf_dd_from(0);
    s->roots[0] = (algsurf_i_ray_root){ALGSURF_UNCERTAIN, reason, 0, middle, s->ray->t_min, s->ray->t_max};
    s->count = 1;
}

/* A ray of no length: one point, decided by its value if that is clear of its bound, else exactly. */
static int single_point(search *s) {
    algsurf_dd q[ALGSURF_MAX_DEGREE + 1];
    double r[ALGSURF_MAX_DEGREE + 1];
    algsurf_i_expand_dd(s->surface, s->frame->X, s->frame->D, q, r);
    if (!s->frame->lost && isfinite(q[0].hi) && isfinite(r[0]) && fabs(q[0].hi) > r[0]) return 0;
    int sign = algsurf_i_exact_sign(s->surface, s->ray, s->ray->t_min);
    algsurf_dd here = algsurf_dd_from(0);
    double t = s->ray->t_min;
    if (sign == 1 || sign == -1) return 0;
    algsurf_status reason = s->surface->error > 0 ? ALGSURF_UNDECIDED_ZERO : ALGSURF_UNDECIDED_RANGE;
    s->roots[0] = sign == 0 ? (algsurf_i_ray_root){ALGSURF_HIT, ALGSURF_OK, 0, here, t, t}
                            : (algsurf_i_ray_root){ALGSURF_UNCERTAIN, reason, 0, here, t, t};
    return 1;
}

int algsurf_i_ray_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                        const algsurf_intersect_options *options, algsurf_i_want want, algsurf_i_frame *frame,
                        algsurf_i_ray_root *roots, int capacity) {
    search s = {surface, ray, options, want, frame, {{0, {0, 0}, {0, 0}, 0, 0}}, 0, roots, 0, capacity};
    int open_lo, open_hi;
    if (surface->degree == 1 && want == ALGSURF_WANT_FIRST)
        s.want = ALGSURF_WANT_ALL; /* one entry in any case */
    algsurf_i_frame_of(surface, ray, 0, frame);
    if (ray->t_min == ray->t_max) return isfinite(ray->t_min) ? single_point(&s) : 0;
    s.piece_count = algsurf_i_cut_line(frame->lo, frame->hi, s.pieces);
    enum outcome outcome = frame->lost ? OVERFLOWED : round_in_double(&s);
    if (outcome == UNDECIDED)
        outcome = round_in_dd(&s, &open_lo, &open_hi);
    else
        open_lo = open_hi = 0;
    if (outcome == OVERFLOWED) whole_ray_undecided(&s, ALGSURF_UNDECIDED_RANGE);
    if (outcome == DONE && (open_lo || open_hi)) {
        int zero_lo = open_lo && end_is_root(&s, ray->t_min),
            zero_hi = open_hi && end_is_root(&s, ray->t_max);
        s.pieces[0].zero_at_lo = zero_lo;
        s.pieces[s.piece_count - 1].zero_at_hi = zero_hi;
        if ((zero_lo || zero_hi) && !settle_linear(&s, zero_lo)) (void)round_in_dd(&s, &open_lo, &open_hi);
    }
    return s.count;
}
