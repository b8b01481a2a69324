/* complex_ray.c - the first hit in complex space: all roots, proved, and the least in the sector.
 *
 * The ray polynomial is expanded about the frame's centre with its radii, like in real space; the
 * imaginary parts, given for powers of the caller's t, are brought to the frame's variable v by
 * Horner's rule over polynomials.  The enclosures of the roots v are shifted back, s = centre + step v
 * (outward), before magnitude and argument are looked at: both refer to the eye.  Without imaginary parts
 * the polynomial is real, radii included; with them no root is proved real by symmetry, nor two conjugates,
 * however small they are.
 *
 * Range.  The ends of the chord are rounded, so there are two: one that holds all of the ray's part in the
 * region, and one that is certainly in it (ray.c).  A root with a magnitude in the first counts if it is
 * in the second, too.  Between them a real root in front of the eye is decided by integers, as in real
 * space (exact_ray.c): those roots of P that are in the root's box are inside the region, or not.  Other
 * roots stay undecided there: their magnitudes are no places of the surface.
 *
 * The normal.  Let the direction vary by dV at a fixed origin.  With g the complex gradient at the root and
 * p' = dp/dt, the root moves by dt = -t (g.dV)/p', its magnitude by -|t| w.dV, w = Re(g/p'), and the
 * point shown by dX = |t| (dV - (w.dV) V).  So the normal is w + (1 - w.V)/(V.V) V; for a real root
 * w.V = 1, and it is the gradient's direction. */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>

#include "../complex/impl.h"
#include "../base/fpenv.h"
#include "exact_ray.h"
#include "expand_impl.h"
#include "intersect_impl.h"
#include "../base/options.h"
#include "../poly/interval_impl.h"
#include "../base/vec.h"

typedef struct complex_query {
    const algsurf_surface *surface;
    const algsurf_complex_space *space;
    const algsurf_i_region *region;
    algsurf_ray front, ray; /* from the eye on, and on its chord */
    algsurf_i_chord chord;
    algsurf_i_frame frame;
    algsurf_complex c[ALGSURF_MAX_DEGREE + 1]; /* p in v, natural scale */
    double r[ALGSURF_MAX_DEGREE + 1];
    int real;           /* no imaginary part is given */
    int without_memory; /* receives 1: some step of it was */
} complex_query;

/* Underflow takes at most 2^-1075 from a number: a quarter of u times this. */
#define UNDERFLOW_SIZE 0x1p-1020

/* The size of a product a b >= 0, by which its rounding error is bounded. */
static double product_size(double a, double b) {
    double size = a * b;
    return size < 0x1p-960 && a != 0 && b != 0 ? size + UNDERFLOW_SIZE : size;
}

/* The same of y, which is x 2^e after rounding. */
static double scaled_size(double x, int e, double y) {
    return ldexp(y, -e) == x ? fabs(y) : fabs(y) + UNDERFLOW_SIZE;
}

/* Adds the imaginary part: sum_k imaginary_k t^k, t = (centre + step v) 2^-exponent, in the surface's scale.
 * The error of a step of Horner's rule: u of the size for its products, u for its sum, u/4 for underflow, and
 * a little as the size is rounded itself.  So 4u a step, and 4u for the last coefficient. */
static void add_imaginary(complex_query *q) {
    const algsurf_i_frame *f = &q->frame;
    const int top = algsurf_i_top_imaginary(q->space, q->surface->degree);
    double value[ALGSURF_MAX_DEGREE + 1] = {0}, size[ALGSURF_MAX_DEGREE + 1] = {0}, far = fabs(f->centre);
    q->real = top < 0;
    for (int k = top; k >= 0; k--) {
        int e = q->surface->scale - k * f->exponent;
        double a = ldexp(q->space->imaginary[k], e);
        for (int i = top - k; i > 0; i--) {
            value[i] = f->centre * value[i] + f->step * value[i - 1];
            size[i] = product_size(far, size[i]) + product_size(f->step, size[i - 1]);
        }
        value[0] = f->centre * value[0] + a;
        size[0] = product_size(far, size[0]) + scaled_size(q->space->imaginary[k], e, a);
    }
    for (int i = 0; i <= top; i++) {
        q->c[i].im = value[i];
        q->r[i] += (4 * top + 4) * ALGSURF_U * size[i];
    }
}

