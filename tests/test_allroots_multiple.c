/* test_allroots_multiple.c - multiple roots of exact real polynomials: one box each, narrow, rightly counted.
 *
 * Products of known linear and quadratic factors with integer coefficients, multiplied out in integers; a
 * case counts if all coefficients are doubles.  Roots are -b/2a +- sqrt(v), v rational, so that whether a box
 * holds one is decided in rationals.  Factors of higher degree are judged by their own boxes. (Seen to fail
 * with a factor's multiplicity off by one, a factor left out, the unit of the variable forgotten, the root 0
 * left out, boxes that are not joined, radii of rounded factors left out.) */
#include "exact_zpolys.h"

#include "allroots_case.h"
#include "unit.h"

enum { MOST_FACTORS = 12, MOST_DEGREE = 256, MOST_BOXES = 100000 };

/* ---- memory that may fail ---- */

void *__real_malloc(size_t size);
void __real_free(void *p);
void *__wrap_malloc(size_t size);
void __wrap_free(void *p);
static int malloc_fails, blocks;

void *__wrap_malloc(size_t size) {
    if (malloc_fails) return NULL;
    blocks++;
    return __real_malloc(size);
}

void __wrap_free(void *p) {
    if (p) blocks--;
    __real_free(p);
}

/* ---- polynomials ---- */

/* a x^2 + b x + c, to the power of m; a = 0: linear. */
typedef struct factor {
    long a, b, c;
    int m;
} factor;

typedef struct product {
    int n, count, unit; /* of the variable: the roots are 2^unit times those of the factors */
    factor f[MOST_FACTORS];
    exact_zpoly *p;
    double c[MOST_DEGREE + 1];
} product;

static uint64_t seed = 20240811;
static double width[MOST_BOXES]; /* of all boxes judged, in ulps of the root's modulus */
static int widths;

static void begin(product *t) {
    t->n = t->count = t->unit = 0;
    exact_zpoly_constant(t->p, 1);
}

static void times(product *t, const long *c, int degree, int m) {
    exact_zpoly *f = exact_zpoly_new();
    f->n = degree;
    for (int k = 0; k <= degree; k++) mpz_set_si(f->c[k], c[k]);
    for (int i = 0; i < m; i++) exact_zpoly_multiply(t->p, t->p, f);
    exact_zpoly_free(f);
}

static void join_factor(product *t, long a, long b, long c, int m) {
    const long f[3] = {c, b, a};
    t->f[t->count++] = (factor){a, b, c, m};
    times(t, f, a ? 2 : 1, m);
}

/* The coefficients as doubles, if they are doubles. */
static int finish(product *t, int exponent) {
    t->n = t->p->n;
    if (t->n > MOST_DEGREE) return 0;
    mpq_t exact, back;
    mpq_inits(exact, back, NULL);
    int fits = 1;
    for (int k = 0; k <= t->n && fits; k++) {
        mpq_set_z(exact, t->p->c[k]);
        double d = mpz_get_d(t->p->c[k]);
        t->c[k] = ldexp(d, exponent - k * t->unit);
        fits = isfinite(t->c[k]) && ldexp(t->c[k], k * t->unit - exponent) == d;
        if (fits) mpq_set_d(back, d), fits = mpq_equal(exact, back);
    }
    mpq_clears(exact, back, NULL);
    return fits;
}

/* ---- the verdict ---- */

/* The sign of t - side sqrt(v), v >= 0. */
static int compare_root(const mpq_t t, int side, const mpq_t v) {
    mpq_t s;
    if (mpq_sgn(t) * side <= 0) return mpq_sgn(t) ? mpq_sgn(t) : mpq_sgn(v) * -side;
    mpq_init(s), mpq_mul(s, t, t);
    int sign = mpq_cmp(s, v);
    mpq_clear(s);
    return sign * side;
}

/* Is middle + side sqrt(v) in x? */
static int holds(algsurf_interval x, const mpq_t middle, int side, const mpq_t v) {
    mpq_t lo, hi;
    mpq_inits(lo, hi, NULL);
    exact_set(lo, x.lo), exact_set(hi, x.hi);
    mpq_sub(lo, lo, middle), mpq_sub(hi, hi, middle);
    int inside = compare_root(lo, side, v) <= 0 && compare_root(hi, side, v) >= 0;
    mpq_clears(lo, hi, NULL);
    return inside;
}

