/* test_observe.c - what an observer is told is what the search does.
 *
 * Cells are held against exact Bernstein coefficients, points against the polynomial; the answer is the same,
 * bit by bit, whether anybody watches or not.  Breaks caught:
 *   a half of a split that is not told, or a whole                   cells_tile
 *   a sign taken out of a cell and not put back, a wrong place       check_cell
 *   a value of the scaled polynomial, or of the wrong point          check_points
 *   an observer that changes the way, a count left out               same_with_and_without
 *   integers that say nothing, or call themselves doubles            both engines must be seen */
#include <fenv.h>

#include "exact_ray.h"
#include "scenes.h"

enum { MOST = 4000, TOP = 12 };

typedef struct told_cell {
    algsurf_cell cell;
    signed char signs[ALGSURF_MAX_DEGREE + 1];
} told_cell;

typedef struct told_point {
    double t, value;
    int engine;
} told_point;

static struct {
    told_cell cell[MOST];
    told_point point[MOST];
    int cells, points, engine, other_rounding;
    algsurf_observer observer;
} told;

static void look_around(int engine) {
    volatile double one = 1, tiny = 0x1p-60;
    told.other_rounding |= one + tiny != 1 || one - tiny != 1;
    told.engine = engine > told.engine ? engine : told.engine;
}

static void take_cell(const algsurf_cell *cell, void *data) {
    assert_ptr_equal(data, &told);
    assert_true(told.cells < MOST && cell->degree <= ALGSURF_MAX_DEGREE);
    told_cell *c = told.cell + told.cells++;
    c->cell = *cell;
    if (cell->signs) memcpy(c->signs, cell->signs, (size_t)cell->degree + 1);
    look_around(cell->engine);
}

static void take_point(double t, double value, int engine, void *data) {
    assert_ptr_equal(data, &told);
    assert_true(told.points < MOST);
    told.point[told.points++] = (told_point){t, value, engine};
    look_around(engine);
}

static algsurf_observer *begin(void) {
    told.cells = told.points = told.engine = 0;
    told.observer = (algsurf_observer){
        .size = sizeof told.observer, .data = &told, .on_cell = take_cell, .on_point = take_point};
    return &told.observer;
}

static void check_counts(void) {
    assert_int_equal(told.observer.cells, told.cells);
    assert_int_equal(told.observer.evaluations, told.points);
    assert_int_equal(told.observer.engine, told.engine);
    assert_int_equal(told.other_rounding, 0);
}

/* ---- polynomials ---- */

typedef struct poly {
    int n;
    double c[TOP + 1], lo, hi;
} poly;

/* Known signs are those of the exact coefficients, which have as many variations as told, or fewer where a
 * sign is not known. */
static void check_signs(const poly *p, const told_cell *c) {
    mpq_t b[TOP + 1];
    int undecided = 0, variations = 0, last = 0;
    for (int j = 0; j <= p->n; j++) mpq_init(b[j]);
    exact_bernstein(b, p->c, p->n, c->cell.lo, c->cell.hi);
    for (int j = 0; j <= p->n; j++) {
        int sign = mpq_sgn(b[j]);
        undecided += c->signs[j] == ALGSURF_SIGN_UNDECIDED;
        if (c->signs[j] != ALGSURF_SIGN_UNDECIDED) assert_int_equal(c->signs[j], sign);
        variations += sign * last < 0;
        last = sign ? sign : last;
        mpq_clear(b[j]);
    }
    assert_true(undecided ? variations <= c->cell.variations : variations == c->cell.variations);
}

/* The ends are what was meant, no roundings of it. */
static int is_exact(double x) { return ldexp(x, 42) == floor(ldexp(x, 42)); }

static int check_cell(const poly *p, const told_cell *c) {
    const algsurf_cell *k = &c->cell;
    assert_true(k->lo <= k->hi && k->variations >= 0 && k->variations <= k->degree);
    assert_true(k->degree <= p->n);
    if (!k->signs || k->degree < p->n || k->lo == k->hi || !is_exact(k->lo) || !is_exact(k->hi)) return 0;
    check_signs(p, c);
    return 1;
}