/* Returns 0 when the expansion left the range of double. */
static int expand(complex_query *q) {
    double real[ALGSURF_MAX_DEGREE + 1], X[3] = {q->frame.X[0].hi, q->frame.X[1].hi, q->frame.X[2].hi};
    int n = q->surface->degree;
    algsurf_i_expand_d(q->surface, X, q->frame.D, real, q->r);
    for (int i = 0; i <= n; i++) q->c[i] = (algsurf_complex){real[i], 0};
    add_imaginary(q);
    for (int i = 0; i <= n; i++)
        if (!isfinite(q->c[i].re) || !isfinite(q->c[i].im) || !isfinite(q->r[i])) return 0;
    return 1;
}

/* The enclosure of a root v as one of the natural parameter s. */
static algsurf_complex_root shifted(const algsurf_i_frame *f, const algsurf_complex_root *root) {
    const algsurf_interval step = {f->step, f->step}, centre = {f->centre, f->centre};
    algsurf_complex_root e = *root;
    e.box.re = algsurf_i_interval_add(centre, algsurf_i_interval_mul(step, root->box.re));
    e.box.im = algsurf_i_interval_mul(step, root->box.im);
    e.root = (algsurf_complex){f->centre + f->step * root->root.re, f->step * root->root.im};
    return e;
}

/* p'(v) / step: dp/ds at the root. */
static algsurf_complex slope(const complex_query *q, algsurf_complex v) {
    algsurf_complex d = {0, 0};
    for (int k = q->surface->degree; k > 0; k--)
        d = (algsurf_complex){d.re * v.re - d.im * v.im + k * q->c[k].re,
                              d.re * v.im + d.im * v.re + k * q->c[k].im};
    return (algsurf_complex){d.re / q->frame.step, d.im / q->frame.step};
}

/* Where root and p' are real it is that of real space but for its side, exact where it has to be. */
static void set_normal(const complex_query *q, algsurf_complex v, const double position[3],
                       double normal[3]) {
    const algsurf_i_frame *f = &q->frame;
    algsurf_i_complex x[3], g[3];
    algsurf_complex p = slope(q, v);
    double d2 = p.re * p.re + p.im * p.im, w[3], real[3];
    for (int i = 0; i < 3; i++) x[i] = (algsurf_i_complex){f->X[i].hi + f->D[i] * v.re, f->D[i] * v.im};
    algsurf_i_surface_gradient_complex(q->surface, x, g);
    for (int i = 0; i < 3; i++) w[i] = (g[i].re * p.re + g[i].im * p.im) / d2;
    double along = (1 - algsurf_dot(w, f->V)) / algsurf_dot(f->V, f->V);
    /* p' > 0 where P grows along the ray: the sign of the gradient, for telling the sides apart.  Where p' is
     * imaginary but for rounding, as on the complex part of a sphere, this is the side that is seen. */
    double sign = p.re < -0x1p-30 * sqrt(d2) ? -1 : 1;
    for (int i = 0; i < 3; i++) w[i] = sign * (w[i] + (v.im == 0 && p.im == 0 ? 0 : along * f->V[i]));
    if (v.im == 0 && p.im == 0 && !algsurf_i_surface_clear_gradient(q->surface, position, real)) {
        algsurf_i_set_normal(q->surface, &q->ray, position, 0, ALGSURF_DEFAULT_MEMORY, normal);
        for (int i = 0; i < 3; i++) normal[i] *= sign;
        return;
    }
    if (!algsurf_is_finite3(w) || !algsurf_unit(w, normal)) normal[0] = normal[1] = normal[2] = 0;
}

