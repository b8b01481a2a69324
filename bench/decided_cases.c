/* decided_cases.c - see decided.h.
 *
 * All random surfaces of degree n are made of
 *     L  a linear form with small whole coefficients, zero at the origin,
 *     H  a dense polynomial, positive in the extent,
 *     K  a dense polynomial,
 * and all rays pass the plane L = 0 at t = 1 or so, at no place of few digits:
 *     clear    L H            one simple root
 *     gap      L^2 H - e      two simple roots, where L sqrt(H) = -sqrt(e) and sqrt(e)
 *     tangent  L^2 H + (x - y) K, the ray in the plane x = y: a double root; the surface is smooth there
 *     double   L^2 H          a double root everywhere (of degree 2 the square of L, which doubles decide)
 *     inside   (x - y) K, the ray in the plane x = y
 *     ball     (x^2 + y^2 + z^2 - 9) H, in the ball of radius 3: two simple roots, both on the extent
 *
 * Everything is exact: coefficients are whole numbers, or whole numbers over powers of two that depend on
 * their degree only, and no sum exceeds 2^53 (`bits` below).  H = C + sum c_ijk x^i y^j z^k in the unit ball
 * with C = (1 + 2 deg H)(1 + sum |c|): so |grad H| <= sqrt(3) deg H sum |c| < H, hence L^2 H grows with |L|
 * along the ray as far as the extent goes (|L / L'| <= 2 / |d| there), and the gap has no more than its two
 * roots.
 */
#include "decided.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "rays.h"

const char *const kind_names[KINDS] = {"clear",   "end",    "gap-20", "gap-60",  "gap-200",
                                       "tangent", "double", "inside", "own-ball"};

/* ---- polynomials in x, y, z ---- */

typedef struct dense {
    int degree;
    double *a; /* of x^i y^j z^k: entry (i m + j) m + k, m = degree + 1; 0 where i + j + k > degree */
} dense;

static double *entry(const dense *p, int i, int j, int k) {
    size_t m = (size_t)p->degree + 1;
    return &p->a[((size_t)i * m + (size_t)j) * m + (size_t)k];
}

static dense make(int degree) {
    size_t m = (size_t)degree + 1;
    return (dense){degree, must_allocate(m * m * m, sizeof(double))};
}

typedef struct walk {
    int i, j, k;
} walk;

/* The exponents after w, of degree at most `degree`; 0 at the end. */
static int next(walk *w, int degree) {
    if (w->i + w->j + w->k < degree) return ++w->k, 1;
    w->k = 0;
    if (w->i + w->j < degree) return ++w->j, 1;
    w->j = 0;
    return w->i++ < degree;
}

static void add_product(dense *sum, const dense *p, const dense *q) {
    walk v = {0, 0, 0};
    do {
        double a = *entry(p, v.i, v.j, v.k);
        walk w = {0, 0, 0};
        if (a == 0) continue;
        do *entry(sum, v.i + w.i, v.j + w.j, v.k + w.k) += a * *entry(q, w.i, w.j, w.k);
        while (next(&w, q->degree));
    } while (next(&v, p->degree));
}

static dense product(const dense *p, const dense *q) {
    dense r = make(p->degree + q->degree);
    add_product(&r, p, q);
    return r;
}

static double whole(measure_random *random, int bits) {
    return nearbyint(measure_uniform(random, -1, 1) * ldexp(1, bits));
}

/* Whole coefficients of `bits` bits, those of degree m over 2^(2m) in a wide extent; returns their sum. */
static double fill(dense *p, measure_random *random, int bits, int wide) {
    double sum = 0;
    walk w = {0, 0, 0};
    do {
        double c = whole(random, bits);
        *entry(p, w.i, w.j, w.k) = wide ? ldexp(c, -2 * (w.i + w.j + w.k)) : c;
        sum += fabs(c);
    } while (next(&w, p->degree));
    return sum;
}

static dense make_positive(int degree, measure_random *random, int bits, int wide) {
    dense h = make(degree);
    *entry(&h, 0, 0, 0) = (1 + 2 * degree) * (1 + fill(&h, random, bits, wide));
    return h;
}

/* As many bits as leave room below 2^53: with N = C(deg + 3, 3) terms, H's coefficients sum up to less than
 * 2 (1 + 2 deg) (1 + N 2^bits), those of L to at most 2^6; L^2 H must fit. */
static int bits_for(int degree) {
    double terms = (degree + 1.0) * (degree + 2.0) * (degree + 3.0) / 6;
    int room = 40 - (int)ceil(log2((1 + 2 * degree) * terms));
    return room > 20 ? 20 : room;
}

