/* test_faces.c - the faces of an extent and a plane along a ray, against the definition in rational numbers.
 *
 * Breaks caught, each tried: the centre's sign, a mixed product added once, a bit less of width, the
 * direction without its power of two, the two sides of a box exchanged, a polynomial that is not compact.
 */
#include "exact_zpolys.h"

#include "rays/faces.h"
#include "unit.h"

#define SEED 5u
#define ROOM ((size_t)1 << 12)
#define LIMIT ((size_t)1 << 20)

static void print_case(const algsurf_extent *x, const double *o, const double *d, int e) {
    fprintf(stderr, "seed %u, kind %d, e = %d\n", SEED, (int)x->kind, e);
    exact_print_doubles("centre", x->centre, 3), exact_print_doubles("size", x->size, 3);
    exact_print_doubles("origin", o, 3), exact_print_doubles("direction", d, 3);
}

/* q[0] + q[1] u + q[2] u^2 of face f, from the definition. */
static void define_face(mpq_t q[3], const algsurf_extent *x, const double *o, const double *d, int e, int f) {
    mpq_t a, b, c;
    mpq_inits(a, b, c, NULL);
    int ball = x->kind == ALGSURF_EXTENT_SPHERE;
    for (int k = 0; k < 3; k++) mpq_set_ui(q[k], 0, 1);
    exact_set(q[0], x->size[ball ? 0 : f / 2]);
    if (ball) mpq_mul(q[0], q[0], q[0]);
    for (int i = ball ? 0 : f / 2; i <= (ball ? 2 : f / 2); i++) {
        exact_set(a, o[i]), exact_set(c, x->centre[i]), mpq_sub(a, a, c);
        exact_set(b, d[i]);
        if (e >= 0)
            mpq_mul_2exp(b, b, (mp_bitcnt_t)e);
        else
            mpq_div_2exp(b, b, (mp_bitcnt_t)-e);
        if (ball) {
            mpq_mul(c, a, a), mpq_sub(q[0], q[0], c);
            mpq_mul(c, a, b), mpq_sub(q[1], q[1], c), mpq_sub(q[1], q[1], c);
            mpq_mul(c, b, b), mpq_sub(q[2], q[2], c);
        } else if (f % 2 == 0) {
            mpq_sub(q[0], q[0], a), mpq_sub(q[1], q[1], b);
        } else {
            mpq_add(q[0], q[0], a), mpq_add(q[1], q[1], b);
        }
    }
    mpq_clears(a, b, c, NULL);
}

/* The same of c - n.X. */
static void define_plane(mpq_t q[3], const algsurf_plane *plane, const double *o, const double *d, int e) {
    mpq_t n, x;
    mpq_inits(n, x, NULL);
    exact_set(q[0], plane->offset), mpq_set_ui(q[1], 0, 1), mpq_set_ui(q[2], 0, 1);
    for (int i = 0; i < 3; i++) {
        exact_set(n, plane->normal[i]);
        exact_set(x, o[i]), mpq_mul(x, x, n), mpq_sub(q[0], q[0], x);
        exact_set(x, d[i]), mpq_mul(x, x, n), mpq_sub(q[1], q[1], x);
    }
    if (e >= 0)
        mpq_mul_2exp(q[1], q[1], (mp_bitcnt_t)e);
    else
        mpq_div_2exp(q[1], q[1], (mp_bitcnt_t)-e);
    mpq_clears(n, x, NULL);
}

static void coefficient(mpq_t q, const algsurf_zpoly *p, int k) {
    mpz_t z, top;
    mpz_inits(z, top, NULL);
    if (k <= p->degree) {
        const algsurf_limb *a = algsurf_zpoly_at(p, k);
        mpz_import(z, (size_t)p->width, -1, sizeof *a, 0, 0, a);
        mpz_setbit(top, (mp_bitcnt_t)(64 * p->width));
        if (algsurf_z_negative(a, p->width)) mpz_sub(z, z, top);
    }
    mpq_set_z(q, z), mpz_clears(z, top, NULL);
}

/* q is a positive power of two? */
static int is_power_of_two(const mpq_t q) {
    return mpq_sgn(q) > 0 && mpz_popcount(mpq_numref(q)) == 1 && mpz_popcount(mpq_denref(q)) == 1;
}

/* p = 2^k q for some k? */
static int is_multiple(const algsurf_zpoly *p, mpq_t q[3]) {
    mpq_t a, factor;
    mpq_inits(a, factor, NULL);
    int same = p->degree <= 2;
    for (int k = 0; same && k < 3; k++) {
        coefficient(a, p, k);
        if (mpq_sgn(q[k]) == 0 || mpq_sgn(a) == 0) {
            same = mpq_sgn(q[k]) == mpq_sgn(a);
            continue;
        }
        mpq_div(a, a, q[k]);
        if (mpq_sgn(factor) == 0) mpq_set(factor, a);
        same = mpq_equal(a, factor) && is_power_of_two(a);
    }
    mpq_clears(a, factor, NULL);
    return same;
}