/* How many roots of f are in the box, each once; *real: whether they are. */
static int roots_in(const factor *f, int unit, algsurf_cinterval box, int *real) {
    mpq_t h, v, zero;
    mpq_inits(h, v, zero, NULL);
    if (f->a)
        mpq_set_si(h, -f->b, 1), mpq_set_si(zero, 2 * f->a, 1), mpq_div(h, h, zero);
    else
        mpq_set_si(h, -f->c, 1), mpq_set_si(zero, f->b, 1), mpq_div(h, h, zero);
    if (f->a) {
        mpq_mul(v, h, h);
        mpq_set_si(zero, f->c, 1), mpq_sub(v, v, zero);
        if (f->a != 1) { /* v = h^2 - c/a */
            mpq_add(v, v, zero);
            mpq_t a;
            mpq_init(a), mpq_set_si(a, f->a, 1);
            mpq_div(zero, zero, a), mpq_sub(v, v, zero), mpq_clear(a);
        }
    }
    mpq_set_ui(zero, 0, 1);
    *real = mpq_sgn(v) >= 0;
    mpq_abs(v, v);
    mpq_t power;
    mpq_init(power), exact_set(power, ldexp(1, unit));
    mpq_mul(h, h, power), mpq_mul(v, v, power), mpq_mul(v, v, power);
    int count = 0;
    for (int side = -1; side <= (f->a ? 1 : -1); side += 2)
        count += *real ? holds(box.re, h, side, v) && holds(box.im, zero, side, zero)
                       : holds(box.re, h, side, zero) && holds(box.im, zero, side, v);
    mpq_clears(h, v, zero, power, NULL);
    return count;
}

static void give_up(const product *t, const algsurf_complex_root *e, int count, const char *what) {
    exact_zpoly_print("p", t->p);
    for (int i = 0; i < t->count; i++)
        fprintf(stderr, "(%ld x^2 + %ld x + %ld)^%d ", t->f[i].a, t->f[i].b, t->f[i].c, t->f[i].m);
    fprintf(stderr, "unit %d\n", t->unit);
    for (int i = 0; i < count; i++)
        fprintf(stderr, "[%a, %a] + [%a, %a] i, multiplicity %d, real %d\n", e[i].box.re.lo, e[i].box.re.hi,
                e[i].box.im.lo, e[i].box.im.hi, e[i].multiplicity, e[i].real);
    fail_msg("%s", what);
}

static double ulps(const algsurf_complex_root *e) {
    double size =
        fmax(fmax(fabs(e->box.re.lo), fabs(e->box.re.hi)), fmax(fabs(e->box.im.lo), fabs(e->box.im.hi)));
    double w = fmax(e->box.re.hi - e->box.re.lo, e->box.im.hi - e->box.im.lo);
    return w > 0 ? w / (nextafter(size, HUGE_VAL) - size) : 0;
}

/* What is wrong; *alone grows by the boxes that hold one root, whatever its multiplicity. */
static const char *wrong(const product *t, const algsurf_complex_root *e, int count, int *alone) {
    const char *what = case_boxes_wrong(t->n, e, count);
    if (!what && !case_mirrored(e, count)) what = "boxes that are not conjugate";
    for (int i = 0; i < count && !what; i++) {
        int different = 0, all = 0, real = 0, its;
        for (int j = 0; j < t->count; j++) {
            int inside = roots_in(t->f + j, t->unit, e[i].box, &its);
            different += inside, all += inside * t->f[j].m;
            if (inside) real = its;
        }
        if (all != e[i].multiplicity) what = "a box that does not hold as many roots as it says";
        if (different == 1 && e[i].real != real) what = "reality";
        if (different != 1) continue;
        ++*alone;
        if (widths < MOST_BOXES) width[widths++] = ulps(e + i);
    }
    return what;
}

static int distinct(const product *t) {
    int sum = 0;
    for (int j = 0; j < t->count; j++) sum += t->f[j].a ? 2 : 1;
    return sum;
}

