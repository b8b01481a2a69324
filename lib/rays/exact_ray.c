/* exact_ray.c - a ray in integers: the chord, P along it, its roots, those of them that are in the region.
 *
 * The chord only says where to look: it is the part of the ray in a region a little larger, rounded outward
 * (region.c).  P, and the region's faces, which are those of the extent and the planes, are polynomials with
 * integer coefficients in u, t = 2^unit u (surface/exact_form.c, faces.c), with the unit that suits the
 * chord; the roots come from the exact walk (roots/exact_walk.c); and a root next to a face is inside if no
 * face is negative there, which is decided exactly, too. */
#include "../base/arithmetic.h"
#include "exact_ray.h"

#include <float.h>
#include <math.h>

#include "../base/vec.h"
#include "../roots/exact_walk.h"
#include "../surface/exact_form.h"
#include "faces.h"
#include "region.h"

enum { STACK_WORDS = 2048 };

typedef struct query {
    const algsurf_surface *surface;
    const algsurf_i_region *region;
    const algsurf_ray *ray;
    algsurf_ray chord;
    algsurf_i_edges edges;
    int unit, scale; /* p(u) = 2^scale P */
    algsurf_observer *observer;
    algsurf_memory memory;
    algsurf_i_ray_root *roots;
    int count, capacity;
} query;

int algsurf_i_exact_unit(const algsurf_surface *s, const algsurf_ray *ray, double t_min, double t_max) {
    if (isfinite(t_min) && isfinite(t_max)) return algsurf_exact_piece_of(t_min, t_max).unit;
    double far = algsurf_max_abs(ray->origin), step = algsurf_max_abs(ray->direction);
    int reach = far > 0 && ilogb(far) > s->unit ? ilogb(far) : s->unit;
    return reach - ilogb(step);
}

static void add_root(query *q, const algsurf_exact_root *root) {
    if (q->count == q->capacity) return;
    q->roots[q->count++] =
        (algsurf_i_ray_root){root->multiplicity, root->sign_before, root->t, root->lo, root->hi};
}

/* Is no face but number `except` negative at the walk's last root?  Returns 0 when there is no memory. */
static int is_inside(query *q, algsurf_exact_walk *walk, const algsurf_exact_root *root, int except,
                     int *inside) {
    algsurf_zpoly face[ALGSURF_MOST_FACES];
    int faces, sign = 1, done;
    algsurf_memory_mark mark = algsurf_memory_here(&q->memory);
    *inside = 1;
    done = algsurf_i_faces(&q->memory, q->region, q->ray->origin, q->ray->direction, q->unit, face, &faces);
    for (int i = 0; done && *inside && i < faces; i++) {
        if (i == except) continue;
        done = algsurf_exact_sign_at_root(walk, root, face + i, &sign);
        *inside = sign >= 0;
    }
    algsurf_memory_release(&q->memory, mark);
    return done;
}

static int surely_inside(const query *q, const algsurf_exact_root *root) {
    return !q->edges.cut || (root->lo >= q->edges.inner_lo && root->hi <= q->edges.inner_hi);
}

/* The roots of p that are inside. */
static algsurf_status walk_chord(query *q, const algsurf_zpoly *p, algsurf_i_want want) {
    algsurf_exact_walk walk;
    algsurf_exact_root root;
    const algsurf_i_watch watch = {.observer = q->observer, .exponent = -q->scale};
    int found, inside;
    if (!algsurf_exact_begin(&walk, &q->memory, p, q->unit, q->chord.t_min, q->chord.t_max,
                             want != ALGSURF_WANT_ANY, q->observer ? &watch : NULL))
        return ALGSURF_E_NO_MEMORY;
    while ((found = algsurf_exact_next(&walk, &root)) == ALGSURF_EXACT_ROOT) {
        inside = 1;
        if (!surely_inside(q, &root) && !is_inside(q, &walk, &root, -1, &inside)) return ALGSURF_E_NO_MEMORY;
        if (inside) add_root(q, &root);
        if (inside && want != ALGSURF_WANT_ALL) break;
    }
    return found == ALGSURF_EXACT_NO_MEMORY ? ALGSURF_E_NO_MEMORY : ALGSURF_OK;
}