static int by_begin(const void *a, const void *b) {
    const algsurf_cell *x = a, *y = b;
    return (x->lo > y->lo) - (x->lo < y->lo);
}

/* Each point of [lo,hi] is in a cell with at most one variation. */
static void check_tiles(double lo, double hi) {
    static algsurf_cell leaf[MOST];
    size_t count = 0;
    for (int i = 0; i < told.cells; i++)
        if (told.cell[i].cell.variations <= 1) leaf[count++] = told.cell[i].cell;
    qsort(leaf, count, sizeof *leaf, by_begin);
    double reached = lo;
    for (size_t i = 0; i < count && leaf[i].lo <= reached; i++) reached = fmax(reached, leaf[i].hi);
    assert_true(reached >= hi);
}

/* The first root, or all of them, watched and not. */
static int same_with_and_without(const poly *p, int all, algsurf_bracket *b) {
    algsurf_isolate_options watched = {.size = sizeof watched, .observer = begin()};
    algsurf_bracket plain[TOP];
    int count = -1, plain_count = -1;
    memset(b, 0, TOP * sizeof *b), memset(plain, 0, sizeof plain);
    fesetround(all ? FE_UPWARD : FE_TONEAREST);
    if (all) {
        assert_ok(algsurf_isolate_all(p->c, NULL, p->n, p->lo, p->hi, NULL, plain, TOP, &plain_count));
        assert_ok(algsurf_isolate_all(p->c, NULL, p->n, p->lo, p->hi, &watched, b, TOP, &count));
    } else {
        assert_ok(algsurf_isolate_first(p->c, NULL, p->n, p->lo, p->hi, NULL, plain, &plain_count));
        assert_ok(algsurf_isolate_first(p->c, NULL, p->n, p->lo, p->hi, &watched, b, &count));
    }
    fesetround(FE_TONEAREST);
    assert_int_equal(count, plain_count);
    assert_memory_equal(b, plain, sizeof plain);
    check_counts();
    return count;
}

static poly random_poly(uint64_t *seed) {
    poly p = {.n = 3 + random_int(seed, TOP - 3), .lo = -1, .hi = 1};
    for (int k = 0; k <= p.n; k++) p.c[k] = random_unit(seed);
    if (fabs(p.c[0]) < 0x1p-6) p.c[0] = 0.5; /* one piece holds all of it */
    return p;
}

/* Catches: see above. */
TEST(cells_tile) {
    uint64_t seed = 17;
    int checked = 0, halved = 0, found = 0;
    algsurf_bracket b[TOP];
    for (int round = 0; round < 1500; round++) {
        poly p = random_poly(&seed);
        int count = same_with_and_without(&p, 1, b);
        for (int i = 0; i < told.cells; i++) checked += check_cell(&p, told.cell + i);
        assert_true(told.cells > 0 && told.points == 0 && told.engine == ALGSURF_ENGINE_DOUBLES);
        check_tiles(p.lo, p.hi);
        found += count, halved += told.cells > 2;
        if (same_with_and_without(&p, 0, b)) check_tiles(p.lo, b[0].hi);
    }
    assert_true(checked > 4000 && halved > 500 && found > 1000);
}

static void times(double *c, int *n, double a) { /* (t - a) */
    c[++*n] = 0;
    for (int k = *n; k >= 0; k--) c[k] = (k > 0 ? c[k - 1] : 0) - a * c[k];
}

