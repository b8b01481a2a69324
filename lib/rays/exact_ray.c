/* exact_ray.c - a ray in integers: the chord, P along it, its roots, those of them that are in the region.
 *
 * The chord only says where to look: it is the part of the ray in a region a little larger, rounded outward
 * (ray.c).  P, and the region's faces, which are those of the extent and the planes, are polynomials with
 * integer coefficients in u, t = 2^unit u (surface/exact_form.c, faces.c), with the unit that suits the
 * chord; the roots come from the exact walk (roots/exact_walk.c); and a root next to a face is inside if no
 * face is negative there, which is decided exactly, too.
 *
 * Coefficients with an error.  The polynomials along the ray of all surfaces within it are one with radii: a
 * coefficient a is known to error |a|.  Along X + u D, in integers, p_k is then known to the coefficient of
 * u^k of the form of the terms error |a|, along |X| + u |D|: all of its summands are the magnitudes of those
 * of p_k. Both forms get the same power of two, and exact_radii.c finds where the set has roots.  These
 * bounds are good about X alone: farther along the ray they are as if no coordinate changed its sign, and no
 * terms cancelled.  So each place is looked at again from a point in it, a few times, as long as it gets
 * narrower: p moves there exactly, and the coordinates there, |X + u D|, are rounded up.  What lies within
 * the rounding of the chord's ends is undecided: it may be inside the region or not.  An end that is infinite
 * has no rounding: roots beyond the largest double count like all others. */
#include "../base/arithmetic.h"
#include "exact_ray.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/vec.h"
#include "../roots/exact_walk.h"
#include "../surface/exact_form.h"
#include "faces.h"

enum { STACK_WORDS = 2048, MOST_LOOKS = 3 };
static const double NARROW = 0x1p-40;  /* parts of t: no place is looked at again that is narrower */
static const double NARROWER = 0x1p-3; /* times its width: what is found must be, or nothing is gained */

typedef struct query {
    const algsurf_surface *surface;
    const algsurf_i_region *region;
    const algsurf_ray *ray;
    algsurf_i_chord chord;
    const algsurf_i_wanted *wanted;
    int unit, scale; /* p(u) = 2^scale P */
    algsurf_memory memory;
    algsurf_i_ray_root *roots;
    int count, miss_side;
} query;

/* The unit 2^unit of t that suits the chord; of one without ends, about the way from the origin to the
 * surface. */
static int unit_of(const query *q) {
    if (isfinite(q->chord.lo) && isfinite(q->chord.hi))
        return algsurf_exact_piece_of(q->chord.lo, q->chord.hi).unit;
    double far = algsurf_max_abs(q->ray->origin), step = algsurf_max_abs(q->ray->direction);
    int reach = far > 0 && ilogb(far) > q->surface->unit ? ilogb(far) : q->surface->unit;
    return reach - ilogb(step);
}

static int make_faces(query *q, algsurf_zpoly face[ALGSURF_MOST_FACES], int *count) {
    return algsurf_i_faces(&q->memory, q->region, q->ray->origin, q->ray->direction, q->unit, face, count);
}

/* A root, unless it is of the wrong side. */
static void add_root(query *q, algsurf_i_ray_root root) {
    if (!q->wanted->side || root.reason != ALGSURF_OK || root.side == q->wanted->side)
        q->roots[q->count++] = root;
    else
        q->miss_side = root.multiplicity % 2 ? -root.side : root.side;
}

static void add_exact(query *q, const algsurf_exact_root *r) {
    add_root(q, (algsurf_i_ray_root){r->multiplicity, r->sign_before, r->t, r->lo, r->hi, ALGSURF_OK});
}