/* Counts the faces of each degree. */
static void check(const algsurf_extent *x, const algsurf_plane *plane, const double *o, const double *d,
                  int e, int of_degree[4]) {
    static uint64_t block[ROOM];
    algsurf_memory m;
    algsurf_zpoly face[ALGSURF_MOST_FACES];
    int count;
    size_t words = 0;
    mpq_t q[3];
    mpq_inits(q[0], q[1], q[2], NULL);
    algsurf_memory_begin(&m, block, ROOM, LIMIT);
    const algsurf_i_region region = {x, plane, 1};
    assert_true(algsurf_i_faces(&m, &region, o, d, e, face, &count));
    assert_int_equal(count, x->kind == ALGSURF_EXTENT_SPHERE ? 2 : 7);
    for (int f = 0; f < count; f++) {
        if (f < count - 1)
            define_face(q, x, o, d, e, f);
        else
            define_plane(q, plane, o, d, e);
        if (!is_multiple(&face[f], q) || !exact_is_compact(&face[f])) {
            print_case(x, o, d, e);
            exact_print_doubles("normal", plane->normal, 3), exact_print_doubles("offset", &plane->offset, 1);
            fail_msg("another face %d", f);
        }
        of_degree[face[f].degree + 1]++;
        words += (size_t)(face[f].degree + 1) * (size_t)face[f].width;
    }
    assert_null(m.last);
    assert_ptr_equal(m.at, block + words); /* nothing else is kept */
    mpq_clears(q[0], q[1], q[2], NULL);
}

/* Ordinary, of full range, small integers. */
static double number(uint64_t *seed, int of) {
    if (of == 0) return 3 * random_unit(seed);
    return of == 1 ? random_wide(seed, -1070, 1020) : random_int(seed, 7) - 3;
}

TEST(test_random) {
    uint64_t seed = SEED;
    int of_degree[4] = {0};
    for (int c = 0; c < 3000; c++) {
        algsurf_extent x = {c & 1 ? ALGSURF_EXTENT_SPHERE : ALGSURF_EXTENT_BOX, {0}, {0}};
        int of = c % 3, e = random_int(&seed, of == 1 ? 2001 : 21) - (of == 1 ? 1000 : 10);
        double o[3], d[3];
        for (int i = 0; i < 3; i++) {
            o[i] = number(&seed, of), d[i] = number(&seed, of), x.centre[i] = number(&seed, of);
            x.size[i] = fabs(number(&seed, of)) + (of == 2);
            if (random_int(&seed, 4) == 0) o[i] = 0;
            if (i > 0 && random_int(&seed, 4) == 0) d[i] = 0;
            if (random_int(&seed, 4) == 0) x.centre[i] = 0;
        }
        if (d[0] == 0) d[0] = 1;
        algsurf_plane plane = {{number(&seed, of), number(&seed, of), number(&seed, of)}, number(&seed, of)};
        for (int i = 1; i < 3; i++)
            if (random_int(&seed, 4) == 0) plane.normal[i] = 0;
        if (plane.normal[0] == 0) plane.normal[0] = -1;
        check(&x, &plane, o, d, e, of_degree);
    }
    for (int k = 0; k < 4; k++) assert_in_range(of_degree[k], 20, 12000);
}

/* The largest coefficients that numbers of some length can make, at the ends of limbs. */
TEST(test_longest) {
    const double ones = 0x1.fffffffffffffp0;
    int of_degree[4] = {0};
    for (int kind = 1; kind <= 2; kind++)
        for (int bits = 54; bits < 200; bits++) {
            algsurf_extent x = {(int)kind, {-ones, -ones, -ones}, {ones, ones, ones}};
            double o[3] = {ones, ones, ones}, d[3] = {ones, -ones, -ones};
            if (kind == ALGSURF_EXTENT_SPHERE)
                x.size[0] = ldexp(1, 1 - bits);
            else
                d[0] = d[1] = d[2] = ldexp(-1, 1 - bits);
            const algsurf_plane plane = {{-ones, ones, ones}, kind == ALGSURF_EXTENT_BOX ? ones : -x.size[0]};
            check(&x, &plane, o, d, 0, of_degree);
        }
}

TEST(test_none) {
    algsurf_memory m;
    algsurf_zpoly face[ALGSURF_MOST_FACES];
    const double o[3] = {1, 2, 3};
    const algsurf_extent all = {ALGSURF_EXTENT_ALL, {0}, {0}};
    int count = 7;
    algsurf_memory_begin(&m, NULL, 0, 0);
    assert_true(algsurf_i_faces(&m, &(algsurf_i_region){NULL, NULL, 0}, o, o, 0, face, &count));
    assert_int_equal(count, 0);
    count = 7;
    assert_true(algsurf_i_faces(&m, &(algsurf_i_region){&all, NULL, 0}, o, o, 0, face, &count));
    assert_int_equal(count, 0);
}

/* With each smaller block and no more memory: refused, and nothing kept. */
TEST(test_memory) {
    uint64_t block[64];
    const double o[3] = {0.1, 0.2, 3}, d[3] = {0.3, 0.5, -0.1};
    for (int kind = 1; kind <= 2; kind++) {
        const algsurf_extent x = {(int)kind, {0.1, 0.3, 0.7}, {1.1, 1.2, 1.3}};
        const algsurf_plane plane = {{0.2, 0.3, 0.1}, 1.7};
        const algsurf_i_region region = {&x, &plane, 1};
        algsurf_memory m;
        algsurf_zpoly face[ALGSURF_MOST_FACES];
        int done = 0, count;
        size_t words = 0;
        for (; !done && words < 64; words++) {
            algsurf_memory_begin(&m, block, words, 0);
            done = algsurf_i_faces(&m, &region, o, d, -3, face, &count);
            if (!done) assert_ptr_equal(m.at, block);
            if (!done) assert_int_equal(count, 0);
        }
        assert_true(done && words > 5);
    }
}