/* Integers, too: double roots, roots too close for doubles. */
TEST(integers_are_told) {
    uint64_t seed = 4;
    int checked = 0, lower = 0;
    algsurf_bracket b[TOP];
    for (int round = 0; round < 300; round++) {
        poly p = {.n = 0, .c = {1}, .lo = -4, .hi = 4};
        double root = ldexp(random_int(&seed, 200) - 100, -6) + 0x1p-9;
        times(p.c, &p.n, root);
        times(p.c, &p.n, root + (round % 2 ? 0 : 0x1p-40));
        for (int i = random_int(&seed, 3); i > 0; i--)
            times(p.c, &p.n, ldexp(random_int(&seed, 8) - 4, -1) + 0.25);
        (void)same_with_and_without(&p, 1, b);
        assert_int_equal(told.engine, ALGSURF_ENGINE_INTEGERS);
        for (int i = 0; i < told.cells; i++) {
            const algsurf_cell *k = &told.cell[i].cell;
            if (k->engine != ALGSURF_ENGINE_INTEGERS) continue;
            checked += check_cell(&p, told.cell + i);
            lower += k->degree < p.n;
            for (int j = 0; k->signs && j <= k->degree; j++)
                assert_int_not_equal(told.cell[i].signs[j], ALGSURF_SIGN_UNDECIDED);
        }
        (void)same_with_and_without(&p, 0, b);
    }
    assert_true(checked > 1000 && lower > 100);
}

/* In t although t^3 is looked at: half as many cells of the cubic root's line, and its root is in one. */
TEST(powers_are_told_in_t) {
    const poly p = {.n = 9, .c = {[0] = 6, [3] = -11, [6] = 6, [9] = -1}, .lo = 0, .hi = 4}; /* 1, 2, 3 */
    algsurf_bracket b[TOP];
    assert_int_equal(same_with_and_without(&p, 1, b), 3);
    int held = 0;
    for (int i = 0; i < told.cells; i++) {
        const algsurf_cell *k = &told.cell[i].cell;
        int inside = 0;
        for (int y = 1; y <= 3; y++) inside += k->lo < cbrt(y) && cbrt(y) < k->hi;
        assert_int_equal(k->degree, 3);
        assert_true(k->variations >= inside && (k->variations - inside) % 2 == 0);
        held += inside == 1 && k->variations == 1;
    }
    assert_true(held >= 3);
    check_tiles(0.5, 1.5);
}

TEST(bad_observers) {
    const double c[] = {-0.5, 0.25, 1, 3};
    algsurf_observer observer = {.size = 3};
    algsurf_isolate_options o = {.size = sizeof o, .observer = &observer};
    algsurf_bracket b[3];
    int count = 77;
    assert_int_equal(algsurf_isolate_first(c, NULL, 3, 0, 1, &o, b, &count), ALGSURF_E_SIZE);
    assert_int_equal(algsurf_isolate_all(c, NULL, 3, 0, 1, &o, b, 3, &count), ALGSURF_E_SIZE);
    observer.size = sizeof observer;
    o.size = 5;
    assert_int_equal(algsurf_isolate_first(c, NULL, 3, 0, 1, &o, b, &count), ALGSURF_E_SIZE);
    assert_int_equal(algsurf_isolate_all(c, NULL, 3, 0, 1, &o, b, 3, &count), ALGSURF_E_SIZE);
    assert_true(count == 77 && observer.cells == 0);
    o.size = sizeof o; /* no callbacks: it counts, and adds */
    assert_ok(algsurf_isolate_first(c, NULL, 3, 0, 1, &o, b, &count));
    size_t once = observer.cells;
    assert_ok(algsurf_isolate_first(c, NULL, 3, 0, 1, &o, b, &count));
    assert_true(once > 0 && observer.cells == 2 * once && observer.engine == ALGSURF_ENGINE_DOUBLES);
}

/* ---- rays ---- */

static const char *const equations[] = {
    "x^2 + y^2 + z^2 - 1",
    "1000 (x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8)",
    "4(2.618x^2 - y^2)(2.618y^2 - z^2)(2.618z^2 - x^2) - 4.236(x^2 + y^2 + z^2 - 1)^2",
    "(x^2 + y^2 + z^2 - 1)^2 (x - 3)", /* doubled: integers */
    "x^14 + y^14 + z^14 - 1",          /* by powers */
};
enum { EQUATIONS = sizeof equations / sizeof *equations, TERMS = 200 };