/* If no root has been passed by: the sign of p at the last place of the ray that is surely in the region. */
static algsurf_status set_miss_side(query *q, const algsurf_zpoly *p) {
    const algsurf_i_chord *c = &q->chord;
    double at = fmin(c->hi, c->inner_hi);
    if (q->count > 0 || q->miss_side || at < fmax(c->lo, c->inner_lo)) return ALGSURF_OK;
    int done = algsurf_exact_at_double(&q->memory, p, q->unit, at, &q->miss_side, NULL, NULL);
    return done ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

/* Is no face but number `except` negative at the walk's last root?  Returns 0 when there is no memory. */
static int is_inside(query *q, algsurf_exact_walk *walk, const algsurf_exact_root *root, int except,
                     int *inside) {
    algsurf_zpoly face[ALGSURF_MOST_FACES];
    int faces, sign = 1;
    algsurf_memory_mark mark = algsurf_memory_here(&q->memory);
    int done = make_faces(q, face, &faces);
    *inside = 1;
    for (int i = 0; done && *inside && i < faces; i++) {
        if (i == except) continue;
        done = algsurf_exact_sign_at_root(walk, root, face + i, &sign);
        *inside = sign >= 0;
    }
    algsurf_memory_release(&q->memory, mark);
    return done;
}

static int surely_inside(const query *q, double lo, double hi) {
    return lo >= q->chord.inner_lo && hi <= q->chord.inner_hi;
}

/* The roots of p that are inside. */
static algsurf_status walk_chord(query *q, const algsurf_zpoly *p) {
    algsurf_exact_walk walk;
    algsurf_exact_root root;
    const algsurf_i_watch watch = {.observer = q->wanted->observer, .exponent = -q->scale};
    int found, inside;
    if (!algsurf_exact_begin(&walk, &q->memory, p, q->unit, q->chord.lo, q->chord.hi,
                             q->wanted->want != ALGSURF_WANT_ANY, q->wanted->observer ? &watch : NULL))
        return ALGSURF_E_NO_MEMORY;
    while ((found = algsurf_exact_next(&walk, &root)) == ALGSURF_EXACT_ROOT) {
        inside = 1;
        if (!surely_inside(q, root.lo, root.hi) && !is_inside(q, &walk, &root, -1, &inside))
            return ALGSURF_E_NO_MEMORY;
        if (inside) add_exact(q, &root);
        if (q->count > 0 && q->wanted->want != ALGSURF_WANT_ALL) break;
    }
    return found == ALGSURF_EXACT_NO_MEMORY ? ALGSURF_E_NO_MEMORY : set_miss_side(q, p);
}

/* ---- a ray in the surface: its first t that counts ---- */

/* Is t itself, not infinity, inside all faces? */
static int begin_is_inside(query *q, const algsurf_zpoly *face, int faces, double t, int *inside) {
    int sign, done = 1;
    *inside = 1;
    for (int i = 0; done && *inside && i < faces; i++) {
        done = algsurf_exact_at_double(&q->memory, face + i, q->unit, t, &sign, NULL, NULL);
        *inside = sign >= 0;
    }
    return done;
}

/* The first root of one face at which all others are not negative. */
static int first_entry(query *q, const algsurf_zpoly *face, int which, algsurf_exact_root *best, int *any) {
    algsurf_exact_walk walk;
    algsurf_exact_root root;
    int found, inside = 0;
    if (face[which].degree < 1) return 1;
    if (!algsurf_exact_begin(&walk, &q->memory, face + which, q->unit, q->chord.lo, q->chord.hi, 1, NULL))
        return 0;
    while (!inside && (found = algsurf_exact_next(&walk, &root)) == ALGSURF_EXACT_ROOT)
        if (!is_inside(q, &walk, &root, which, &inside)) return 0;
    algsurf_exact_end(&walk);
    if (!inside) return found != ALGSURF_EXACT_NO_MEMORY;
    if (!*any || root.lo < best->lo || root.hi < best->hi) *best = root;
    *any = 1;
    return 1;
}

static algsurf_status ray_in_surface(query *q) {
    algsurf_zpoly face[ALGSURF_MOST_FACES];
    const double begin = q->ray->t_min, drawn_in = fmax(begin, -DBL_MAX);
    algsurf_exact_root best = {.lo = begin, .hi = drawn_in, .t = drawn_in};
    int faces = 0, any;
    if (!make_faces(q, face, &faces)) return ALGSURF_E_NO_MEMORY;
    if (!begin_is_inside(q, face, faces, begin, &any)) return ALGSURF_E_NO_MEMORY;
    for (int i = 0, entered = any; !entered && i < faces; i++)
        if (!first_entry(q, face, i, &best, &any)) return ALGSURF_E_NO_MEMORY;
    best.multiplicity = best.sign_before = 0;
    if (any) add_exact(q, &best);
    return ALGSURF_OK;
}

/* ---- coefficients with an error ---- */

/* The terms as error |a|, rounded up; to be freed. */
static algsurf_term *magnitudes(const algsurf_surface *s) {
    algsurf_term *terms = malloc(s->term_count * sizeof *terms);
    for (size_t m = 0; terms && m < s->term_count; m++) {
        terms[m] = s->terms[m];
        terms[m].a = nextafter(s->error * fabs(terms[m].a), HUGE_VAL);
    }
    return terms;
}

/* p 2^up, up >= 0, in room of its own. */
static int scaled(algsurf_memory *m, const algsurf_zpoly *p, int up, algsurf_zpoly *q) {
    if (p->degree < 0 || up == 0) {
        *q = *p;
        return 1;
    }
    if (!algsurf_zpoly_copy(m, p, algsurf_z_width(algsurf_zpoly_bits(p) + up), q)) return 0;
    for (int k = 0; k <= q->degree; k++) algsurf_z_shift_up(algsurf_zpoly_at(q, k), q->width, up);
    return 1;
}

/* *p becomes p(c + v) 2^up, c = base / 2^unit = +-numerator 2^-down, up = down deg p. */
static int move(algsurf_memory *m, algsurf_zpoly *p, algsurf_limb numerator, int minus, int down) {
    int n = p->degree, w = algsurf_z_width(algsurf_zpoly_bits(p) + n * (down + 64 + 1) + 1);
    algsurf_zpoly a;
    if (!algsurf_zpoly_new(m, n, w, &a)) return 0;
    for (int k = 0; k <= n; k++) {
        algsurf_z_copy(algsurf_zpoly_at(&a, k), w, algsurf_zpoly_at(p, k), p->width);
        algsurf_z_shift_up(algsurf_zpoly_at(&a, k), w, down * (n - k));
    }
    for (int i = 0; i < n; i++)
        for (int k = n - 1; k >= i; k--)
            algsurf_z_join_product(algsurf_zpoly_at(&a, k), w, algsurf_zpoly_at(&a, k + 1), w, numerator, 0,
                                   minus);
    for (int k = 0; k <= n; k++) algsurf_z_shift_up(algsurf_zpoly_at(&a, k), w, down * k);
    *p = a;
    return 1;
}

/* p and its radii in one unit, from the point at t = base on, which is numerator 2^(unit - down). */
static int make_forms(query *q, algsurf_term *spread, double base, int down, algsurf_zpoly *p,
                      algsurf_zpoly *radius) {
    algsurf_memory *m = &q->memory;
    algsurf_surface wide = *q->surface;
    double o[3], d[3];
    int scale, radius_scale;
    for (int i = 0; i < 3; i++) {
        double x = q->ray->origin[i], way = base * q->ray->direction[i];
        o[i] = fabs(x + way);
        if (base != 0) o[i] += 0x1p-51 * (fabs(x) + fabs(way)) + DBL_MIN;
        d[i] = fabs(q->ray->direction[i]);
    }
    wide.terms = spread;
    if (!algsurf_i_exact_form(m, q->surface, q->ray->origin, q->ray->direction, q->unit, p, &scale) ||
        !algsurf_i_exact_form(m, &wide, o, d, q->unit, radius, &radius_scale))
        return 0;
    if (base != 0 && p->degree > 0) {
        scale += down * p->degree;
        if (!move(m, p, (algsurf_limb)ldexp(fabs(base), down - q->unit), base < 0, down)) return 0;
    }
    if (p->degree < 0) scale = radius_scale;
    int common = scale > radius_scale ? scale : radius_scale;
    return scaled(m, p, common - scale, p) && scaled(m, radius, common - radius_scale, radius);
}

static algsurf_i_ray_root place_of(const query *q, const algsurf_exact_range *range) {
    double lo = range->lo, hi = range->hi, first = q->chord.lo, last = q->chord.hi;
    double middle = fmax(fmin(0.5 * lo + 0.5 * hi, DBL_MAX), -DBL_MAX);
    int inside = surely_inside(q, lo, hi);
    int at_end = (isfinite(first) && lo <= first) || (isfinite(last) && hi >= last);
    algsurf_status reason = inside && range->sign_lo ? ALGSURF_OK
                            : first == last          ? ALGSURF_UNDECIDED_ZERO
                            : !inside || at_end      ? ALGSURF_UNDECIDED_END
                                                     : ALGSURF_UNDECIDED_MULTIPLE;
    return (algsurf_i_ray_root){1, range->sign_lo, middle, lo, hi, reason};
}

/* A double in the range with few bits, base = N 2^(unit - down), N < 2^53; 0: there is none that is worth it.
 */
static double base_in(const query *q, const algsurf_exact_range *range, int *down) {
    double lo = range->lo, hi = range->hi, middle = 0.5 * lo + 0.5 * hi, size = fmax(fabs(lo), fabs(hi));
    if (!(hi - lo > NARROW * size) || size > 0x1p500 || size < 0x1p-500) return 0;
    int least = ilogb(hi - lo) - 3;
    double base = ldexp(rint(ldexp(middle, -least)), least);
    *down = q->unit > least ? q->unit - least : 0;
    return fabs(base) < ldexp(1, 53 + q->unit - *down) ? base : 0;
}

/* Looks at a range again from a point in it.  *better: what is found takes its place, *count <= room ranges.
 * Returns 0 when there is no memory. */
static int look_again(query *q, algsurf_term *spread, const algsurf_exact_range *range,
                      algsurf_exact_range *found, int room, int *count, int *better) {
    algsurf_memory_mark mark = algsurf_memory_here(&q->memory);
    algsurf_zpoly p, radius;
    int down;
    double base = base_in(q, range, &down), width = 0, last = range->lo;
    *better = 0;
    if (base == 0) return 1;
    int done =
        make_forms(q, spread, base, down, &p, &radius) &&
        algsurf_exact_radii_isolate(&q->memory, &p, &radius, q->unit, nextafter(range->lo - base, -HUGE_VAL),
                                    nextafter(range->hi - base, HUGE_VAL), found, room, count, NULL);
    algsurf_memory_release(&q->memory, mark);
    if (!done) return 0;
    *better = !range->sign_lo || (*count == 1 && found[0].sign_lo);
    for (int i = 0; i < *count; i++) {
        found[i].lo = nextafter(base + found[i].lo, -HUGE_VAL);
        found[i].hi = nextafter(base + found[i].hi, HUGE_VAL);
        *better &= found[i].lo >= last;
        last = found[i].hi;
        width += last - found[i].lo;
    }
    *better &= last <= range->hi && width <= NARROWER * (range->hi - range->lo);
    return 1;
}

/* What callers have room for. */
static int most_places(const query *q) { return q->surface->degree > 0 ? q->surface->degree : 1; }

static int look_closer(query *q, algsurf_term *spread, algsurf_exact_range *range, int *count) {
    algsurf_exact_range found[ALGSURF_MAX_DEGREE];
    int better, now, gained = 1;
    for (int look = 0; gained && look < MOST_LOOKS; look++)
        for (int i = gained = 0; i < *count; i += better ? now : 1) {
            int room = most_places(q) + 1 - *count;
            if (!look_again(q, spread, range + i, found, room, &now, &better)) return 0;
            if (!better) continue;
            memmove(range + i + now, range + i + 1, (size_t)(*count - i - 1) * sizeof *range);
            memcpy(range + i, found, (size_t)now * sizeof *range);
            *count += now - 1;
            gained = 1;
        }
    return 1;
}

static ALGSURF_NOINLINE algsurf_status find_places(query *q) {
    const algsurf_i_watch watch = {.observer = q->wanted->observer};
    algsurf_zpoly p, radius;
    algsurf_exact_range range[ALGSURF_MAX_DEGREE];
    algsurf_term *spread = magnitudes(q->surface);
    int found,
        done = spread && make_forms(q, spread, 0, 0, &p, &radius) &&
               algsurf_exact_radii_isolate(&q->memory, &p, &radius, q->unit, q->chord.lo, q->chord.hi, range,
                                           most_places(q), &found, watch.observer ? &watch : NULL) &&
               look_closer(q, spread, range, &found);
    free(spread);
    if (!done) return ALGSURF_E_NO_MEMORY;
    for (int i = 0; i < found; i++) add_root(q, place_of(q, range + i));
    return set_miss_side(q, &p);
}

/* ---- both ---- */

static algsurf_status decide(query *q) {
    algsurf_zpoly p;
    const double *o = q->ray->origin, *d = q->ray->direction;
    if (!algsurf_i_region_chord(q->region, q->ray, &q->chord)) return ALGSURF_OK;
    q->unit = unit_of(q);
    if (q->surface->error > 0) return find_places(q);
    if (!algsurf_i_exact_form(&q->memory, q->surface, o, d, q->unit, &p, &q->scale))
        return ALGSURF_E_NO_MEMORY;
    if (p.degree < 0) return ray_in_surface(q);
    return p.degree > 0 ? walk_chord(q, &p) : set_miss_side(q, &p);
}

algsurf_status algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_i_region *region,
                                     const algsurf_ray *ray, const algsurf_i_wanted *wanted,
                                     algsurf_i_ray_root *roots, int *count, int *miss_side) {
    algsurf_limb block[STACK_WORDS];
    query q = {.surface = surface, .region = region, .ray = ray, .wanted = wanted, .roots = roots};
    algsurf_memory_begin(&q.memory, block, STACK_WORDS, wanted->limit);
    algsurf_memory_mark begin = algsurf_memory_here(&q.memory);
    algsurf_status status = decide(&q);
    algsurf_memory_release(&q.memory, begin);
    *count = q.count;
    *miss_side = q.miss_side;
    return status;
}
