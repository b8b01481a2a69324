/* test_exact_form.c - P along a ray with integer coefficients, against the definition in rational arithmetic.
 *
 * Breaks caught, each tried: a carry that starts with 0 for a negative factor, the limb above not reduced for
 * a negative coefficient, a sum no wider than its summands or not extended by its sign, factors whose sum has
 * 65 bits taken for one limb, the high limb of a factor dropped, the parameter's power of two left out,
 * leading zeros kept, a work area kept on the stack, a parameter that makes numbers too long.
 */
#include "exact_ray.h"
#include "exact_zpolys.h"

#include "surface/exact_form.h"
#include "scenes.h"

#define SEED 77u
#define ROOM ((size_t)1 << 15)
#define LIMIT ((size_t)1 << 30)

static const char *family = "";
static int case_number, in_block;

static void print_case(const algsurf_term *terms, int count, const algsurf_ray *ray, int e) {
    fprintf(stderr, "%s, seed %u, case %d, e = %d\n", family, SEED, case_number, e);
    exact_print_doubles("origin", ray->origin, 3), exact_print_doubles("direction", ray->direction, 3);
    for (int i = 0; i < count && i < 100; i++)
        fprintf(stderr, "{%d, %d, %d, %a},\n", terms[i].i, terms[i].j, terms[i].k, terms[i].a);
}

/* a = b 2^shift? */
static int is_scaled(const mpz_t a, const mpz_t b, long shift) {
    mpz_t x;
    mpz_init(x);
    if (shift >= 0)
        mpz_mul_2exp(x, b, (mp_bitcnt_t)shift);
    else
        mpz_mul_2exp(x, a, (mp_bitcnt_t)-shift);
    int same = mpz_cmp(x, shift >= 0 ? a : b) == 0;
    mpz_clear(x);
    return same;
}

/* p(u) = 2^scale sum line_k (2^e u)^k? */
static int is_line(const algsurf_zpoly *p, const exact_line *line, int e, int scale) {
    mpz_t a, none;
    mpz_inits(a, none, NULL);
    int same = p->degree <= line->degree;
    for (int k = 0; same && k <= line->degree; k++) {
        if (k <= p->degree) exact_limbs(a, algsurf_zpoly_at(p, k), p->width);
        same = is_scaled(k <= p->degree ? a : none, line->c[k], (long)scale - line->shift + (long)e * k);
    }
    mpz_clears(a, none, NULL);
    return same;
}

static int is_same(const algsurf_zpoly *p, const algsurf_zpoly *q) {
    return p->degree == q->degree && p->width == q->width &&
           memcmp(p->c, q->c, (size_t)(p->degree + 1) * (size_t)p->width * sizeof *p->c) == 0;
}

/* Nothing but the result stays on a stack with room enough. */
static void judge_memory(const algsurf_memory *m, const uint64_t *block, const algsurf_zpoly *p) {
    assert_null(m->last);
    assert_ptr_equal(p->c, block);
    assert_ptr_equal(m->at, block + (size_t)(p->degree + 1) * (size_t)p->width);
}

/* The form of one ray in every way; returns its degree. */
static int check(const algsurf_term *given, int given_count, const algsurf_ray *ray, int e) {
    static uint64_t block[ROOM];
    algsurf_surface *s;
    algsurf_memory m, tight;
    algsurf_zpoly p, again;
    int scale = 1, other = 1;
    case_number++;
    if (algsurf_surface_from_terms(given, (size_t)given_count, &s)) return -2; /* no terms left */
    int count = (int)algsurf_surface_term_count(s), n = algsurf_surface_degree(s);
    algsurf_term *terms = malloc((size_t)count * sizeof *terms);
    algsurf_surface_terms(s, terms);
    algsurf_memory_begin(&m, block, ROOM, LIMIT);
    algsurf_memory_begin(&tight, NULL, 0, LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m), empty = algsurf_memory_here(&tight);
    int done = algsurf_i_exact_form(&m, s, ray->origin, ray->direction, e, &p, &scale) &&
               algsurf_i_exact_form(&tight, s, ray->origin, ray->direction, e, &again, &other);
    exact_line line = exact_line_of(terms, count, n, ray);
    if (!done || !exact_is_compact(&p) || !is_line(&p, &line, e, scale) || !is_same(&p, &again) ||
        scale != other) {
        print_case(terms, count, ray, e);
        fail_msg("another polynomial");
    }
    if (!m.last) judge_memory(&m, block, &p), in_block++;
    assert_ptr_equal(tight.at, again.c + (size_t)(p.degree + 1) * (size_t)p.width);
    algsurf_memory_release(&m, start), algsurf_memory_release(&tight, empty);
    assert_int_equal(m.allocated + tight.allocated, 0);
    exact_line_clear(&line), free(terms), algsurf_surface_free(s);
    return p.degree;
}

