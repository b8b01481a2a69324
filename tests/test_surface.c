/* test_surface.c - making a surface: merging, the natural unit and scale, the layout, what is refused.
 *
 * Each test says which breaks it catches.
 */
#include <limits.h>

#include "scenes.h"
#include "surface/impl.h"

static const uint64_t seed = 20240607;

/* Rows without zeros at the end, every term in its place, the largest coefficient in [1/2,1).
 * Catches: rows not trimmed, a wrong scale, i and k exchanged. */
TEST(test_layout) {
    uint64_t state = seed;
    for (int n = 0; n < 400; n++) {
        algsurf_surface *s = surface_of_random_terms(&state, 1 + n % 20, -200, 200);
        double largest = 0;
        size_t seen = 0, rows = 0;
        assert_int_equal(s->level_count, s->terms[0].k + 1);
        assert_false(s->inexact);
        for (int k = 0; k < s->level_count; k++) {
            const algsurf_level *level = &s->levels[k];
            assert_true(level->first == rows);
            rows += (size_t)level->count;
            for (int j = 0; j < level->count; j++) {
                const algsurf_row *row = &s->rows[level->first + (size_t)j];
                const double *c = s->coef + row->first;
                assert_true(j < level->count - 1 || row->length > 0);
                assert_true(row->length == 0 || c[row->length - 1] != 0);
                for (int i = row->length - 1; i >= 0; i--) {
                    largest = fmax(largest, fabs(c[i]));
                    seen += c[i] != 0;
                }
            }
        }
        assert_true(seen == s->term_count && largest >= 0.5 && largest < 1);
        for (size_t t = 0; t < s->term_count; t++) {
            const algsurf_term *term = &s->terms[t];
            const algsurf_row *row = &s->rows[s->levels[term->k].first + (size_t)term->j];
            int shift = s->unit * (term->i + term->j + term->k) + s->scale;
            assert_true(ldexp(s->coef[row->first + (size_t)term->i], -shift) == term->a);
        }
    }
}

/* Catches: the sums' logarithms overflowing, the wrong root, a unit kept although it loses bits. */
TEST(test_unit) {
    const struct {
        algsurf_term term[3];
        size_t count;
        int unit, inexact;
    } cases[] = {
        {{{2, 0, 0, 1}, {0, 0, 0, -0x1p20}}, 2, 10, 0},
        {{{2, 0, 0, 0x1p900}, {0, 0, 0, -0x1p-900}}, 2, -900, 0},
        {{{1, 0, 0, 0x1p-1074}, {0, 0, 0, 0x1p1023}}, 2, 2097, 0},
        {{{4, 0, 0, 1}, {0, 1, 0, 0x1p30}, {0, 0, 0, 0x1p80}}, 3, 20, 0}, /* the larger of 10 and 20 */
        {{{0, 0, 0, 7}}, 1, 0, 0},
        {{{0, 3, 0, 0x1p-1000}}, 1, 0, 0},
        /* 1000 would push the middle term to 2^-2000: at 0 it is 2^-1000 */
        {{{2, 0, 0, 0x1p-1000}, {1, 0, 0, 0x1p-1000}, {0, 0, 0, 0x1p1000}}, 3, 1000, 0},
        /* in no unit does the middle term fit: the balanced one stays */
        {{{2, 0, 0, 1}, {1, 0, 0, 0x1p-1074}, {0, 0, 0, 0x1p1000}}, 3, 500, 1},
        /* in no unit do three such terms fit */
        {{{2, 0, 0, 0x1p1000}, {1, 0, 0, 0x1p-1000}, {0, 0, 0, 0x1p1000}}, 3, 0, 1},
        /* balanced: 1000, where the constant is 2^-3500 of the largest; 191 is the first to keep it */
        {{{4, 0, 0, 0x1p-500}, {0, 3, 0, 0x1p500}, {0, 0, 0, 1}}, 3, 191, 0},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        algsurf_surface *s = surface_of_terms(cases[c].term, cases[c].count);
        assert_int_equal(s->unit, cases[c].unit);
        assert_int_equal(s->inexact, cases[c].inexact);
    }
}

/* The unit is that of the surface, whatever power of two its equation is multiplied by.  Catches: exponents
 * added to the sums' logarithms before these are compared, which rounds to another unit where two are as
 * near. */
TEST(test_unit_of_multiples) {
    for (int e = -900; e <= 900; e++) {
        const algsurf_term term[] = {{3, 0, 0, ldexp(5, e)}, {1, 0, 0, ldexp(10, e)}};
        assert_int_equal(surface_of_terms(term, 2)->unit, 0);
    }
}

