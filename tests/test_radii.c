/* test_radii.c - the radii of Bernstein coefficients in the lanes' walk, against rational arithmetic.
 *
 * A computed coefficient is compared with that of the exact ray, its error in units of its radius: never
 * above 1, and above 1/100 somewhere at every depth, or the radii would be good for nothing.  First the
 * coefficients of P along rays, then those of cells 1 to DEEP cuts deep, as the walk cuts them; and cells of
 * polynomials that are known exactly, whose radii come from the cuts alone.
 *
 * Breaks tried, each caught: a 32nd of the radius from powers (a 16th is not: it is that generous), a cut
 * that adds no radius, or n u / 4 of the coefficients instead of 8 n u, signs counted the wrong way round.
 */
#include "exact_ray.h"

#define LANES 2
#define KERNEL(name) name##_of_test
#include "rays/packets.h"
#include "rays/packet_template.h"
#include "scenes.h"

#define SEED 20261122u
enum { DEEP = 6, MOST = ALGSURF_MAX_DEGREE };

static const int degrees[] = {1, 2, 3, 4, 6, 7, 10, 13, 16, 20, 32, 64};

/* The largest error so far, in units of the radius, at each depth. */
static double worst[DEEP + 1];

typedef struct exact_form {
    int n;
    mpq_t b[MOST + 1];
} exact_form;

static void form_init(exact_form *f, int n) {
    f->n = n;
    for (int j = 0; j <= n; j++) mpq_init(f->b[j]);
}

static void form_clear(exact_form *f) {
    for (int j = 0; j <= f->n; j++) mpq_clear(f->b[j]);
}

/* The part left of the ratio, or right of it. */
static void form_cut(exact_form *f, const mpq_t ratio, int right) {
    mpq_t rest, x;
    mpq_inits(rest, x, NULL);
    mpq_set_ui(rest, 1, 1), mpq_sub(rest, rest, ratio);
    for (int i = 1; i <= f->n; i++)
        for (int k = 0; k <= f->n - i; k++) {
            int j = right ? k : f->n - k;
            mpq_mul(f->b[j], f->b[j], right ? rest : ratio);
            mpq_mul(x, f->b[right ? j + 1 : j - 1], right ? ratio : rest);
            mpq_add(f->b[j], f->b[j], x);
        }
    mpq_clears(rest, x, NULL);
}

/* From c_k t^k to Bernstein coefficients over [middle - half, middle + half]. */
static void form_of_line(exact_form *f, const exact_line *line, double middle, double half) {
    mpq_t lo, x, w;
    mpq_inits(lo, x, w, NULL);
    mpq_t *a = malloc((size_t)(f->n + 1) * sizeof *a);
    mpz_t choose;
    mpz_init(choose);
    exact_set(lo, middle), exact_set(x, half), mpq_sub(lo, lo, x), mpq_add(x, x, x);
    for (int k = 0; k <= f->n; k++) {
        mpq_init(a[k]);
        if (k <= line->degree) exact_line_coefficient(a[k], line, k);
    }
    for (int k = 0; k < f->n; k++)
        for (int i = f->n - 1; i >= k; i--) mpq_mul(w, lo, a[i + 1]), mpq_add(a[i], a[i], w);
    mpq_set_ui(w, 1, 1);
    for (int k = 1; k <= f->n; k++) {
        mpq_mul(w, w, x), mpq_mul(a[k], a[k], w);
        mpz_bin_uiui(choose, (unsigned long)f->n, (unsigned long)k);
        mpq_set_z(lo, choose), mpq_div(a[k], a[k], lo);
    }
    for (int j = 0; j <= f->n; j++) {
        mpq_set_ui(f->b[j], 0, 1);
        for (int k = 0; k <= j; k++) {
            mpz_bin_uiui(choose, (unsigned long)j, (unsigned long)k);
            mpq_set_z(w, choose), mpq_mul(w, w, a[k]), mpq_add(f->b[j], f->b[j], w);
        }
    }
    for (int k = 0; k <= f->n; k++) mpq_clear(a[k]);
    free(a), mpz_clear(choose), mpq_clears(lo, x, w, NULL);
}