typedef struct scene {
    algsurf_surface *surface;
    algsurf_term terms[TERMS];
    int count, degree;
    algsurf_ray ray;
} scene;

/* Cells hold as many roots of the exact polynomial as they may; a little off their ends, which are rounded.
 */
static void check_ray_cells(const scene *s) {
    exact_sturm chain = exact_sturm_along(s->terms, s->count, s->degree, &s->ray);
    for (int i = 0; i < told.cells; i++) {
        const algsurf_cell *k = &told.cell[i].cell;
        double off = 1e-13 * fmax(fabs(k->lo), fabs(k->hi)), lo = k->lo + off, hi = k->hi - off;
        assert_true(k->lo <= k->hi);
        if (lo < hi) assert_true(exact_count_roots(&chain, lo, hi) <= k->variations);
    }
    exact_sturm_clear(&chain);
}

/* Values are P's there, up to rounding; by the default method doubles end next to the root. */
static void check_points(const scene *s, int method, const algsurf_hit *hit) {
    for (int i = 0; i < told.points; i++) {
        const told_point *p = told.point + i;
        double x[3], value, gradient[3], size = 0;
        if (p->engine == ALGSURF_ENGINE_INTEGERS && hit->multiplicity != 1) continue;
        for (int k = 0; k < 3; k++) x[k] = s->ray.origin[k] + p->t * s->ray.direction[k];
        assert_ok(algsurf_surface_value(s->surface, x, &value, gradient));
        for (int m = 0; m < s->count; m++)
            size += fabs(s->terms[m].a * pow(x[0], s->terms[m].i) * pow(x[1], s->terms[m].j) *
                         pow(x[2], s->terms[m].k));
        assert_true(fabs(p->value - value) <= 1e-7 * size);
    }
    if (hit->state == ALGSURF_STATE_HIT && told.engine == ALGSURF_ENGINE_DOUBLES &&
        method == ALGSURF_METHOD_DEFAULT) {
        assert_true(told.points > 0);
        assert_true(fabs(told.point[told.points - 1].t - hit->t) <= 1e-9 * (1 + fabs(hit->t)));
    }
}

/* The bracket is the last cell with one variation that holds the hit. */
static void check_bracket(const algsurf_hit *hit) {
    int held = 0;
    for (int i = 0; i < told.cells; i++) {
        const algsurf_cell *k = &told.cell[i].cell;
        held |= k->variations == 1 && k->lo <= hit->t && hit->t <= k->hi;
    }
    assert_true(held);
}

/* All three calls, watched and not; returns who decided. */
static int watch_ray(const scene *s, algsurf_intersect_options how) {
    algsurf_hit hit, plain, all[ALGSURF_MAX_DEGREE], plain_all[ALGSURF_MAX_DEGREE];
    int hidden = ALGSURF_STATE_MISS, plain_hidden = ALGSURF_STATE_MISS;
    const algsurf_surface *surface = s->surface;
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3, 0, 0}};
    int count = 0, plain_count = 0;
    memset(&hit, 0, sizeof hit), memset(&plain, 0, sizeof plain);
    memset(all, 0, sizeof all), memset(plain_all, 0, sizeof all);
    assert_ok(algsurf_intersect_first(surface, &ball, &s->ray, &how, &plain));
    assert_ok(
        algsurf_intersect_all(surface, &ball, &s->ray, &how, plain_all, ALGSURF_MAX_DEGREE, &plain_count));
    assert_ok(algsurf_occluded(surface, &ball, &s->ray, &how, &plain_hidden));
    how.observer = begin();
    assert_ok(algsurf_intersect_all(surface, &ball, &s->ray, &how, all, ALGSURF_MAX_DEGREE, &count));
    assert_true(count == plain_count && memcmp(all, plain_all, sizeof all) == 0);
    check_counts();
    check_ray_cells(s);
    how.observer = begin();
    assert_ok(algsurf_occluded(surface, &ball, &s->ray, &how, &hidden));
    assert_int_equal(hidden, plain_hidden);
    check_counts();
    how.observer = begin();
    fesetround(FE_DOWNWARD);
    algsurf_status status = algsurf_intersect_first(surface, &ball, &s->ray, &how, &hit);
    fesetround(FE_TONEAREST);
    assert_ok(status);
    assert_memory_equal(&hit, &plain, sizeof hit);
    check_counts();
    check_ray_cells(s);
    check_points(s, how.method, &hit);
    if (hit.state == ALGSURF_STATE_HIT && hit.multiplicity == 1 && how.absolute_tolerance == 0)
        check_bracket(&hit);
    return told.engine;
}