/* ---- surfaces ---- */

static dense linear(double x, double y, double z) {
    dense l = make(1);
    *entry(&l, 1, 0, 0) = x;
    *entry(&l, 0, 1, 0) = y;
    *entry(&l, 0, 0, 1) = z;
    return l;
}

/* x^2 + y^2 + z^2 - 9 */
static dense sphere(void) {
    dense s = make(2);
    *entry(&s, 2, 0, 0) = *entry(&s, 0, 2, 0) = *entry(&s, 0, 0, 2) = 1;
    *entry(&s, 0, 0, 0) = -9;
    return s;
}

static dense make_surface(const dense *l, int degree, kind which, measure_random *random) {
    static const int gaps[KINDS] = {[KIND_GAP_20] = 20, [KIND_GAP_60] = 60, [KIND_GAP_200] = 200};
    const int ball = which == KIND_BALL, clear = which <= KIND_END, rest = degree - (clear ? 1 : 2);
    dense p = make(degree), k = make(degree - 1), plane = linear(1, -1, 0);
    dense square = ball ? sphere() : product(l, l);
    if (which == KIND_TANGENT || which == KIND_INSIDE) {
        (void)fill(&k, random, 20, 0);
        add_product(&p, &plane, &k);
    }
    if (which != KIND_INSIDE) {
        dense h = make_positive(rest, random, bits_for(rest), ball);
        add_product(&p, clear ? l : &square, &h);
        if (gaps[which]) /* L is of size 32 or so beside a point of the unit ball */
            *entry(&p, 0, 0, 0) = -ldexp(*entry(&h, 0, 0, 0), 8 - 2 * gaps[which]);
        free(h.a);
    }
    free(k.a);
    free(plane.a);
    free(square.a);
    return p;
}

static algsurf_surface *surface_of(const dense *p) {
    size_t count = 0, most = (size_t)(p->degree + 1) * (size_t)(p->degree + 2) * (size_t)(p->degree + 3) / 6;
    algsurf_term *terms = must_allocate(most, sizeof *terms);
    algsurf_surface *surface;
    walk w = {0, 0, 0};
    do {
        double a = *entry(p, w.i, w.j, w.k);
        if (a != 0) terms[count++] = (algsurf_term){w.i, w.j, w.k, a};
    } while (next(&w, p->degree));
    must(algsurf_surface_from_terms(terms, count, &surface), "a ray is refused");
    free(terms);
    return surface;
}

/* ---- rays ---- */

static void random_point(measure_random *random, double least, double most, double x[3]) {
    double size;
    do {
        for (int k = 0; k < 3; k++) x[k] = measure_uniform(random, -most, most);
        size = hypot(hypot(x[0], x[1]), x[2]);
    } while (size < least || size > most);
}

static double form_at(const dense *l, const double x[3]) {
    return *entry(l, 1, 0, 0) * x[0] + *entry(l, 0, 1, 0) * x[1] + *entry(l, 0, 0, 1) * x[2];
}

/* From outside of the extent through a point of L = 0 near its centre, at t = 1; in the plane x = y.  Not
 * along L = 0. */
static algsurf_ray random_ray(const dense *l, measure_random *random) {
    algsurf_ray ray = {.t_max = INFINITY};
    double *o = ray.origin, *d = ray.direction, target[3];
    do {
        random_point(random, 4, 5, o);
        o[1] = o[0];
        target[0] = target[1] = measure_uniform(random, -0.3, 0.3);
        target[2] = 0;
        target[2] = -form_at(l, target) / *entry(l, 0, 0, 1);
        for (int k = 0; k < 3; k++) d[k] = target[k] - o[k];
    } while (fabs(form_at(l, d)) < 20 || hypot(hypot(o[0], o[1]), o[2]) < 3.5);
    return ray;
}

/* Where the ray enters the extent, about. */
static double entry_of(const example *e, const algsurf_ray *ray) {
    algsurf_ray chord;
    if (!rays_clip(ray, &e->extent, &chord))
        cli_fail(CLI_BROKEN, "%s: a ray beside the extent", kind_names[e->kind]);
    return chord.t_min;
}

/* The first hit is at or after the double t, certified. */
static int hits_from(const example *e, const algsurf_ray *from, double t) {
    algsurf_ray ray = *from;
    algsurf_hit hit;
    ray.t_min = t;
    ray.t_max = fmin(ray.t_max, t + 1e-9 * fabs(t));
    must(algsurf_intersect_first(e->equation, &e->extent, &ray, NULL, &hit), "a ray is refused");
    return hit.state == ALGSURF_STATE_HIT;
}