static void judge(const exact_form *f, const lanes *w, const lanes *e, int lane, int depth,
                  const char *what) {
    mpq_t error, x;
    mpq_inits(error, x, NULL);
    for (int j = 0; j <= f->n; j++) {
        exact_set(error, w[j][lane]), mpq_sub(error, error, f->b[j]), mpq_abs(error, error);
        if (mpq_sgn(error) == 0) continue;
        if (!(e[j][lane] > 0)) fail_msg("%s: degree %d, coefficient %d: off without a radius", what, f->n, j);
        exact_set(x, e[j][lane]), mpq_div(error, error, x);
        double part = mpq_get_d(error);
        if (part > 1)
            fail_msg("%s: degree %d, depth %d, coefficient %d: %g radii", what, f->n, depth, j, part);
        worst[depth] = fmax(worst[depth], part);
    }
    mpq_clears(error, x, NULL);
}

/* Cuts the form in both lanes at the same places, again and again, and judges every part that is kept. */
static void judge_cuts(exact_form f[LANES], lanes *w, lanes *e, int own, uint64_t *random, const char *what) {
    int n = f[0].n;
    lanes largest = all_lanes(0);
    for (int j = 0; j <= n; j++) largest = larger(largest, absolute(w[j]));
    mpq_t ratio;
    mpq_init(ratio);
    for (int depth = 1; depth <= DEEP; depth++) {
        lanes left[MOST + 1], left_e[MOST + 1];
        double place = depth % 3 == 0 ? 0.5 : 0.5 + (0.5 - 0.5 / n) * random_unit(random);
        double at = ldexp(floor(ldexp(place, 30)), -30);
        int right = random_unit(random) > 0;
        widen_radii(w, e, n, own, 8 * n * 0x1p-53 * largest);
        for (int j = 0; j <= n && !own; j++) e[j] = e[0];
        if (depth % 2) {
            split(w, left, n, all_lanes(at), all_lanes(1 - at));
            split(e, left_e, n, all_lanes(at), all_lanes(1 - at));
        } else {
            split_shares(w, left, n, all_lanes(at), all_lanes(1 - at));
            split_shares(e, left_e, n, all_lanes(at), all_lanes(1 - at));
        }
        for (int j = 0; j <= n && !own; j++) e[j] = left_e[j] = e[0];
        for (int j = 0; j <= n && !right; j++) w[j] = left[j], e[j] = left_e[j];
        exact_set(ratio, at);
        for (int l = 0; l < LANES; l++) {
            form_cut(&f[l], ratio, right);
            judge(&f[l], w, e, l, depth, what);
        }
    }
    mpq_clear(ratio);
}

/* Exponents of few terms, or Chebyshev's polynomials in x, y, z, or all terms. */
static int make_terms(algsurf_term *t, int n, int kind, uint64_t *random) {
    int count = 0;
    if (kind == 0) {
        double c[2][MOST + 1] = {{1}, {0, 1}};
        for (int d = 2; d <= n; d++)
            for (int k = d; k >= 0; k--)
                c[d % 2][k] = (k ? 2 * c[(d + 1) % 2][k - 1] : 0) - (k <= d - 2 ? c[d % 2][k] : 0);
        for (int k = 0; k <= n; k++) {
            double a = k < n - 52 ? 0 : c[n % 2][k]; /* exact below 2^53 only; any number will do */
            if (a == 0) continue;
            t[count++] = (algsurf_term){k, 0, 0, a};
            if (k) t[count++] = (algsurf_term){0, k, 0, a}, t[count++] = (algsurf_term){0, 0, k, a};
        }
    } else if (kind == 1 || n > 10) {
        for (int m = 0; m < 12; m++) {
            int i = (int)(n * 0.5 * (1 + random_unit(random)));
            int j = (int)((n - i) * 0.5 * (1 + random_unit(random)));
            t[count++] = (algsurf_term){i, j, n - i - j, random_unit(random)};
        }
        t[count++] = (algsurf_term){0, 0, 0, random_unit(random)};
    } else {
        for (int i = 0; i <= n; i++)
            for (int j = 0; i + j <= n; j++)
                for (int k = 0; i + j + k <= n; k++)
                    t[count++] = (algsurf_term){i, j, k, random_unit(random)};
    }
    return count;
}

/* The surface's terms in natural units and scale, as the lanes know them. */
static void to_natural(const algsurf_surface *s, algsurf_term *t) {
    assert_ok(algsurf_surface_terms(s, t));
    for (size_t i = 0; i < s->term_count; i++)
        t[i].a = ldexp(t[i].a, s->unit * (t[i].i + t[i].j + t[i].k) + s->scale);
}