/* Solves and judges; returns how many roots, each counted once, have no box of their own. */
static int judge(const product *t) {
    algsurf_complex_root e[MOST_DEGREE];
    int count = 0, alone = 0, before = blocks;
    algsurf_status status;
    if (t->n <= ALGSURF_MAX_DEGREE) {
        status = algsurf_complex_roots_of_real(t->c, NULL, t->n, e, &count);
    } else {
        algsurf_complex_solver *solver;
        algsurf_complex z[MOST_DEGREE + 1];
        for (int k = 0; k <= t->n; k++) z[k] = (algsurf_complex){t->c[k], 0};
        assert_ok(algsurf_complex_solver_create(t->n, &solver));
        status = algsurf_complex_solver_run(solver, z, NULL, t->n, NULL, e, &count, NULL);
        algsurf_complex_solver_free(solver);
    }
    assert_int_equal(blocks, before);
    const char *what = status == ALGSURF_OK ? wrong(t, e, count, &alone) : algsurf_status_text(status);
    if (what) give_up(t, e, count, what);
    return distinct(t) - alone;
}

static void must(product *t, int unit) {
    t->unit = unit;
    if (!finish(t, 0)) give_up(t, NULL, 0, "coefficients are no doubles");
    if (judge(t)) give_up(t, NULL, 0, "a root without a box of its own");
}

static product *open_product(void) {
    product *t = malloc(sizeof *t);
    if (!t) abort();
    t->p = exact_zpoly_new();
    begin(t);
    return t;
}

static void close_product(product *t) {
    exact_zpoly_free(t->p);
    free(t);
}

/* ---- tests ---- */

TEST(test_named) {
    static const struct {
        int count;
        factor f[6];
    } list[] = {
        {1, {{0, 1, -1, 4}}},
        {1, {{0, 3, -1, 5}}},
        {1, {{1, 0, 1, 3}}},
        {1, {{0, 1, -1, 56}}},
        {1, {{1, 0, 1, 32}}},
        {1, {{1, 0, -2, 32}}},
        {1, {{1, 1, 1, 28}}},
        {2, {{0, 1, 0, 3}, {0, 1, -1, 4}}}, /* the root 0 */
        {2, {{0, 1, 0, 1}, {1, 1, 2, 6}}},
        {3, {{0, 1, -1, 4}, {0, 1, -2, 3}, {0, 1, -3, 2}}},
        {3, {{0, 1, -1, 4}, {1, 0, 1, 3}, {1, 2, 5, 2}}},
        {4, {{1, 0, 1, 3}, {1, 0, 2, 3}, {0, 1, 1, 2}, {0, 1, -5, 1}}},
        /* beside clusters of simple roots: gaps of 2^-33 and 2^-20 */
        {3, {{0, 1, -2, 4}, {0, 1, -1, 1}, {0, 1L << 33, -(1L << 33) - 1, 1}}},
        {3, {{0, 1, 2, 3}, {0, 1L << 20, -1, 1}, {0, 1L << 20, -2, 1}}},
        /* and of multiple ones */
        {2, {{0, 1, -1, 2}, {0, 1L << 17, -(1L << 17) - 1, 2}}},
        {2, {{0, 1, -1, 2}, {0, 1L << 33, -(1L << 33) - 1, 1}}},
        {3, {{1, 0, 1, 2}, {1L << 20, 2, 1L << 20, 1}, {0, 1, -7, 1}}},
        /* a factor whose coefficients are no doubles */
        {2, {{0, 1, -1, 2}, {1L << 52, (1L << 53) + 1, 1L << 52, 1}}},
        {2, {{0, 1, 1, 2}, {1L << 52, -(1L << 53) - 1, 1L << 52, 1}}},
        {3, {{0, 1, 0, 1}, {0, 1, 1, 2}, {1L << 52, -(1L << 53) - 1, 1L << 52, 1}}},
    };
    product *t = open_product();
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        for (int unit = -200; unit <= 200; unit += 100) {
            if (unit && list[i].count == 1 && list[i].f[0].m > 6) continue; /* beyond the range of double */
            begin(t);
            for (int j = 0; j < list[i].count; j++) {
                const factor *f = list[i].f + j;
                join_factor(t, f->a, f->b, f->c, f->m);
            }
            if (t->p->n * abs(unit) < 900) must(t, unit);
        }
    close_product(t);
}