/* |z|, by operations that all systems round alike. */
static double magnitude_of(algsurf_complex z) {
    double largest = fmax(fabs(z.re), fabs(z.im));
    if (z.re == 0 || z.im == 0) return largest;
    int e = ilogb(largest);
    double re = ldexp(z.re, -e), im = ldexp(z.im, -e);
    return ldexp(sqrt(re * re + im * im), e);
}

static double clamped(double x, double lo, double hi) { return fmin(fmax(x, lo), hi); }

static void set_hit(const complex_query *q, const algsurf_complex_root *local, const algsurf_complex_root *s,
                    algsurf_hit *hit, algsurf_complex *root) {
    const algsurf_i_frame *f = &q->frame;
    algsurf_interval ends = algsurf_i_interval_scale(algsurf_i_cinterval_abs(s->box), -f->exponent);
    double size = magnitude_of(s->root), t = ldexp(size, -f->exponent), x[3];
    /* |s| - centre, without the rounding of the sum where the root is real and in front */
    double offset = s->root.im == 0 && s->root.re >= 0 ? f->step * local->root.re : size - f->centre;
    hit->t = clamped(t, q->ray.t_min, fmin(q->ray.t_max, DBL_MAX));
    hit->t_lo = clamped(ends.lo, q->ray.t_min, hit->t);
    hit->t_hi = clamped(ends.hi, hit->t, q->ray.t_max);
    for (int i = 0; i < 3; i++) x[i] = algsurf_dd_add(f->X[i], algsurf_two_prod(offset, f->V[i])).hi;
    algsurf_i_set_position(f, x, &q->ray, q->surface->unit, hit->t, f->lost, hit->position);
    if (local->multiplicity == 1)
        set_normal(q, local->root, hit->position, hit->normal); /* a cluster has none */
    if (root) *root = (algsurf_complex){ldexp(s->root.re, -f->exponent), ldexp(s->root.im, -f->exponent)};
}

/* Start values in v from those in t. */
static const algsurf_complex *start_in_v(const complex_query *q, const algsurf_complex *start,
                                         algsurf_complex *v) {
    const algsurf_i_frame *f = &q->frame;
    if (!start) return NULL;
    for (int i = 0; i < q->surface->degree; i++)
        v[i] = (algsurf_complex){(ldexp(start[i].re, f->exponent) - f->centre) / f->step,
                                 ldexp(start[i].im, f->exponent) / f->step};
    return v;
}

static void give_roots(const complex_query *q, const algsurf_complex_root *s, int count,
                       algsurf_complex *roots) {
    for (int i = 0; roots && i < q->surface->degree; i++)
        roots[i] = i < count ? (algsurf_complex){ldexp(s[i].root.re, -q->frame.exponent),
                                                 ldexp(s[i].root.im, -q->frame.exponent)}
                             : (algsurf_complex){NAN, NAN};
}

/* How many roots P has at t in a range, in a region; -1 without memory. */
static int count_inside(complex_query *q, const algsurf_i_region *region, algsurf_interval t) {
    algsurf_i_ray_root roots[ALGSURF_MAX_DEGREE];
    algsurf_ray part = q->front;
    int count = 0, side;
    part.t_min = t.lo, part.t_max = t.hi;
    if (!algsurf_i_has_points(t.lo, t.hi)) return 0;
    algsurf_status status = algsurf_i_exact_roots(
        q->surface, region, &part, &(algsurf_i_wanted){ALGSURF_WANT_ALL, .limit = ALGSURF_DEFAULT_MEMORY},
        roots, &count, &side);
    q->without_memory |= status != ALGSURF_OK;
    return status == ALGSURF_OK ? count : -1;
}

/* Are the roots of P in the root's box in front of the eye and in the region: 1, 0; or -1: not known.
 * Integers tell it of real roots. */