/* Catches: an unstable sort, merging in another order, zero terms kept. */
TEST(test_merging) {
    const algsurf_term in[] = {{1, 0, 0, 1}, {0, 0, 2, 3},  {1, 0, 0, 0x1p53}, {0, 4, 0, -1}, {1, 0, 0, 1},
                               {0, 0, 0, 0}, {0, 4, 0, 1},  {1, 0, 0, 1},      {2, 0, 1, 5},  {0, 1, 1, 6},
                               {3, 1, 0, 7}, {99, 9, 9, 0}, {70, 0, 0, 1},     {70, 0, 0, -1}};
    const algsurf_term out[] = {{0, 0, 2, 3}, {0, 1, 1, 6}, {2, 0, 1, 5}, {3, 1, 0, 7}, {1, 0, 0, 0x1p53}};
    algsurf_surface *s = surface_of_terms(in, sizeof in / sizeof *in);
    algsurf_term got[5];
    assert_int_equal(algsurf_surface_term_count(s), 5);
    assert_int_equal(algsurf_surface_degree(s), 4);
    assert_ok(algsurf_surface_terms(s, got));
    for (int t = 0; t < 5; t++) {
        assert_true(got[t].i == out[t].i && got[t].j == out[t].j && got[t].k == out[t].k &&
                    got[t].a == out[t].a);
    }
}

/* 200,000 terms on 200 places: each sum is that of a loop in the order of the input. */
TEST(test_many_terms) {
    enum { COUNT = 200000, PLACES = 200 };
    algsurf_term *terms = malloc(COUNT * sizeof *terms);
    double sum[PLACES] = {0};
    uint64_t state = seed;
    assert_non_null(terms);
    for (int t = 0; t < COUNT; t++) {
        int place = random_int(&state, PLACES);
        terms[t] = (algsurf_term){place % 10, place / 10, 0, random_wide(&state, -30, 30)};
        sum[place] += terms[t].a;
    }
    algsurf_surface *s = surface_of_terms(terms, COUNT);
    assert_int_equal(algsurf_surface_term_count(s), PLACES);
    for (int t = 0; t < PLACES; t++) assert_true(s->terms[t].a == sum[s->terms[t].j * 10 + s->terms[t].i]);
    free(terms);
}

/* Catches: i+j+k computed in int before the parts are checked, each check left out. */
TEST(test_refused_terms) {
    const struct {
        algsurf_term term[2];
        size_t count;
        algsurf_status status;
    } cases[] = {
        {{{-1, 0, 0, 1}}, 1, ALGSURF_E_ARGUMENT},
        {{{0, INT_MIN, 0, 0}}, 1, ALGSURF_E_ARGUMENT},
        {{{0, 0, -1, 1}}, 1, ALGSURF_E_ARGUMENT},
        {{{1, 0, 0, NAN}}, 1, ALGSURF_E_NOT_FINITE},
        {{{1, 0, 0, 1}, {2, 0, 0, -INFINITY}}, 2, ALGSURF_E_NOT_FINITE},
        {{{1, 0, 0, 1e308}, {1, 0, 0, 1e308}}, 2, ALGSURF_E_RANGE},
        {{{65, 0, 0, 1}}, 1, ALGSURF_E_DEGREE},
        {{{32, 32, 1, 1}}, 1, ALGSURF_E_DEGREE},
        {{{INT_MAX, INT_MAX, 2, 1}}, 1, ALGSURF_E_DEGREE}, /* the sum wraps to 0 */
        {{{0, 0, INT_MAX, 1}}, 1, ALGSURF_E_DEGREE},
        {{{1, 0, 0, 0}}, 1, ALGSURF_E_ZERO},
        {{{INT_MAX, INT_MAX, INT_MAX, -0.0}}, 1, ALGSURF_E_ZERO},
        {{{1, 2, 3, 0.5}, {1, 2, 3, -0.5}}, 2, ALGSURF_E_ZERO},
        {{{1, 2, 3, 0.5}}, 0, ALGSURF_E_ARGUMENT},
    };
    static char place;
    algsurf_surface *const untouched = (void *)&place;
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        algsurf_surface *s = untouched;
        assert_int_equal(algsurf_surface_from_terms(cases[c].term, cases[c].count, &s), cases[c].status);
        assert_ptr_equal(s, untouched);
    }
    algsurf_surface *s = untouched;
    assert_int_equal(algsurf_surface_from_terms(NULL, 1, &s), ALGSURF_E_ARGUMENT);
    assert_ptr_equal(s, untouched);
    assert_int_equal(algsurf_surface_from_terms(cases[0].term, 1, NULL), ALGSURF_E_ARGUMENT);
}

/* Catches: each missing check. */
TEST(test_null_surface) {
    algsurf_term t = {1, 2, 3, 4.0};
    algsurf_surface *s = surface_of_terms(&t, 1);
    assert_int_equal(algsurf_surface_terms(s, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_terms(NULL, &t), ALGSURF_E_ARGUMENT);
    assert_true(t.i == 1 && t.a == 4.0);
    assert_int_equal(algsurf_surface_degree(NULL), -1);
    assert_int_equal(algsurf_surface_term_count(NULL), 0);
    algsurf_surface_free(NULL);
}