/* Roots of different multiplicity that are neighbours: 1 and 1 + 2^-k. */
TEST(test_neighbours) {
    product *t = open_product();
    int together = 0;
    for (int k = 45; k <= 51; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            begin(t);
            join_factor(t, 0, 1, -1, 2), join_factor(t, 0, 1L << k, -(1L << k) - sign, 1);
            assert_true(finish(t, 0));
            together += judge(t) != 0;
        }
    assert_int_equal(together, 0);
    close_product(t);
}

static int same_roots(const factor *f, const factor *g) { /* a root in common */
    exact_zpoly *p = exact_zpoly_new(), *q = exact_zpoly_new();
    const factor *both[] = {f, g};
    exact_zpoly *to[] = {p, q};
    for (int i = 0; i < 2; i++) {
        to[i]->n = both[i]->a ? 2 : 1;
        mpz_set_si(p == to[i] ? p->c[0] : q->c[0], both[i]->c);
        mpz_set_si(to[i]->c[1], both[i]->b), mpz_set_si(to[i]->c[2], both[i]->a);
    }
    exact_zpoly_euclid(p, q);
    int common = p->n > 0;
    exact_zpoly_free(p), exact_zpoly_free(q);
    return common;
}

/* A random factor that is squarefree and new. */
static int random_factor(const product *t, int size, factor *f) {
    int odd = 2 * size + 1;
    f->a = random_int(&seed, 2) ? 1 + random_int(&seed, 3) : 0;
    f->b = f->a ? random_int(&seed, odd) - size : 1 + random_int(&seed, 4);
    f->c = random_int(&seed, odd) - size;
    if (f->a && f->b * f->b == 4 * f->a * f->c) return 0;
    for (int j = 0; j < t->count; j++)
        if (same_roots(t->f + j, f)) return 0;
    return 1;
}

TEST(test_random) {
    product *t = open_product();
    int cases = 0, multiple = 0, roots = 0, lost = 0;
    for (int round = 0; round < 5000; round++) {
        int factors = 1 + random_int(&seed, 5), most = 1 + random_int(&seed, 8);
        int size = 1 + random_int(&seed, round % 2 ? 3 : 30), several = 0;
        begin(t);
        for (int j = 0; j < factors; j++) {
            factor f;
            if (!random_factor(t, size, &f)) continue;
            int m = 1 + random_int(&seed, most);
            if (t->p->n + 2 * m > ALGSURF_MAX_DEGREE) continue;
            join_factor(t, f.a, f.b, f.c, m);
            several += m > 1;
        }
        if (t->p->n < 1) continue;
        t->unit = random_int(&seed, 21) - 10;
        if (!finish(t, random_int(&seed, 101) - 50)) continue;
        cases++, multiple += several > 0, roots += distinct(t);
        lost += judge(t);
    }
    close_product(t);
    print_message("%d cases, %d with multiple roots, %d roots, %d without a box of their own\n", cases,
                  multiple, roots, lost);
    assert_true(multiple > 1250 && lost <= roots / 1000);
}

/* Q^m R with factors of any degree: every box must lie over that of one root of one factor, which says how
 * often it counts. */
static void judge_powers(product *t, const long *q, int dq, int m, const long *r, int dr) {
    algsurf_complex_root e[MOST_DEGREE], of_q[MOST_DEGREE], of_r[MOST_DEGREE];
    algsurf_complex z[MOST_DEGREE + 1];
    algsurf_complex_solver *solver;
    int count, in_q, in_r = 0;
    assert_ok(algsurf_complex_solver_create(MOST_DEGREE, &solver));
    for (int k = 0; k <= dq; k++) z[k] = (algsurf_complex){(double)q[k], 0};
    assert_ok(algsurf_complex_solver_run(solver, z, NULL, dq, NULL, of_q, &in_q, NULL));
    for (int k = 0; k <= dr; k++) z[k] = (algsurf_complex){(double)r[k], 0};
    if (dr) assert_ok(algsurf_complex_solver_run(solver, z, NULL, dr, NULL, of_r, &in_r, NULL));
    for (int k = 0; k <= t->n; k++) z[k] = (algsurf_complex){t->c[k], 0};
    assert_ok(algsurf_complex_solver_run(solver, z, NULL, t->n, NULL, e, &count, NULL));
    algsurf_complex_solver_free(solver);
    const char *what = case_boxes_wrong(t->n, e, count);
    if (!what && !case_mirrored(e, count)) what = "boxes that are not conjugate";
    if (count != in_q + in_r || in_q != dq || in_r != dr) what = "a root without a box of its own";
    for (int i = 0; i < count && !what; i++) {
        int met_q = 0, met_r = 0;
        for (int j = 0; j < in_q; j++) met_q += case_meet(e[i].box, of_q[j].box) && e[i].real == of_q[j].real;
        for (int j = 0; j < in_r; j++) met_r += case_meet(e[i].box, of_r[j].box) && e[i].real == of_r[j].real;
        if (met_q + met_r != 1 || e[i].multiplicity != m * met_q + met_r) what = "no root of the factors";
        if (widths < MOST_BOXES) width[widths++] = ulps(e + i);
    }
    if (what) give_up(t, e, count, what);
}

