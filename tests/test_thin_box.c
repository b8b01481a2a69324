/* test_thin_box.c - what is said of the parts of a box of rays holds in them, over rationals.
 *
 * Random surfaces of degree 1 to 12, views, boxes, columns and parts of their depths.  Where P is said to
 * have a sign, it has it at random points of the part, its edges among them; where it is said to grow in a
 * direction, it does from one such point to another that lies in that direction.  Some surfaces are squares of
 * planes and a little more, so that ranges do not tell.  P is what the frame has, each of its doubles taken as
 * it is.
 *
 * Breaks tried, each caught: signs without the terms of the second order; growth across with half of them,
 * without those of the third, or with a mixed term of 0; growth along from the middle alone; squares whose
 * rest is left out.  Not caught: squares whose mixed terms count half; signs without the third order, the
 * fourth order left out, which are far below what else a part leaves open.
 *
 *     test_thin_box [parts [seed]]
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "exact.h"
#include "picture/thin_box.h"

#include <math.h>
#include <string.h>

enum { MOST = ALGSURF_MAX_BEAM_DEGREE, SIDE = MOST + 1, POINTS = 6 };

static long part_count = 5000;
static uint64_t first_seed = 20261126;

static double uniform(uint64_t *seed, double lo, double hi) {
    return lo + (hi - lo) * 0.5 * (1 + exact_random_unit(seed));
}

typedef struct test_box {
    algsurf_i_frame_form frame;
    double q[SIDE * SIDE * SIDE], basis[SIDE * SIDE], sizes[SIDE * SIDE], along[SIDE * SIDE];
    double g[SIDE * SIDE * SIDE], c[SIDE * SIDE * SIDE], square[SIDE * SIDE];
    algsurf_i_beam_row row;
    algsurf_i_thin_box box;
    algsurf_i_solid solid;
} test_box;

/* The square of a plane, so much more, and perhaps a little of z^3. */
static size_t add_square(uint64_t *seed, double more, int bent, algsurf_term *terms) {
    static const int of[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double plane[4];
    size_t count = 0;
    for (int i = 0; i < 4; i++) plane[i] = i > 0 ? uniform(seed, -1, 1) : uniform(seed, -0.1, 0.1);
    for (int i = 0; i < 4; i++)
        for (int j = i; j < 4; j++) {
            double a = (i == j ? 1 : 2) * plane[i] * plane[j] + (j == 0 ? more : 0);
            terms[count++] =
                (algsurf_term){of[i][0] + of[j][0], of[i][1] + of[j][1], of[i][2] + of[j][2], a};
        }
    if (bent) terms[count++] = (algsurf_term){0, 0, 3, 0.01};
    return count;
}

static void make_box(test_box *b, uint64_t *seed) {
    algsurf_term terms[SIDE * SIDE];
    algsurf_surface *surface;
    size_t count = 0;
    int degree = 1 + exact_random_int(seed, MOST);
    for (int i = 0; i <= degree; i++)
        for (int j = 0; i + j <= degree; j++) {
            int k = exact_random_int(seed, degree - i - j + 1);
            terms[count++] = (algsurf_term){i, j, k, uniform(seed, -1, 1)};
        }
    terms[count++] = (algsurf_term){0, 0, degree, 1};
    if (exact_random_int(seed, 3) == 0) {
        degree = 2 + exact_random_int(seed, 2);
        count = add_square(seed, ldexp(1, -exact_random_int(seed, 24)), degree == 3, terms);
    }
    assert_int_equal(algsurf_surface_from_terms(terms, count, &surface), ALGSURF_OK);
    algsurf_i_view *view = &b->frame.view;
    memset(view, 0, sizeof *view);
    b->frame.q = b->q, b->frame.basis = b->basis, b->frame.sizes = b->sizes, b->frame.along = b->along;
    for (int i = 0; i < 3; i++) view->axis[i][i] = 1, view->centre[i] = uniform(seed, -0.2, 0.2);
    view->size = uniform(seed, 0.5, 1.5);
    view->alpha = exact_random_int(seed, 3) ? 1 / uniform(seed, 1.2, 8) : 0;
    for (int k = 0; k < 2; k++) view->beta[k] = view->alpha > 0 ? uniform(seed, -0.1, 0.1) : 0;
    view->noise = 0x1p-50;
    void *memory = malloc(algsurf_i_frame_memory(degree));
    assert_int_equal(algsurf_i_frame_expand(surface, &b->frame, memory), 1);
    free(memory);
    algsurf_surface_free(surface);
    algsurf_i_beam_expand(&b->frame, b->g);
    double h = ldexp(uniform(seed, 0.5, 1), -exact_random_int(seed, 8));
    b->row.c = b->c;
    algsurf_i_beam_row_expand(&b->frame, b->g, uniform(seed, -0.7, 0.7), -h, h, b->square, &b->row);
    b->box = (algsurf_i_thin_box){.view = view, .beam = &b->row, .u = uniform(seed, -0.7, 0.7), .h = h};
    algsurf_i_solid_expand(&b->box, &b->solid);
}

/* r = a + b c, all but r doubles. */
static void exact_line(mpq_t r, double a, double b, double c) {
    mpq_t w;
    mpq_init(w);
    exact_set(r, b), exact_set(w, c), mpq_mul(r, r, w);
    exact_set(w, a), mpq_add(r, r, w);
    mpq_clear(w);
}

/* P at xi, eta of the box and depth z. */
static void exact_value(const test_box *b, double xi, double eta, const mpq_t z, mpq_t value) {
    const algsurf_i_view *view = &b->frame.view;
    int n = b->frame.degree, side = n + 1;
    mpq_t at[2], w, row, level;
    mpq_inits(at[0], at[1], w, row, level, NULL);
    exact_line(at[0], b->box.u, b->box.h, xi), exact_line(at[1], b->row.v, b->row.h, eta);
    for (int k = 0; k < 2; k++) { /* x = u + z (alpha u + beta) */
        exact_set(w, view->alpha), mpq_mul(w, w, at[k]);
        exact_set(row, view->beta[k]), mpq_add(w, w, row);
        mpq_mul(w, w, z), mpq_add(at[k], at[k], w);
    }
    mpq_set_ui(value, 0, 1);
    for (int i = n; i >= 0; i--) {
        mpq_set_ui(level, 0, 1);
        for (int j = n - i; j >= 0; j--) {
            mpq_set_ui(row, 0, 1);
            for (int k = n - i - j; k >= 0; k--) {
                mpq_mul(row, row, z);
                exact_set(w, b->q[(i * side + j) * side + k]), mpq_add(row, row, w);
            }
            mpq_mul(level, level, at[1]), mpq_add(level, level, row);
        }
        mpq_mul(value, value, at[0]), mpq_add(value, value, level);
    }
    mpq_clears(at[0], at[1], w, row, level, NULL);
}

/* Mostly -1 or 1. */
static double random_place(uint64_t *seed) {
    int which = exact_random_int(seed, 3);
    return which == 0 ? -1 : which == 1 ? 1 : exact_random_unit(seed);
}

/* A column of a narrowed box, and the part [from,to] of its depths. */
typedef struct test_part {
    double x, y, half, from, to;
    unsigned sign, square_sign, growth;
} test_part;

static test_part make_part(test_box *b, uint64_t *seed) {
    test_part p = {.half = ldexp(1, -exact_random_int(seed, 5))};
    algsurf_i_column column, part;
    double from = uniform(seed, 0, 0.9), length = ldexp(uniform(seed, 0.5, 1), -exact_random_int(seed, 8));
    algsurf_i_solid_narrow(&b->solid, from, fmin(from + 2 * length, 1));
    p.x = (1 - p.half) * exact_random_unit(seed), p.y = (1 - p.half) * exact_random_unit(seed);
    length = ldexp(1, -exact_random_int(seed, 6));
    p.from = length * exact_random_int(seed, (int)(1 / length)), p.to = p.from + length;
    algsurf_i_solid_column(&b->solid, p.x, p.y, p.half, &column);
    p.sign = algsurf_i_column_cut(&b->solid, &column, p.from, p.to, &part);
    p.square_sign = algsurf_i_column_square_sign(&b->solid, &part);
    p.growth = algsurf_i_column_growth(&b->solid, &part, length);
    return p;
}

static void set_depth(const test_box *b, const test_part *p, double share, mpq_t z) {
    exact_line(z, b->solid.from, p->from + share * (p->to - p->from), b->solid.to - b->solid.from);
}

static long signs, squares, across, along;

static void check_sign(const test_box *b, const test_part *p, unsigned sign, uint64_t *seed) {
    mpq_t z, value;
    mpq_inits(z, value, NULL);
    set_depth(b, p, 0.5 + 0.5 * random_place(seed), z);
    exact_value(b, p->x + p->half * random_place(seed), p->y + p->half * random_place(seed), z, value);
    assert_int_equal(mpq_sgn(value), sign == ALGSURF_I_POSITIVE ? 1 : -1);
    mpq_clears(z, value, NULL);
}

/* From a point of the part in direction m, by half its side at most, to another. */
static void check_across(const test_box *b, const test_part *p, int m, uint64_t *seed) {
    const double turn = 6.283185307179586 / ALGSURF_I_DIRECTIONS, step = uniform(seed, 0.01, 0.9);
    double dx = step * cos(m * turn), dy = step * sin(m * turn);
    double x = random_place(seed), y = random_place(seed);
    x = fmax(-1, fmin(1, x + dx)) - dx, y = fmax(-1, fmin(1, y + dy)) - dy;
    x = fmax(-1, fmin(1, x)), y = fmax(-1, fmin(1, y));
    mpq_t z, value, further;
    mpq_inits(z, value, further, NULL);
    set_depth(b, p, 0.5 + 0.5 * random_place(seed), z);
    exact_value(b, p->x + p->half * x, p->y + p->half * y, z, value);
    exact_value(b, p->x + p->half * (x + dx), p->y + p->half * (y + dy), z, further);
    assert_true(mpq_cmp(further, value) > 0);
    across++;
    mpq_clears(z, value, further, NULL);
}

static void check_along(const test_box *b, const test_part *p, uint64_t *seed) {
    double one = 0.5 + 0.5 * random_place(seed), two = 0.5 + 0.5 * random_place(seed);
    double xi = p->x + p->half * random_place(seed), eta = p->y + p->half * random_place(seed);
    if (one == two) return;
    mpq_t z, value, further;
    mpq_inits(z, value, further, NULL);
    set_depth(b, p, fmin(one, two), z), exact_value(b, xi, eta, z, value);
    set_depth(b, p, fmax(one, two), z), exact_value(b, xi, eta, z, further);
    assert_int_equal(mpq_cmp(further, value) > 0, p->growth >> ALGSURF_I_DIRECTIONS & 1);
    along++;
    mpq_clears(z, value, further, NULL);
}

static void parts_are_what_is_said(void **state) {
    (void)state;
    static test_box b;
    for (long i = 0; i < part_count; i++) {
        uint64_t seed = first_seed + (uint64_t)i;
        make_box(&b, &seed);
        const test_part p = make_part(&b, &seed);
        for (int k = 0; p.sign && k < POINTS; k++) check_sign(&b, &p, p.sign, &seed);
        for (int k = 0; p.square_sign && k < POINTS; k++) check_sign(&b, &p, p.square_sign, &seed);
        signs += p.sign != 0, squares += !p.sign && p.square_sign;
        for (int m = 0; m < ALGSURF_I_DIRECTIONS; m++)
            if (p.growth >> m & 1) check_across(&b, &p, m, &seed);
        if (p.growth & ALGSURF_I_ALONG) check_along(&b, &p, &seed);
    }
    printf("%ld signs, %ld squares, %ld across, %ld along\n", signs, squares, across, along);
    assert_true(signs > part_count / 2 && squares > part_count / 150);
    assert_true(across > part_count / 2 && along > part_count / 10);
}

int main(int argc, char **argv) {
    if (argc > 1) part_count = atol(argv[1]);
    if (argc > 2) first_seed = strtoull(argv[2], NULL, 0);
    const struct CMUnitTest tests[] = {cmocka_unit_test(parts_are_what_is_said)};
    return cmocka_run_group_tests_name("thin boxes", tests, NULL, NULL);
}