/* Numbers of a kind: ordinary, of full range, with all bits set, small integers, some zeros among each. */
typedef enum kind { ORDINARY, NEAR_A_LIMB, WHOLE_RANGE, ALL_ONES, INTEGERS } kind;

static double number(uint64_t *seed, kind of) {
    static const int range[] = {0, 7, 1000, 3};
    if (of == INTEGERS) return random_int(seed, 9) - 4;
    if (of == ORDINARY) return 3 * random_unit(seed);
    double x = random_wide(seed, -range[of], range[of]);
    if (of == WHOLE_RANGE && random_int(seed, 8) == 0) x *= 0x1p-1000; /* subnormal, or 0 */
    if (of == ALL_ONES) {
        int e;
        x = copysign(ldexp(0x1.fffffffffffffp0, (frexp(x, &e), e)), x);
    }
    return x;
}

/* May have zero components, but not all. */
static algsurf_ray random_ray(uint64_t *seed, kind of) {
    algsurf_ray ray = {.t_max = 1};
    int zeros = random_int(seed, 3);
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = zeros || random_bits(seed) & 1 ? number(seed, of) : 0;
        ray.direction[i] = zeros || random_bits(seed) & 1 ? number(seed, of) : 0;
    }
    if (ray.direction[0] == 0 && ray.direction[1] == 0 && ray.direction[2] == 0)
        ray.direction[random_int(seed, 3)] = 1;
    return ray;
}

static int dense(algsurf_term *t, uint64_t *seed, int n, kind of) {
    int count = 0;
    for (int k = 0; k <= n; k++)
        for (int j = 0; j + k <= n; j++)
            for (int i = 0; i + j + k <= n; i++) t[count++] = (algsurf_term){i, j, k, number(seed, of)};
    return count;
}

static int sparse(algsurf_term *t, uint64_t *seed, int n, int count, kind of) {
    for (int c = 0; c < count; c++) {
        int i = random_int(seed, n + 1), j = random_int(seed, n + 1 - i);
        t[c] = (algsurf_term){i, j, random_int(seed, n + 1 - i - j), number(seed, of)};
    }
    return count;
}

static int random_exponent(uint64_t *seed, kind of) {
    return random_int(seed, of == WHOLE_RANGE ? 2001 : 21) - (of == WHOLE_RANGE ? 1000 : 10);
}

static void check_dense(const char *name, kind of, int highest, int rounds) {
    algsurf_term t[500];
    uint64_t seed = SEED + (uint64_t)of;
    family = name;
    for (int c = 0; c < rounds; c++) {
        int count = dense(t, &seed, 1 + c % highest, of);
        algsurf_ray ray = random_ray(&seed, of);
        check(t, count, &ray, random_exponent(&seed, of));
    }
}

TEST(test_dense) {
    in_block = 0;
    check_dense("dense", ORDINARY, 10, 200);
    check_dense("near a limb", NEAR_A_LIMB, 8, 400);
    check_dense("all ones", ALL_ONES, 10, 200);
    check_dense("integers", INTEGERS, 6, 200);
    assert_true(in_block == 1000);
    check_dense("whole range", WHOLE_RANGE, 4, 40);
}