TEST(test_powers) {
    product *t = open_product();
    int cases = 0, degree = 0;
    for (int round = 0; round < 300; round++) {
        long q[21] = {0}, r[21] = {0};
        int dq = 3 + random_int(&seed, round % 4 ? 6 : 18), dr = random_int(&seed, 6);
        int m = 2 + random_int(&seed, round % 4 ? 4 : 12), size = 1 + random_int(&seed, 4);
        for (int k = 0; k <= dq; k++)
            q[k] = round % 4 && k % 2 == 0 ? random_int(&seed, 2 * size + 1) - size : 0;
        q[0] = 1 + random_int(&seed, 3), q[dq] = 1, q[1] += round % 3;
        for (int k = 0; k <= dr; k++) r[k] = random_int(&seed, 21) - 10;
        r[0] = 11, r[dr] = 1; /* a rational root of R divides 11; Q(0) does not */
        begin(t);
        times(t, q, dq, 1), times(t, r, dr, 1);
        exact_zpoly *s = exact_zpoly_new(), *d = exact_zpoly_new();
        exact_zpoly_set(s, t->p), exact_zpoly_derive(d, s), exact_zpoly_euclid(s, d);
        int squarefree = s->n == 0;
        exact_zpoly_free(s), exact_zpoly_free(d);
        times(t, q, dq, m - 1);
        if (!squarefree || !finish(t, 0)) continue;
        judge_powers(t, q, dq, m, r, dr);
        cases++, degree = t->n > degree ? t->n : degree;
    }
    close_product(t);
    print_message("%d cases, highest degree %d\n", cases, degree);
    assert_true(cases > 100 && degree > 100);
}

/* Degrees above 64. */
TEST(test_high) {
    static const int degree[][2] = {{10, 20}, {20, 10}, {50, 4}, {100, 2},
                                    {16, 5},  {4, 50},  {7, 25}, {1, 50}};
    product *t = open_product();
    for (size_t i = 0; i < sizeof degree / sizeof *degree; i++) {
        long q[101] = {0}, r[2] = {7, 2};
        int dq = degree[i][0], dr = (int)i % 2;
        q[dq] = 1, q[0] = i % 4 == 2 ? -3 : 1;
        if (!dr) r[0] = 1;
        begin(t);
        times(t, q, dq, degree[i][1]), times(t, r, dr, 1);
        if (!finish(t, 0)) {
            print_message("no doubles: %d %d\n", dq, degree[i][1]);
            continue;
        }
        judge_powers(t, q, dq, degree[i][1], r, dr);
    }
    close_product(t);
}