static int is_inside(complex_query *q, const algsurf_complex_root *s) {
    const algsurf_i_region everywhere = {NULL, NULL, 0};
    if (!q->real || q->surface->error > 0 || s->box.im.lo != 0 || s->box.im.hi != 0 || s->box.re.hi < 0)
        return -1;
    const algsurf_interval t = algsurf_i_interval_scale(s->box.re, -q->frame.exponent);
    const algsurf_interval ahead = {fmax(t.lo, 0), t.hi},
                           seen = {fmax(t.lo, q->front.t_min), fmin(t.hi, q->front.t_max)};
    int all = count_inside(q, &everywhere, t), inside = count_inside(q, q->region, seen);
    if (all < 0 || inside < 0) return -1;
    if (inside == all) return 1;
    return inside == 0 && (t.lo >= 0 || count_inside(q, &everywhere, ahead) == all) ? 0 : -1;
}

/* The root that is seen.  Where the ends of the ray in the natural parameter s are no doubles, the range is
 * one that holds them, and a root has to be in one that they hold, or to be shown to be inside, to be
 * certain.  Roots that are shown to be outside are taken out of s and local; about one that is inside, the
 * range is as wide as its box. */
static int choose_least(complex_query *q, algsurf_complex_root *s, algsurf_complex_root *local, int count,
                        int *index) {
    const int e = q->frame.exponent;
    const algsurf_interval inner = {algsurf_i_scale_up(fmax(q->ray.t_min, q->chord.inner_lo), e),
                                    algsurf_i_scale_down(fmin(q->ray.t_max, q->chord.inner_hi), e)};
    algsurf_interval range = algsurf_i_interval_scale((algsurf_interval){q->ray.t_min, q->ray.t_max}, e);
    for (int shown = -1;;) {
        int selected = ALGSURF_SELECTED_NONE;
        (void)(q->real ? algsurf_select_of_real : algsurf_select)(s, count, &q->space->sector, range.lo,
                                                                  range.hi, &selected, index);
        if (selected == ALGSURF_SELECTED_NONE) return selected;
        int i = *index;
        const algsurf_interval size = algsurf_i_cinterval_abs(s[i].box);
        int is_known = selected == ALGSURF_SELECTED_ONE || s[i].box.re.lo >= 0;
        if (i == shown || (is_known && algsurf_i_interval_inside(size, inner))) return selected;
        int inside = is_inside(q, s + i);
        if (inside < 0) return ALGSURF_SELECTED_UNDECIDED;
        if (inside) {
            s[i].box.re.lo = fmax(s[i].box.re.lo, 0);
            range = algsurf_i_interval_hull(range, size);
            shown = i;
            continue;
        }
        count--;
        for (int k = i; k < count; k++) s[k] = s[k + 1], local[k] = local[k + 1];
        if (shown > i) shown--;
    }
}

/* All roots; apart, so that their memory is free again afterwards. */
static ALGSURF_NOINLINE algsurf_status roots_of(complex_query *q, const algsurf_complex *start,
                                                algsurf_complex_root *local, int *count, int *iterations) {
    algsurf_complex_solver_stats stats;
    algsurf_complex v[ALGSURF_MAX_DEGREE + 1];
    if (!expand(q)) return ALGSURF_E_RANGE;
    algsurf_status status =
        algsurf_i_all_roots(&q->c->re, q->real ? NULL : &q->c->im, 2, q->r, q->surface->degree,
                            start_in_v(q, start, v), local, count, &stats);
    if (status == ALGSURF_OK) *iterations = stats.iterations;
    return status;
}

/* hit and root are those of a miss so far; roots may be start.  Apart, as most rays that miss need none of
 * its memory. */