/* f0 + f1 just below and above 2^64: the other axes hold the parameter where it makes x that long. */
TEST(test_longest_limb) {
    const double ones = 0x1.fffffffffffffp0;
    algsurf_term t[] = {{9, 0, 0, ones}, {4, 5, 0, ones}, {0, 0, 9, -ones}, {0, 0, 0, 1}};
    family = "longest limb";
    for (int up = 9; up < 14; up++)
        for (int signs = 0; signs < 4; signs++) {
            algsurf_ray ray = {{ldexp(ones, up), ones, ones}, {ones, ones, ones}, 0, 1};
            if (signs & 1) ray.origin[0] = -ray.origin[0];
            if (signs & 2) ray.direction[0] = -ray.direction[0];
            check(t, 4, &ray, 0);
            double swapped = ray.origin[0];
            ray.origin[0] = ray.direction[0], ray.direction[0] = swapped;
            check(t, 4, &ray, 3);
        }
}

TEST(test_sparse) {
    algsurf_term t[12];
    uint64_t seed = SEED;
    family = "sparse";
    int highest = 0;
    for (int c = 0; c < 120; c++) {
        kind of = (kind)(c % 5);
        int n = of == WHOLE_RANGE ? 1 + c % 9 : c % 3 ? 1 + c % 12 : 1 + c % 64;
        int count = sparse(t, &seed, n, 1 + random_int(&seed, 12), of);
        algsurf_ray ray = random_ray(&seed, of);
        int degree = check(t, count, &ray, random_exponent(&seed, of));
        if (degree > highest) highest = degree;
    }
    assert_often(highest >= 50 && highest <= 64);
}

/* The terms times a x + b y + c z + d; returns their number. */
static int times_plane(algsurf_term *t, int count, const double plane[4]) {
    for (int part = 3; part >= 0; part--)
        for (int i = 0; i < count; i++) {
            algsurf_term *to = &t[part * count + i];
            *to = t[i];
            to->i += part == 1, to->j += part == 2, to->k += part == 3;
            to->a *= plane[part == 0 ? 3 : part - 1];
        }
    return 4 * count;
}

/* Asymptotic directions: a factor whose plane is parallel to the ray; in it if d is right. */
TEST(test_asymptotic) {
    algsurf_term t[4 * 56];
    uint64_t seed = SEED;
    int lower = 0, inside = 0;
    family = "asymptotic";
    for (int c = 0; c < 200; c++) {
        int n = c % 6, count = dense(t, &seed, n, INTEGERS);
        algsurf_ray ray = random_ray(&seed, INTEGERS);
        double *d = ray.direction, *o = ray.origin, plane[4] = {d[1] - d[2], d[2] - d[0], d[0] - d[1]};
        plane[3] = -(plane[0] * o[0] + plane[1] * o[1] + plane[2] * o[2]) + (c % 2);
        int degree = check(t, times_plane(t, count, plane), &ray, random_exponent(&seed, INTEGERS));
        lower += degree >= 0 && degree <= n, inside += degree == -1;
    }
    assert_in_range(lower, 50, 200), assert_in_range(inside, 50, 200);
    algsurf_term flat[] = {{1, 1, 1, 0.1}, {0, 0, 3, 7}, {5, 0, 1, -1e-300}};
    algsurf_ray in_plane = {{0.3, 1e200, 0}, {0.7, -0.1, 0}, 0, 1};
    assert_int_equal(check(flat, 3, &in_plane, -3), -1);
    algsurf_term constant = {0, 0, 0, -6};
    assert_int_equal(check(&constant, 1, &in_plane, 5), 0);
}