/* What is not exact keeps its cluster; what is not real does not. */
TEST(test_clusters_stay) {
    product *t = open_product();
    algsurf_complex_root e[ALGSURF_MAX_DEGREE];
    algsurf_complex z[5];
    double r[5] = {0};
    int count;
    begin(t);
    join_factor(t, 0, 1, -1, 4);
    assert_true(finish(t, 0));
    for (int k = 0; k < 5; k++) z[k] = (algsurf_complex){t->c[k], 0};
    assert_ok(algsurf_complex_roots(z, r, 4, e, &count)); /* radii of 0 are exact */
    assert_true(count == 1 && e[0].multiplicity == 4 && e[0].real && ulps(e) <= 2);
    r[2] = 0x1p-40;
    assert_ok(algsurf_complex_roots(z, r, 4, e, &count));
    assert_true(count == 1 && e[0].multiplicity == 4 && !e[0].real && ulps(e) > 1e6);
    for (int k = 0; k < 5; k++) z[k] = (algsurf_complex){t->c[k], t->c[k]};
    assert_int_equal(algsurf_complex_roots(z, NULL, 4, e, &count), ALGSURF_OK);
    assert_true(count == 1 && e[0].multiplicity == 4 && ulps(e) <= 2); /* (1 + i) p */
    z[0].im += 1;
    assert_int_equal(algsurf_complex_roots(z, NULL, 4, e, &count), ALGSURF_OK);
    assert_int_equal(count, 4);
    close_product(t);
}

/* Roots of different factors that differ in their smaller part alone: (z^2 + 2 s)^m (L (z^2 + 2 s) - c z).
 * For s = 1, m = 2 and c = 1 both pairs are near +-sqrt(2) i; for s = -1, m = 1 and c = i near +-sqrt(2), and
 * two are real. */
TEST(test_factors_apart) {
    const double L = 0x1p80;
    const double real[7] = {8 * L, -4, 12 * L, -4, 6 * L, -1, L};
    const algsurf_complex z[5] = {{4 * L, 0}, {0, 2}, {-4 * L, 0}, {0, -1}, {L, 0}};
    algsurf_complex_root e[6];
    int count, reals = 0;
    assert_ok(algsurf_complex_roots_of_real(real, NULL, 6, e, &count));
    assert_int_equal(count, 4);
    for (int i = 0; i < 4; i++) {
        const int above = e[i].root.re > 0;
        assert_int_equal(e[i].multiplicity, above ? 1 : 2);
        assert_true(above ? e[i].box.re.lo > 0x1p-82 && e[i].box.re.hi < 0x1p-80
                          : e[i].box.re.lo >= -0x1p-1074 && e[i].box.re.hi <= 0x1p-1074);
    }
    assert_ok(algsurf_complex_roots(z, NULL, 4, e, &count));
    assert_int_equal(count, 4);
    for (int i = 0; i < 4; i++) {
        reals += e[i].real;
        assert_true(e[i].multiplicity == 1 &&
                    (e[i].real || (e[i].box.im.lo <= 0x1p-81 && e[i].box.im.hi >= 0x1p-81)));
    }
    assert_int_equal(reals, 2);
}

/* (x^10 + 1)^20: with memory 10 boxes, without it that is said, and nothing is written. */
TEST(test_without_memory) {
    product *t = open_product();
    const long q[11] = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    algsurf_complex_root e[MOST_DEGREE];
    algsurf_complex z[MOST_DEGREE + 1];
    algsurf_complex_solver *solver;
    times(t, q, 10, 20);
    assert_true(finish(t, 0));
    for (int k = 0; k <= t->n; k++) z[k] = (algsurf_complex){t->c[k], 0};
    assert_int_equal(algsurf_complex_solver_create(t->n, &solver), ALGSURF_OK);
    for (int fails = 1; fails >= 0; fails--) {
        int count = -5, before = blocks;
        malloc_fails = fails;
        algsurf_status status = algsurf_complex_solver_run(solver, z, NULL, t->n, NULL, e, &count, NULL);
        malloc_fails = 0;
        assert_int_equal(status, fails ? ALGSURF_E_NO_MEMORY : ALGSURF_OK);
        assert_int_equal(count, fails ? -5 : 10);
        assert_int_equal(blocks, before);
        for (int i = 0; i < count; i++) assert_true(ulps(e + i) <= 2);
    }
    algsurf_complex_solver_free(solver);
    close_product(t);
}

static int by_size(const void *a, const void *b) {
    return (*(const double *)a > *(const double *)b) - (*(const double *)a < *(const double *)b);
}

TEST(test_widths) {
    assert_true(widths > 10000);
    qsort(width, (size_t)widths, sizeof *width, by_size);
    print_message("%d boxes, in ulps: median %g, 99%% %g, widest %g\n", widths, width[widths / 2],
                  width[widths - widths / 100], width[widths - 1]);
    assert_true(width[widths / 2] <= 4 && width[widths - 1] < 1000);
}