TEST(rays_are_watched) {
    static scene s;
    uint64_t seed = 99;
    int decided[3] = {0};
    for (int e = 0; e < EQUATIONS; e++) {
        s.surface = surface_of(equations[e]);
        s.count = (int)algsurf_surface_term_count(s.surface);
        s.degree = algsurf_surface_degree(s.surface);
        assert_true(s.count <= TERMS);
        assert_ok(algsurf_surface_terms(s.surface, s.terms));
        for (int round = 0; round < 32; round++) {
            algsurf_intersect_options how = {.size = sizeof how};
            how.method = (int)(round % 8 < 4 ? 0 : round % 4);
            s.ray = (algsurf_ray){.t_max = 20};
            for (int k = 0; k < 3; k++) {
                s.ray.origin[k] = 4 * random_unit(&seed);
                s.ray.direction[k] = 0.4 * random_unit(&seed) - 0.3 * s.ray.origin[k];
            }
            decided[watch_ray(&s, how)]++;
            how.tier = ALGSURF_TIER_BOUNDED;
            assert_true(watch_ray(&s, how) <= ALGSURF_ENGINE_DOUBLES);
        }
    }
    assert_true(random_salt ||
                (decided[ALGSURF_ENGINE_DOUBLES] > 50 && decided[ALGSURF_ENGINE_INTEGERS] > 10));
}

/* Where rays go side by side nobody can watch. */
TEST(packets_and_pictures_refuse) {
    algsurf_surface *surface;
    const double o[3] = {-3, 0.1, 0.2}, d[3] = {1, 0, 0};
    unsigned char hit = 77;
    algsurf_observer observer = {.size = sizeof observer};
    algsurf_intersect_options how = {.size = sizeof how, .observer = &observer};
    const algsurf_ray_packet rays = {
        .size = sizeof rays, .count = 1, .origin = {o, o + 1, o + 2}, .direction = {d, d + 1, d + 2}};
    const algsurf_hit_packet hits = {.size = sizeof hits, .state = &hit};
    const algsurf_ray ray = {{o[0], o[1], o[2]}, {d[0], d[1], d[2]}, 0, 9};
    algsurf_hit one;
    surface = surface_of(equations[0]);
    algsurf_scene *picture = scene_of(surface, NULL, NULL, NULL);
    assert_int_equal(algsurf_intersect_packet(surface, NULL, &rays, &how, &hits), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_occluded_packet(surface, NULL, &rays, &how, &hit), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_set_intersect_options(picture, &how), ALGSURF_E_ARGUMENT);
    assert_true(hit == 77 && observer.cells == 0);
    observer.size = 0;
    assert_int_equal(algsurf_intersect_first(surface, NULL, &ray, &how, &one), ALGSURF_E_SIZE);
    how.observer = NULL;
    assert_ok(algsurf_intersect_packet(surface, NULL, &rays, &how, &hits));
    assert_ok(algsurf_scene_set_intersect_options(picture, &how));
}
