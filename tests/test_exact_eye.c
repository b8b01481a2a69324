/* test_exact_eye.c - the form shared by the rays of one eye: bit by bit that of each ray alone, which
 * test_exact_form.c judges by rational arithmetic.
 *
 * Breaks caught, each tried: a shift by -f, the sign of odd powers of y_0, the high limb of y_0, a parameter
 * too coarse for integers or its power of two left out, coefficients that a shift makes forgotten, products
 * of a zero component, a negative product not extended.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "exact.h"

#include <cmocka.h>

#include "surface/exact_eye.h"

#define SEED 12u
#define ROOM ((size_t)1 << 15)
#define LIMIT ((size_t)1 << 30)

/* Numbers of a kind: ordinary, of some range, of full range, small integers. */
typedef enum kind { ORDINARY, NEAR_A_LIMB, WHOLE_RANGE, INTEGERS } kind;

static double number(uint64_t *seed, kind of) {
    if (of == INTEGERS) return exact_random_int(seed, 9) - 4;
    if (of == ORDINARY) return 3 * exact_random_unit(seed);
    return of == NEAR_A_LIMB ? exact_random_wide(seed, -7, 7) : exact_random_wide(seed, -1070, 1000);
}

static void random_vector(uint64_t *seed, kind of, double x[3]) {
    for (int i = 0; i < 3; i++) x[i] = exact_random_int(seed, 5) ? number(seed, of) : 0;
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
        int i = exact_random_int(seed, n + 1), j = exact_random_int(seed, n + 1 - i);
        t[c] = (algsurf_term){i, j, exact_random_int(seed, n + 1 - i - j), number(seed, of)};
    }
    return count;
}

/* One ray; returns its degree. */
static int check_ray(const algsurf_surface *s, const algsurf_i_exact_eye *y, const double eye[3],
                     const double direction[3], int e) {
    static uint64_t block[ROOM], other[ROOM];
    algsurf_memory m, n;
    algsurf_zpoly p, q;
    int scale, wanted;
    algsurf_memory_begin(&m, block, ROOM, LIMIT), algsurf_memory_begin(&n, other, ROOM, LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m), start_other = algsurf_memory_here(&n);
    assert_true(algsurf_i_exact_eye_form(&m, y, direction, e, &p, &scale));
    assert_true(algsurf_i_exact_form(&n, s, eye, direction, e, &q, &wanted));
    size_t words = (size_t)(q.degree + 1) * (size_t)q.width;
    if (p.degree != q.degree || scale != wanted ||
        (q.degree >= 0 && (p.width != q.width || memcmp(p.c, q.c, words * sizeof *p.c) != 0))) {
        exact_print_doubles("eye", eye, 3), exact_print_doubles("direction", direction, 3);
        fail_msg("seed %u, degree %d, e = %d: another polynomial", SEED, algsurf_surface_degree(s), e);
    }
    assert_ptr_equal(m.at, p.c + words);
    algsurf_memory_release(&m, start), algsurf_memory_release(&n, start_other);
    return p.degree;
}

/* Some rays of one eye; returns how many of them are lower in degree than the surface, -1: no surface. */
static int check(const algsurf_term *t, int count, uint64_t *seed, kind of) {
    static uint64_t block[ROOM];
    algsurf_surface *s;
    algsurf_memory m;
    algsurf_i_exact_eye y;
    double eye[3], direction[3];
    int lower = 0;
    if (algsurf_surface_from_terms(t, (size_t)count, &s)) return -1;
    random_vector(seed, of, eye);
    algsurf_memory_begin(&m, block, ROOM, LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m);
    assert_true(algsurf_i_exact_eye_make(&m, s, eye, &y));
    for (int ray = 0; ray < 6; ray++) {
        random_vector(seed, of, direction);
        if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) direction[ray % 3] = 1;
        int e = exact_random_int(seed, of == WHOLE_RANGE ? 2001 : 21) - (of == WHOLE_RANGE ? 1000 : 10);
        lower += check_ray(s, &y, eye, direction, e) < algsurf_surface_degree(s);
    }
    algsurf_memory_release(&m, start);
    assert_int_equal(m.allocated, 0);
    algsurf_surface_free(s);
    return lower;
}