static ALGSURF_NOINLINE void solve(complex_query *q, const algsurf_complex *start, algsurf_complex *roots,
                                   algsurf_hit *hit, algsurf_complex *root, int *iterations) {
    algsurf_complex_root local[ALGSURF_MAX_DEGREE + 1], s[ALGSURF_MAX_DEGREE + 1];
    int count = 0, index = 0;
    algsurf_i_frame_of(q->surface, &q->ray, 0, &q->frame);
    algsurf_status status = roots_of(q, start, local, &count, iterations);
    if (status != ALGSURF_OK) {
        q->without_memory = status == ALGSURF_E_NO_MEMORY;
        give_roots(q, NULL, 0, roots);
        hit->state = ALGSURF_STATE_UNDECIDED; /* overflow, or a polynomial that may vanish */
        hit->reason = status == ALGSURF_E_ZERO ? ALGSURF_UNDECIDED_ZERO : ALGSURF_UNDECIDED_RANGE;
        hit->t = hit->t_lo = q->ray.t_min;
        hit->t_hi = q->ray.t_max;
        for (int i = 0; i < 3; i++) hit->position[i] = algsurf_i_coordinate_at(&q->ray, i, hit->t);
        return;
    }
    for (int i = 0; i < count; i++) s[i] = shifted(&q->frame, local + i);
    give_roots(q, s, count, roots);
    const int selected = choose_least(q, s, local, count, &index);
    if (selected == ALGSURF_SELECTED_NONE) return;
    if (selected == ALGSURF_SELECTED_ONE) {
        hit->state = ALGSURF_STATE_HIT;
        hit->multiplicity = local[index].multiplicity;
    } else {
        hit->state = ALGSURF_STATE_UNDECIDED;
        hit->reason = local[index].multiplicity > 1 ? ALGSURF_UNDECIDED_MULTIPLE : ALGSURF_UNDECIDED_END;
    }
    set_hit(q, local + index, s + index, hit, root);
}

static algsurf_status check(const algsurf_complex_space *space, int n) {
    const size_t count = space->imaginary_count;
    if (count > ALGSURF_MAX_DEGREE + 1 || (count > 0 && !space->imaginary)) return ALGSURF_E_ARGUMENT;
    for (size_t k = 0; k < count; k++) {
        if (!isfinite(space->imaginary[k])) return ALGSURF_E_NOT_FINITE;
        if (k > (size_t)n && space->imaginary[k] != 0) return ALGSURF_E_ARGUMENT;
    }
    int holds;
    const algsurf_complex_root probe = {{{1, 1}, {0, 0}}, {1, 0}, 1, 1};
    return algsurf_sector_holds(&space->sector, &probe, &holds);
}

algsurf_status algsurf_i_intersect_complex(const algsurf_surface *surface, const algsurf_i_region *region,
                                           const algsurf_ray *ray, const algsurf_complex_space *given,
                                           const algsurf_complex *start, algsurf_complex *roots,
                                           algsurf_hit *hit, algsurf_complex *root, int *iterations) {
    algsurf_complex_space space;
    complex_query q;
    if (!surface || !hit) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_options_read(&space, sizeof space, given);
    if (status == ALGSURF_OK) status = algsurf_i_ray_check(ray);
    if (status == ALGSURF_OK) status = algsurf_i_extent_check(region->extent);
    if (status == ALGSURF_OK) status = check(&space, surface->degree);
    if (status != ALGSURF_OK) return status;
    q.surface = surface;
    q.space = &space;
    q.region = region;
    q.front = *ray;
    q.front.t_min = fmax(ray->t_min, 0);
    q.ray = q.front;
    q.without_memory = *iterations = 0;
    algsurf_i_set_miss(hit, 0);
    if (root) *root = (algsurf_complex){NAN, NAN};
    if (!algsurf_i_has_points(q.front.t_min, q.front.t_max) ||
        !algsurf_i_region_chord(region, &q.front, &q.chord)) {
        give_roots(&q, NULL, 0, roots);
        return ALGSURF_OK;
    }
    q.ray.t_min = q.chord.lo;
    q.ray.t_max = q.chord.hi;
    solve(&q, start, roots, hit, root, iterations);
    return q.without_memory ? ALGSURF_E_NO_MEMORY : ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, intersect_complex,
                (const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray *ray,
                 const algsurf_complex_space *space, const algsurf_complex *start, algsurf_complex *roots,
                 algsurf_hit *hit, algsurf_complex *root),
                (surface, extent, ray, space, start, roots, hit, root)) {
    const algsurf_i_region region = {extent, NULL, 0};
    int iterations;
    return algsurf_i_intersect_complex(surface, &region, ray, space, start, roots, hit, root, &iterations);
}