/* P(origin + 2^e u direction) */
static void value_at(mpq_t value, const algsurf_term *t, int count, const algsurf_ray *ray, int e, int u) {
    mpq_t power[3][ALGSURF_MAX_DEGREE + 1], x, d;
    mpq_inits(x, d, NULL), mpq_set_ui(value, 0, 1);
    for (int i = 0; i < 3; i++) {
        exact_set(x, u), exact_set(d, ldexp(ray->direction[i], e)), mpq_mul(d, d, x);
        exact_set(x, ray->origin[i]), mpq_add(x, x, d);
        for (int k = 0; k <= ALGSURF_MAX_DEGREE; k++) {
            mpq_init(power[i][k]);
            if (k)
                mpq_mul(power[i][k], power[i][k - 1], x);
            else
                mpq_set_ui(power[i][k], 1, 1);
        }
    }
    for (int c = 0; c < count; c++) {
        exact_set(x, t[c].a), mpq_mul(x, x, power[0][t[c].i]), mpq_mul(d, power[1][t[c].j], power[2][t[c].k]);
        mpq_mul(x, x, d), mpq_add(value, value, x);
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k <= ALGSURF_MAX_DEGREE; k++) mpq_clear(power[i][k]);
    mpq_clears(x, d, NULL);
}

/* p(u) 2^-scale */
static void form_at(mpq_t value, const algsurf_zpoly *p, int scale, int u) {
    mpz_t a, sum;
    mpz_inits(a, sum, NULL);
    for (int k = p->degree; k >= 0; k--) {
        exact_limbs(a, algsurf_zpoly_at(p, k), p->width);
        mpz_mul_si(sum, sum, u), mpz_add(sum, sum, a);
    }
    mpq_set_z(value, sum), mpz_clears(a, sum, NULL);
    if (scale >= 0)
        mpq_div_2exp(value, value, (mp_bitcnt_t)scale);
    else
        mpq_mul_2exp(value, value, (mp_bitcnt_t)-scale);
}

/* All 47,905 terms of degree 64, by values: at most 64 points are roots of a wrong difference. */
TEST(test_largest) {
    static uint64_t block[ROOM];
    uint64_t seed = SEED;
    const int n = ALGSURF_MAX_DEGREE;
    algsurf_term *t = malloc((size_t)((n + 1) * (n + 2) * (n + 3) / 6) * sizeof *t);
    int scale, count = dense(t, &seed, n, ORDINARY);
    algsurf_ray ray = {{1.5, 0.3, -0.7}, {0.1, 0.5, -0.25}, 0, 1};
    algsurf_memory m;
    algsurf_zpoly p;
    mpq_t wanted, got;
    mpq_inits(wanted, got, NULL);
    algsurf_surface *s = surface_of_terms(t, (size_t)count);
    algsurf_memory_begin(&m, block, ROOM, LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m);
    assert_true(algsurf_i_exact_form(&m, s, ray.origin, ray.direction, -4, &p, &scale));
    assert_int_equal(p.degree, n);
    assert_true(exact_is_compact(&p));
    for (int u = -3; u < 4; u += 3) {
        value_at(wanted, t, count, &ray, -4, u), form_at(got, &p, scale, u);
        assert_true(mpq_equal(wanted, got));
    }
    algsurf_memory_release(&m, start);
    mpq_clears(wanted, got, NULL), free(t);
}

/* With each smaller block and no more memory: refused, and nothing kept. */
TEST(test_memory) {
    uint64_t block[1024], seed = SEED;
    algsurf_term t[84];
    algsurf_memory m;
    algsurf_zpoly p;
    algsurf_ray ray = random_ray(&seed, ORDINARY);
    int count = dense(t, &seed, 6, ORDINARY), done = 0;
    algsurf_surface *s = surface_of_terms(t, (size_t)count);
    size_t words = 0;
    for (; !done && words < 1024; words++) {
        algsurf_memory_begin(&m, block, words, 0);
        done = algsurf_i_exact_form(&m, s, ray.origin, ray.direction, -3, &p, NULL);
        if (!done) assert_ptr_equal(m.at, block);
    }
    assert_true(done && words > 50);
    assert_in_range(words * sizeof *block, 500, 2560); /* of an ordinary ray of degree 6 */
}