static void judge_rays(int n, int kind, uint64_t *random) {
    static algsurf_term terms[400];
    int count = make_terms(terms, n, kind, random);
    algsurf_surface *s = surface_of_terms(terms, (size_t)count);
    to_natural(s, terms);
    exact_form f[LANES];
    lanes b[MOST + 1], e[MOST + 1];
    chord_line line;
    n = s->node_degree;
    for (int l = 0; l < LANES; l++) {
        algsurf_ray ray = {{0}, {0}, 0, 0};
        double middle = 3 + random_unit(random), half = 0.5 + 0.25 * random_unit(random);
        for (int i = 0; i < 3; i++) {
            ray.direction[i] = random_unit(random);
            ray.origin[i] = random_unit(random) - middle * ray.direction[i];
            line.middle[i][l] = along(all_lanes(ray.origin[i]), all_lanes(0), all_lanes(middle),
                                      all_lanes(ray.direction[i]))[0];
            line.half[i][l] = half * ray.direction[i];
        }
        exact_line exact = exact_line_of(terms, (int)s->term_count, s->degree, &ray);
        form_init(&f[l], n);
        form_of_line(&f[l], &exact, middle, half);
        exact_line_clear(&exact);
    }
    coefficients_from_powers(s, &line, n, b, e);
    for (int l = 0; l < LANES; l++) judge(&f[l], b, e, l, 0, "rays");
    judge_cuts(f, b, e, 1, random, "cells of rays");
    for (int l = 0; l < LANES; l++) form_clear(&f[l]);
}

TEST(test_rays) {
    uint64_t random = SEED;
    for (size_t d = 0; d < sizeof degrees / sizeof *degrees; d++)
        for (int repeat = 0; repeat < (degrees[d] > 20 ? 1 : 4); repeat++)
            for (int kind = 0; kind < 3; kind++) judge_rays(degrees[d], kind, &random);
    assert_true(worst[0] > 0.01);
}

TEST(test_cuts) {
    uint64_t random = SEED + 1;
    for (int depth = 0; depth <= DEEP; depth++) worst[depth] = 0;
    for (size_t d = 0; d < sizeof degrees / sizeof *degrees; d++)
        for (int repeat = 0; repeat < (degrees[d] > 20 ? 2 : 20); repeat++) {
            exact_form f[LANES];
            lanes b[MOST + 1], e[MOST + 1];
            for (int l = 0; l < LANES; l++) form_init(&f[l], degrees[d]);
            for (int j = 0; j <= degrees[d]; j++) {
                e[j] = all_lanes(0);
                for (int l = 0; l < LANES; l++) {
                    b[j][l] = random_unit(&random);
                    exact_set(f[l].b[j], b[j][l]);
                }
            }
            judge_cuts(f, b, e, repeat % 2, &random, "exact coefficients");
            for (int l = 0; l < LANES; l++) form_clear(&f[l]);
        }
    for (int depth = 1; depth <= DEEP; depth++) assert_true(worst[depth] > 0.01);
}

/* Counts of signs that are not all known, against those of every choice of the others. */
TEST(test_count) {
    enum { N = 5, ALL = 243 }; /* 3^N: each coefficient after the first is sure, or not */
    for (int code = 0; code < ALL; code++) {
        int known_sign[N + 1] = {1}, none = 1, one = 1;
        lanes w[N + 1], e[N + 1];
        w[0] = all_lanes(1), e[0] = all_lanes(0.5);
        for (int j = 1, rest = code; j <= N; j++, rest /= 3) {
            known_sign[j] = rest % 3 - 1;
            w[j] = all_lanes(known_sign[j] ? known_sign[j] : 0.25), e[j] = all_lanes(0.5);
        }
        if (known_sign[N] == 0) continue; /* the walk has left such a cell */
        for (int choice = 0; choice < 1 << N; choice++) {
            int variations = 0, before = 1;
            for (int j = 1; j <= N; j++) {
                int sign = known_sign[j] ? known_sign[j] : choice >> (j - 1) & 1 ? 1 : -1;
                variations += sign != before;
                before = sign;
            }
            none &= variations == 0, one &= variations == 1;
        }
        for (int flip = 0; flip < 2; flip++) {
            for (int j = 0; j <= N && flip; j++) w[j] = -w[j];
            assert_int_equal(bits(negative(take_sign(w, N, ~no_lane()))), flip ? 3 : 0);
            signs c = count_signs(w, e, N, 1);
            assert_int_equal(bits(c.none), none ? 3 : 0);
            assert_int_equal(bits(c.one), one ? 3 : 0);
        }
    }
}