/* The last double from which the ray still hits what it hits at t or so. */
static void begin_at_root(const example *e, size_t i) {
    enum { FAR = 100000 };
    double t = e->t[i], after;
    algsurf_hit hit;
    must(algsurf_intersect_first(e->equation, &e->extent, &e->ray[i], NULL, &hit), "a ray is refused");
    t = hit.t;
    int steps = 0;
    while (steps++ < FAR && !hits_from(e, &e->ray[i], t)) t = nextafter(t, 0);
    while (steps++ < FAR && hits_from(e, &e->ray[i], after = nextafter(t, DBL_MAX))) t = after;
    if (steps >= FAR) cli_fail(CLI_BROKEN, "%s: no end of a ray at its root", e->surface);
    e->ray[i].t_min = t;
    e->t[i] = t;
}

static void take_rays(example *e, size_t count) {
    e->count = count;
    e->ray = must_allocate(count, sizeof *e->ray);
    e->t = must_allocate(count, sizeof *e->t);
}

void example_random(example *e, int degree, kind which, size_t count, int seed) {
    static const int roots[KINDS] = {1, 1, 2, 2, 2, 1, 1, 1, 2},
                     multiplicity[KINDS] = {1, 1, 1, 1, 1, 2, 2, 0, 1};
    measure_random random = {((uint64_t)seed << 32) + (uint64_t)degree * 100 + (uint64_t)which};
    dense l = linear(whole(&random, 2), 4 + whole(&random, 2), 13), p;
    double radius = which == KIND_BALL ? 3 : 1;
    *e = (example){.surface = "random", .degree = degree, .kind = which, .multiplicity = multiplicity[which]};
    e->least = e->most = roots[which];
    e->extent = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {radius, 0, 0}};
    p = make_surface(&l, degree, which, &random);
    e->equation = surface_of(&p);
    take_rays(e, count);
    for (size_t i = 0; i < count; i++) {
        e->ray[i] = random_ray(&l, &random);
        e->t[i] = which == KIND_INSIDE || which == KIND_BALL ? entry_of(e, &e->ray[i]) : 1;
        if (which == KIND_END) begin_at_root(e, i);
    }
    free(p.a);
    free(l.a);
}

/* ---- named surfaces ---- */

/* The sign of P at t, or 0: not certain. */
static int sign_at(const example *e, const algsurf_ray *ray, double t) {
    double x[3], value, bound;
    for (int k = 0; k < 3; k++) x[k] = fma(t, ray->direction[k], ray->origin[k]);
    must(algsurf_surface_value(e->equation, x, &value, &bound), "a ray is refused");
    return value > bound ? 1 : value < -bound ? -1 : 0;
}

/* Does double arithmetic prove a hit, and does P change its sign beside it? */
static int is_clear(const example *e, const algsurf_ray *ray, double *t) {
    const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    algsurf_hit hit;
    must(algsurf_intersect_first(e->equation, &e->extent, ray, &bounded, &hit), "a ray is refused");
    *t = hit.t;
    return hit.state == ALGSURF_STATE_HIT &&
           sign_at(e, ray, hit.t * (1 - 1e-6)) * sign_at(e, ray, hit.t * (1 + 1e-6)) < 0;
}

void example_named(example *e, const char *name, kind which, size_t count, int seed) {
    enum { WIDTH = 1024, HEIGHT = 768 };
    const catalogue_entry *entry = catalogue_find(name);
    measure_random random = {((uint64_t)seed << 32) + 1 + (uint64_t)which};
    const algsurf_camera camera = rays_catalogue_camera(entry);
    *e = (example){.surface = name, .degree = entry->degree, .kind = which, .extent = entry->extent};
    e->multiplicity = 1;
    e->least = 1;
    e->most = e->degree;
    e->equation = rays_surface(entry);
    take_rays(e, count);
    for (size_t i = 0; i < count;) {
        double x = measure_uniform(&random, 0, WIDTH), y = measure_uniform(&random, 0, HEIGHT);
        must(algsurf_camera_ray(&camera, WIDTH, HEIGHT, x, y, &e->ray[i]), "a ray is refused");
        if (!is_clear(e, &e->ray[i], &e->t[i])) continue;
        if (which == KIND_END) begin_at_root(e, i);
        i++;
    }
}

int example_hit_at(const example *e, size_t i, double t) { return fabs(t - e->t[i]) <= 1e-3 * fabs(e->t[i]); }

void example_free(example *e) {
    algsurf_surface_free(e->equation);
    free(e->ray);
    free(e->t);
}