/* ---- a ray in the surface: its first t that counts ---- */

static algsurf_exact_root point_root(double t) {
    double drawn_in = fmax(t, -DBL_MAX);
    return (algsurf_exact_root){.lo = t, .hi = drawn_in, .t = drawn_in};
}

/* The sign of a face of degree 0 or more at -infinity. */
static int sign_far_before(const algsurf_zpoly *face) {
    int negative = algsurf_z_negative(algsurf_zpoly_at(face, face->degree), face->width);
    return negative != face->degree % 2 ? -1 : 1;
}

/* Is t itself, not infinity, inside all faces? */
static int begin_is_inside(query *q, const algsurf_zpoly *face, int faces, double t, int *inside) {
    int e = 0, sign = 1, done = 1, endless = isinf(t);
    algsurf_limb odd = endless ? 0 : algsurf_z_odd_part(t, &e), N = t < 0 ? 0 - odd : odd;
    *inside = 1;
    for (int i = 0; done && *inside && i < faces; i++) {
        if (face[i].degree < 0) continue;
        if (endless)
            sign = sign_far_before(face + i);
        else
            done =
                algsurf_zpoly_sign_at(&q->memory, face + i, &N, 1, odd ? q->unit - e : 0, &sign, NULL, NULL);
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
    if (!algsurf_exact_begin(&walk, &q->memory, face + which, q->unit, q->chord.t_min, q->chord.t_max, 1,
                             NULL))
        return 0;
    while (!inside && (found = algsurf_exact_next(&walk, &root)) == ALGSURF_EXACT_ROOT)
        if (!is_inside(q, &walk, &root, which, &inside)) return 0;
    algsurf_exact_end(&walk);
    if (!inside) return found != ALGSURF_EXACT_NO_MEMORY;
    if (!*any || root.t < best->t) *best = root;
    *any = 1;
    return 1;
}

static algsurf_status ray_in_surface(query *q) {
    algsurf_zpoly face[ALGSURF_MOST_FACES];
    algsurf_exact_root best = point_root(q->ray->t_min);
    int faces = 0, any = 1;
    if (!algsurf_i_faces(&q->memory, q->region, q->ray->origin, q->ray->direction, q->unit, face, &faces))
        return ALGSURF_E_NO_MEMORY;
    if (faces > 0) {
        any = 0;
        if (!begin_is_inside(q, face, faces, q->ray->t_min, &any)) return ALGSURF_E_NO_MEMORY;
        for (int i = 0, entered = any; !entered && i < faces; i++)
            if (!first_entry(q, face, i, &best, &any)) return ALGSURF_E_NO_MEMORY;
    }
    best.multiplicity = best.sign_before = 0;
    if (any) add_root(q, &best);
    return ALGSURF_OK;
}

static algsurf_status decide(query *q, algsurf_i_want want) {
    algsurf_zpoly p;
    const double *o = q->ray->origin, *d = q->ray->direction;
    if (!algsurf_i_region_bracket(q->region, q->ray, &q->chord, &q->edges)) return ALGSURF_OK;
    q->unit = algsurf_i_exact_unit(q->surface, q->ray, q->chord.t_min, q->chord.t_max);
    int made = algsurf_i_exact_form(&q->memory, q->surface, o, d, q->unit, &p, &q->scale);
    if (!made) return ALGSURF_E_NO_MEMORY;
    return p.degree < 0 ? ray_in_surface(q) : p.degree == 0 ? ALGSURF_OK : walk_chord(q, &p, want);
}

algsurf_status algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_i_region *region,
                                     const algsurf_ray *ray, algsurf_i_want want, size_t limit,
                                     algsurf_observer *observer, algsurf_i_ray_root *roots, int capacity,
                                     int *count) {
    algsurf_limb block[STACK_WORDS];
    query q = {.surface = surface,
               .region = region,
               .ray = ray,
               .observer = observer,
               .roots = roots,
               .capacity = capacity};
    algsurf_memory_begin(&q.memory, block, STACK_WORDS, limit);
    algsurf_memory_mark begin = algsurf_memory_here(&q.memory);
    algsurf_status status = decide(&q, want);
    algsurf_memory_release(&q.memory, begin);
    *count = q.count;
    return status;
}