static void test_dense(void **state) {
    (void)state;
    algsurf_term t[300];
    uint64_t seed = SEED;
    int lower = 0;
    for (int c = 0; c < 200; c++) {
        kind of = (kind)(c % 4);
        int n = of == WHOLE_RANGE ? c / 4 % 4 : c / 4 % 11;
        lower += check(t, dense(t, &seed, n, of), &seed, of) > 0;
    }
    assert_in_range(lower, 5, 200); /* asymptotic directions among the integers */
}

static void test_sparse(void **state) {
    (void)state;
    algsurf_term t[12];
    uint64_t seed = SEED;
    int made = 0;
    for (int c = 0; c < 120; c++) {
        kind of = (kind)(c % 4);
        int n = of == WHOLE_RANGE ? c / 4 % 7 : c % 3 ? c / 4 % 14 : c / 4 % 29;
        made += check(t, sparse(t, &seed, n, 1 + exact_random_int(&seed, 12), of), &seed, of) >= 0;
    }
    algsurf_term highest[] = {{64, 0, 0, 0.1}, {3, 60, 0, -7.3}, {0, 0, 0, 1}};
    made += check(highest, 3, &seed, ORDINARY) >= 0;
    assert_in_range(made, 100, 121);
}

/* A ray in the surface, an eye on it, an eye at the origin. */
static void test_special(void **state) {
    (void)state;
    static uint64_t block[ROOM];
    const algsurf_term t[] = {{1, 1, 1, 0.1}, {0, 0, 3, 7}, {5, 0, 1, -3}};
    const double eyes[][3] = {{0.3, 1e20, 0}, {0, 0, 0}, {3, 0.1, 0}, {3, 1e-10, 0}, {0, 0, 3}};
    const double in_plane[3] = {0.7, -0.1, 0}, up[3] = {0, 0, 0.1};
    algsurf_surface *s;
    assert_int_equal(algsurf_surface_from_terms(t, 3, &s), ALGSURF_OK);
    for (size_t i = 0; i < sizeof eyes / sizeof *eyes; i++) {
        algsurf_memory m;
        algsurf_i_exact_eye y;
        algsurf_memory_begin(&m, block, ROOM, LIMIT);
        assert_true(algsurf_i_exact_eye_make(&m, s, eyes[i], &y));
        assert_int_equal(check_ray(s, &y, eyes[i], in_plane, -3), eyes[i][2] == 0 ? -1 : 5);
        assert_int_equal(check_ray(s, &y, eyes[i], up, -3), 3);
    }
    algsurf_surface_free(s);
}

/* Without memory: refused, and nothing kept. */
static void test_memory(void **state) {
    (void)state;
    static uint64_t block[ROOM];
    uint64_t small[1024], seed = SEED;
    algsurf_term t[84];
    algsurf_surface *s;
    algsurf_memory m;
    algsurf_i_exact_eye y;
    algsurf_zpoly p;
    const double eye[3] = {0.3, 3, -1.1}, d[3] = {0.1, -0.9, 0.2};
    int done = 0;
    assert_int_equal(algsurf_surface_from_terms(t, (size_t)dense(t, &seed, 6, ORDINARY), &s), ALGSURF_OK);
    for (size_t limit = 0; !done && limit < 1 << 20; limit += 4096) {
        algsurf_memory_begin(&m, block, ROOM, limit);
        done = algsurf_i_exact_eye_make(&m, s, eye, &y);
        if (!done) assert_ptr_equal(m.at, block);
        assert_true(limit > 0 || !done);
    }
    assert_true(done);
    size_t words = 0;
    for (done = 0; !done && words < 1024; words++) {
        algsurf_memory_begin(&m, small, words, 0);
        done = algsurf_i_exact_eye_form(&m, &y, d, -3, &p, NULL);
        if (!done) assert_ptr_equal(m.at, small);
    }
    assert_true(done);
    assert_in_range(words * sizeof *small, 500, 2560); /* of an ordinary ray of degree 6 */
    algsurf_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_dense), cmocka_unit_test(test_sparse),
                                       cmocka_unit_test(test_special), cmocka_unit_test(test_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
