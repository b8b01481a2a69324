/* test_beam.c - what is said of all rays of a tile holds for each of them, over rationals.
 *
 * Two attacks, on random surfaces of degree 1 to 12, random views and tiles, and random rays of these tiles,
 * their edges among them.  A row of tiles: the Bernstein coefficients of P along a ray may differ from those
 * of the form by what its radius says.  Tiles that a kernel has searched: along a ray of an empty one P has
 * no root on its chord, along a ray of a sheet one root between low and high, none on the chord before, and
 * |P'| is there what `enough` says; along a ray of a leaf there is no root on the chord before low.  P is
 * what the frame has, each of its doubles taken as it is; the frame itself is attacked through pictures, by
 * test_masks.
 *
 * Breaks tried, each caught by the test named:
 *   terms of the fourth order left out of the rest, or those beyond it; the rest a tenth: the_rest_is_felt
 *   the extent not widened, or not narrowed, for chords; half of the first order; a root before taken for
 *   none behind; differences of the middle ray alone: tiles_are_what_is_said
 *   tiles four fifths as large: both
 *   a number of turns that depends on what is searched beside: kernels_find_the_same_tiles
 *   no rounding: errors_are_felt
 *   what noise makes of P left out of what is enough: noise_is_felt
 * Caught with 20000 rays: a size left out of the search.
 * Caught with 60000 rays: the first sign taken as known.  Not caught: a hundredth of the rounding's weight,
 * which is far below what else a tile leaves open.
 *
 *     test_beam [rays [seed]]
 */
#include "exact_hits.h"
#include "picture/impl.h"
#include "simd/kernel.h"
#include "unit.h"

enum { MOST = ALGSURF_MAX_BEAM_DEGREE, SIDE = MOST + 1, PIXELS = 64, PLACES = PIXELS / ALGSURF_I_LEAF };

ARGUMENT(1, long, ray_count, 1200)
ARGUMENT(2, uint64_t, first_seed, 20261123)

/* A surface and a view of it. */
typedef struct test_view {
    algsurf_surface *surface;
    algsurf_i_frame_form frame;
    double q[SIDE * SIDE * SIDE], basis[SIDE * SIDE], sizes[SIDE * SIDE], along[SIDE * SIDE];
    double g[SIDE * SIDE * SIDE], c[SIDE * SIDE * SIDE], square[SIDE * SIDE];
} test_view;

static void make_frame(test_view *v, uint64_t *seed, int degree, const algsurf_term *terms, size_t count) {
    assert_ok(algsurf_surface_from_terms(terms, count, &v->surface));
    algsurf_i_view *view = &v->frame.view;
    memset(view, 0, sizeof *view);
    v->frame.q = v->q, v->frame.basis = v->basis, v->frame.sizes = v->sizes, v->frame.along = v->along;
    for (int i = 0; i < 3; i++) view->axis[i][i] = 1, view->centre[i] = random_between(seed, -0.2, 0.2);
    view->size = random_between(seed, 0.5, 1.5);
    if (random_int(seed, 3)) {
        view->alpha = 1 / random_between(seed, 1.2, 8);
        for (int k = 0; k < 2; k++) view->beta[k] = random_int(seed, 2) ? random_between(seed, -0.1, 0.1) : 0;
    }
    view->noise = 0x1p-50;
    void *memory = malloc(algsurf_i_frame_memory(degree));
    assert_int_equal(algsurf_i_frame_expand(v->surface, &v->frame, memory), 1);
    free(memory);
    algsurf_i_beam_expand(&v->frame, v->g);
}

static void set_view(test_view *v, uint64_t *seed, int degree) {
    algsurf_term terms[3 * SIDE * SIDE];
    size_t count = 0;
    for (int i = 0; i <= degree; i++)
        for (int j = 0; i + j <= degree; j++) {
            int k = random_int(seed, degree - i - j + 1);
            terms[count++] = (algsurf_term){i, j, k, random_between(seed, -1, 1)};
        }
    terms[count++] = (algsurf_term){0, 0, degree, 1};
    make_frame(v, seed, degree, terms, count);
}

/* p becomes (a + b z) p, of degree n at most. */
static void exact_times(mpq_t *p, int n, const mpq_t a, const mpq_t b) {
    mpq_t w;
    mpq_init(w);
    for (int k = n; k >= 0; k--) {
        mpq_mul(p[k], p[k], a);
        if (k > 0) mpq_mul(w, p[k - 1], b), mpq_add(p[k], p[k], w);
    }
    mpq_clear(w);
}

/* P along the ray (u,v), in powers of z. */
static void exact_along_ray(const test_view *t, const mpq_t u, const mpq_t v, mpq_t *p) {
    int n = t->frame.degree, side = n + 1;
    const algsurf_i_view *view = &t->frame.view;
    mpq_t slope[2], w, row[SIDE];
    mpq_inits(slope[0], slope[1], w, NULL);
    for (int k = 0; k <= n; k++) mpq_init(row[k]), mpq_set_ui(p[k], 0, 1);
    for (int axis = 0; axis < 2; axis++) {
        exact_set(w, view->alpha), mpq_mul(slope[axis], w, axis ? v : u);
        exact_set(w, view->beta[axis]), mpq_add(slope[axis], slope[axis], w);
    }
    for (int i = n; i >= 0; i--) {
        for (int k = 0; k <= n; k++) mpq_set_ui(row[k], 0, 1);
        for (int j = n - i; j >= 0; j--) {
            exact_times(row, n, v, slope[1]);
            for (int k = 0; i + j + k <= n; k++)
                exact_set(w, t->q[(i * side + j) * side + k]), mpq_add(row[k], row[k], w);
        }
        exact_times(p, n, u, slope[0]);
        for (int k = 0; k <= n; k++) mpq_add(p[k], p[k], row[k]);
    }
    for (int k = 0; k <= n; k++) mpq_clear(row[k]);
    mpq_clears(slope[0], slope[1], w, NULL);
}

/* Bernstein coefficient j over [-1,1]. */
static void exact_coefficient(mpq_t b, const mpq_t *p, int n, int j) {
    mpq_t w;
    mpz_t sum, one, two;
    mpq_init(w), mpz_inits(sum, one, two, NULL);
    mpq_set_ui(b, 0, 1);
    for (int k = 0; k <= n; k++) {
        mpz_set_ui(sum, 0);
        for (int l = 0; l <= k; l++) {
            if (l > j || k - l > n - j) continue;
            mpz_bin_uiui(one, (unsigned long)j, (unsigned long)l);
            mpz_bin_uiui(two, (unsigned long)(n - j), (unsigned long)(k - l));
            mpz_mul(one, one, two);
            if ((k - l) % 2) mpz_neg(one, one);
            mpz_add(sum, sum, one);
        }
        mpz_bin_uiui(two, (unsigned long)n, (unsigned long)k);
        mpq_set_z(w, sum), mpz_set(mpq_denref(w), two), mpq_canonicalize(w);
        mpq_mul(w, w, p[k]), mpq_add(b, b, w);
    }
    mpq_clear(w), mpz_clears(sum, one, two, NULL);
}

static void new_exact(mpq_t *p, int n) {
    for (int k = 0; k <= n; k++) mpq_init(p[k]);
}

static void free_exact(mpq_t *p, int n) {
    for (int k = 0; k <= n; k++) mpq_clear(p[k]);
}

/* How much of its bound the error of the row's coefficient k takes, at (u, eta). */
static double share_of_bound(const test_view *t, const algsurf_i_beam_row *row, const mpq_t *p, double u,
                             double eta, int k) {
    int n = t->frame.degree, side = n + 1;
    const algsurf_i_view *view = &t->frame.view;
    double x = fabs(u) * (1 + fabs(view->alpha)) + fabs(view->beta[0]), bound = 0;
    mpq_t exact, sum, w, at, power;
    mpq_inits(exact, sum, w, at, power, NULL);
    exact_coefficient(exact, p, n, k);
    exact_set(at, eta), mpq_set_ui(power, 1, 1);
    for (int j = 0; j <= n; j++) {
        mpq_t inner, place;
        mpq_inits(inner, place, NULL);
        exact_set(place, u);
        for (int i = n - j; i >= 0; i--) {
            mpq_mul(inner, inner, place);
            exact_set(w, row->c[(k * side + j) * side + i]), mpq_add(inner, inner, w);
        }
        mpq_mul(inner, inner, power), mpq_add(sum, sum, inner), mpq_mul(power, power, at);
        mpq_clears(inner, place, NULL);
    }
    mpq_sub(sum, sum, exact), mpq_abs(sum, sum);
    for (int i = n; i >= 0; i--) bound = bound * x + row->radius[i];
    double share = mpq_get_d(sum) / bound;
    mpq_clears(exact, sum, w, at, power, NULL);
    return share;
}

TEST(rows_of_tiles_keep_their_bound) {
    uint64_t seed = first_seed;
    double worst = 0, least = 1;
    for (long turn = 0; turn < ray_count / 10; turn++) {
        static test_view t;
        int degree = 1 + (int)(turn % MOST);
        set_view(&t, &seed, degree);
        algsurf_i_beam_row row = {.c = t.c};
        double h = ldexp(1, -random_int(&seed, 10) - 3), v = random_between(&seed, -1, 1);
        algsurf_i_beam_row_expand(&t.frame, t.g, v, h, h, t.square, &row);
        double u = random_between(&seed, -1, 1),
               eta = random_int(&seed, 3) ? random_between(&seed, -1, 1) : 1;
        mpq_t p[SIDE], at[2], w;
        new_exact(p, degree), mpq_inits(at[0], at[1], w, NULL);
        exact_set(at[0], u), exact_set(at[1], eta);
        exact_set(w, h), mpq_mul(at[1], at[1], w), exact_set(w, v), mpq_add(at[1], at[1], w);
        exact_along_ray(&t, at[0], at[1], p);
        double most = 0;
        for (int k = 0; k <= degree; k++) {
            double share = share_of_bound(&t, &row, (const mpq_t *)p, u, eta, k);
            if (share > most) most = share;
        }
        if (most > 1) {
            fprintf(stderr, "turn %ld (seed %#llx): degree %d, u %a, v %a, h %a, eta %a: %g of the bound\n",
                    turn, (unsigned long long)first_seed, degree, u, v, h, eta, most);
        }
        assert_true(most <= 1);
        if (most > worst) worst = most;
        if (most < least) least = most;
        free_exact(p, degree), mpq_clears(at[0], at[1], w, NULL);
        algsurf_surface_free(t.surface);
    }
    printf("rows of tiles: the worst error is %.3g of its bound\n", worst);
    assert_true(worst > 0x1p-14);
}

/* ---- tiles ---- */

/* One band of tiles, about the middle of the picture. */
typedef struct test_band {
    algsurf_i_row_job rays;
    algsurf_extent extent;
    algsurf_i_tile tiles[PLACES * PLACES];
    int cell[PLACES * PLACES], size;
    double v0, side; /* v = v0 - side y */
} test_band;

static void set_band(test_band *b, const test_view *t, uint64_t *seed) {
    b->side = ldexp(random_between(seed, 1, 2), -random_int(seed, 5) - 5);
    b->v0 = random_between(seed, -0.6, 0.6) + b->side * PIXELS / 2;
    b->extent = (algsurf_extent){.kind = ALGSURF_EXTENT_SPHERE};
    b->rays = (algsurf_i_row_job){.view = &t->frame.view,
                                  .offset = -PIXELS / 2,
                                  .pixel = b->side,
                                  .u0 = random_between(seed, -0.6, 0.6),
                                  .du = 1,
                                  .extent = &b->extent,
                                  .extent_size = {random_between(seed, 0.5, 1)},
                                  .near = t->frame.view.alpha > 0 ? -1 / t->frame.view.alpha : -1.5};
    b->size = ALGSURF_I_LEAF << random_int(seed, 3);
}

/* All tiles of the band, of one size. */
static void search_band(test_band *b, test_view *t, const algsurf_i_beams_kernel *code) {
    algsurf_i_beam_row row = {.c = t->c};
    algsurf_i_tile_job job = {.row = &b->rays,
                              .beam = &row,
                              .size = b->size,
                              .noise = t->frame.value_error,
                              .cell = b->cell,
                              .stride = PLACES,
                              .tiles = b->tiles};
    memset(b->cell, 0, sizeof b->cell);
    for (; job.y < PIXELS; job.y += b->size) {
        int at[PLACES];
        double from[PLACES], half = 0.5 * b->size, h = b->side * half + ALGSURF_I_WIDER;
        job.count = 0, job.at = at, job.from = from;
        for (int x = 0; x < PIXELS; x += b->size) at[job.count] = x, from[job.count++] = -1;
        algsurf_i_beam_row_expand(&t->frame, t->g, b->v0 - b->side * (job.y + half), -h, h, t->square, &row);
        code->search_tiles(&job);
        if (b->size == ALGSURF_I_LEAF) continue;
        for (int i = 0; i < job.count; i++) /* what is left is nothing that is said */
            for (int y = job.y / 4; y < (job.y + b->size) / 4; y++)
                for (int x = at[i] / 4; x < (at[i] + b->size) / 4; x++) b->cell[y * PLACES + x] = -1;
    }
}

/* Depths where the ray is surely inside the ball, in front of the eye; 0: nowhere. */
static int chord_of(const test_band *b, const algsurf_i_view *view, double u, double v, double chord[2]) {
    double s = view->alpha * u + view->beta[0], t = view->alpha * v + view->beta[1],
           r = b->rays.extent_size[0];
    double size = 1 + s * s + t * t, middle = -(u * s + v * t) / size;
    double inside = middle * middle - (u * u + v * v - r * r) / size;
    if (inside <= 0x1p-20) return 0;
    chord[0] = fmax(middle - sqrt(inside), b->rays.near) + 0x1p-30;
    chord[1] = middle + sqrt(inside) - 0x1p-30;
    return chord[0] < chord[1];
}

static struct { long empty, sheets, open, begun; } seen;

/* The ray has no root on its chord before its leaf says. */
static const char *judge_leaf(const exact_sturm *chain, const mpq_t lo, const mpq_t hi,
                              const algsurf_i_tile *leaf) {
    const char *wrong = NULL;
    mpq_t low;
    mpq_init(low);
    exact_set(low, leaf->low);
    if (mpq_cmp(lo, low) < 0) {
        seen.begun++;
        if (exact_between_q(chain, lo, mpq_cmp(low, hi) < 0 ? low : hi) > 0) wrong = "a root before a leaf";
    }
    mpq_clear(low);
    return wrong;
}

/* What is said of the tile holds for the ray: null, or what does not. */
static const char *judge(const test_view *t, const mpq_t *p, const double chord[2],
                         const algsurf_i_tile *tile) {
    int n = t->frame.degree;
    const char *wrong = NULL;
    mpz_t *c = exact_polynomials(1, n + 1), common;
    mpq_t w, lo, hi;
    mpz_init_set_ui(common, 1), mpq_inits(w, lo, hi, NULL);
    for (int k = 0; k <= n; k++) mpz_lcm(common, common, mpq_denref(p[k]));
    for (int k = 0; k <= n; k++) {
        mpq_set_z(w, common), mpq_mul(w, w, p[k]);
        mpz_set(c[k], mpq_numref(w));
    }
    exact_sturm chain = exact_sturm_of(c, n);
    exact_set(lo, chord[0]), exact_set(hi, chord[1]);
    if (!tile) {
        if (exact_between_q(&chain, lo, hi) > 0) wrong = "a root in an empty tile";
    } else if (tile->enough == 0) {
        wrong = judge_leaf(&chain, lo, hi, tile);
    } else {
        mpq_t low, high;
        mpq_inits(low, high, NULL);
        exact_set(low, tile->low), exact_set(high, tile->high);
        if (exact_between_q(&chain, low, high) != 1) wrong = "not one root in a sheet";
        if (mpq_cmp(lo, low) < 0 && exact_between_q(&chain, lo, low) != 0) wrong = "a root before a sheet";
        if (mpq_cmp(low, lo) < 0 || mpq_cmp(hi, high) < 0) wrong = "a sheet beyond the chord";
        for (int i = 0; i <= 4; i++) {
            double z = tile->low + (tile->high - tile->low) * i / 4, slope = 0;
            for (int k = n; k >= 1; k--) slope = slope * z + k * mpq_get_d(p[k]);
            if (!(fabs(slope) * ALGSURF_I_NEAR > 1.999 * tile->enough)) wrong = "a sheet too steep";
        }
        mpq_clears(low, high, NULL);
    }
    exact_sturm_clear(&chain);
    exact_free(c, n + 1), mpz_clear(common), mpq_clears(w, lo, hi, NULL);
    return wrong;
}

/* A ray of one of the tiles in a square of them, so many from the first on in both directions. */
static void check_ray(test_view *t, const test_band *b, int first, int tiles, uint64_t *seed, long turn) {
    static const double ends[] = {0, 1};
    double at[2], u, v, chord[2];
    for (int k = 0; k < 2; k++) { /* an edge of a tile, now and then */
        double within = random_int(seed, 3) ? random_between(seed, 0, 1) : ends[random_int(seed, 2)];
        at[k] = b->size * (first + random_int(seed, tiles) + within);
    }
    u = b->rays.u0 + (at[0] - PIXELS / 2) * b->side, v = b->v0 - b->side * at[1];
    if (!chord_of(b, &t->frame.view, u, v, chord)) return;
    mpq_t p[SIDE], place[2];
    int n = t->frame.degree;
    new_exact(p, n), mpq_inits(place[0], place[1], NULL);
    exact_set(place[0], u), exact_set(place[1], v);
    exact_along_ray(t, place[0], place[1], p);
    for (int side = 0; side < 4; side++) { /* a ray of an edge belongs to both tiles */
        double x = at[0] - (side & 1 ? 0x1p-20 : 0), y = at[1] - (side & 2 ? 0x1p-20 : 0);
        if (x < 0 || y < 0 || x >= PIXELS || y >= PIXELS) continue;
        int cell = b->cell[(int)(y / 4) * PLACES + (int)(x / 4)];
        const algsurf_i_tile *tile = cell > 0 ? b->tiles + cell - 1 : NULL;
        if (cell < 0 || (tile && tile->enough == 0)) seen.open++;
        if (cell < 0) continue;
        const char *wrong = judge(t, (const mpq_t *)p, chord, tile);
        if (wrong)
            fprintf(stderr, "turn %ld (seed %#llx): degree %d, size %d, pixel (%a,%a), u %a, v %a: %s\n",
                    turn, (unsigned long long)first_seed, n, b->size, at[0], at[1], u, v, wrong);
        assert_null(wrong);
        seen.sheets += tile && tile->enough > 0;
        seen.empty += !tile;
    }
    free_exact(p, n), mpq_clears(place[0], place[1], NULL);
}

TEST(tiles_are_what_is_said) {
    uint64_t seed = first_seed;
    static test_view t;
    static test_band b;
    for (long turn = 0; turn < ray_count; turn++) {
        if (turn % 20 == 0) {
            if (turn > 0) algsurf_surface_free(t.surface);
            set_view(&t, &seed, 1 + (int)(turn / 20 % MOST));
            set_band(&b, &t, &seed);
            search_band(&b, &t, algsurf_i_beams_kernel_for(algsurf_i_kernel_find(NULL)));
        }
        check_ray(&t, &b, 0, PIXELS / b.size, &seed, turn);
    }
    algsurf_surface_free(t.surface);
    printf("tiles: %ld rays of empty ones, %ld of sheets, %ld not decided; 0 wrong\n", seen.empty,
           seen.sheets, seen.open);
    printf("leaves: %ld rays whose leaf begins behind their chord's begin\n", seen.begun);
    assert_true(seen.empty * 10 > ray_count && seen.sheets * 10 > ray_count && seen.begun * 100 > ray_count);
}

/* c + w z - x^4 - y^4 - d x^5 where |x| = |y| = h at a tile's corners: what it is hangs on the fourth order,
 * or on the fifth. */
TEST(the_rest_is_felt) {
    uint64_t seed = first_seed;
    static test_view t;
    static test_band b;
    memset(&seen, 0, sizeof seen);
    for (long turn = 0; turn < ray_count / 10; turn++) {
        double h = ldexp(random_between(&seed, 1, 2), -4), fourth = pow(h, 4),
               c = random_between(&seed, 0.2, 3) * fourth;
        const algsurf_term terms[] = {{0, 0, 0, c},
                                      {0, 0, 1, random_between(&seed, -0.2, 0.2) * fourth},
                                      {4, 0, 0, -1},
                                      {0, 4, 0, -random_between(&seed, 0, 1)},
                                      {5, 0, 0, random_int(&seed, 2) ? -1 / h : 0}};
        make_frame(&t, &seed, 5, terms, sizeof terms / sizeof *terms);
        algsurf_i_view *view = &t.frame.view;
        double unit = ldexp(1, -t.surface->unit); /* from the terms' to the view's */
        view->size = 1, view->alpha = 0, view->beta[0] = view->beta[1] = 0;
        for (int i = 0; i < 3; i++) view->centre[i] = 0;
        void *memory = malloc(algsurf_i_frame_memory(5));
        assert_int_equal(algsurf_i_frame_expand(t.surface, &t.frame, memory), 1);
        free(memory);
        algsurf_i_beam_expand(&t.frame, t.g);
        set_band(&b, &t, &seed);
        b.size = 16, b.side = h * unit / 8, b.rays.pixel = b.side, b.rays.u0 = -8 * b.side;
        b.v0 = 40 * b.side; /* the tile from pixel (32,32) on has its middle at 0 */
        search_band(&b, &t, algsurf_i_beams_kernel_for(algsurf_i_kernel_find(NULL)));
        for (int i = 0; i < 20; i++) check_ray(&t, &b, 2, 1, &seed, turn);
        algsurf_surface_free(t.surface);
    }
    printf("rest: %ld rays of empty tiles, %ld of sheets, %ld not decided; 0 wrong\n", seen.empty,
           seen.sheets, seen.open);
    assert_true(seen.empty * 2 > ray_count && seen.open > 0);
}

/* With coefficients that may be anything nothing is known of a tile that has a chord. */
TEST(errors_are_felt) {
    uint64_t seed = first_seed;
    long tiles = 0;
    for (int turn = 0; turn < 60; turn++) {
        static test_view t;
        static test_band b;
        set_view(&t, &seed, 1 + turn % MOST);
        memset(&b, 0, sizeof b);
        set_band(&b, &t, &seed);
        b.size = ALGSURF_I_LEAF;
        t.frame.spread = 4;
        search_band(&b, &t, algsurf_i_beams_kernel_for(algsurf_i_kernel_find(NULL)));
        for (int c = 0; c < PLACES * PLACES; c++) {
            double chord[2], middle = 0.5 * ALGSURF_I_LEAF;
            double x = c % PLACES * ALGSURF_I_LEAF + middle, y = c / PLACES * ALGSURF_I_LEAF + middle;
            double u = b.rays.u0 + (x - PIXELS / 2) * b.side, v = b.v0 - b.side * y;
            if (!chord_of(&b, &t.frame.view, u, v, chord)) continue;
            assert_true(b.cell[c] > 0 && b.tiles[b.cell[c] - 1].enough == 0);
            tiles++;
        }
        algsurf_surface_free(t.surface);
    }
    assert_true(tiles > 1000);
}

/* s z - x = 0 with a small s: what noise moves points by across, changes P by 1 / s times what it changes P
 * by in depth. */
TEST(noise_is_felt) {
    uint64_t seed = first_seed;
    long sheets[2] = {0, 0};
    for (int turn = 0; turn < 200; turn++) {
        static test_view t;
        static test_band b;
        double s = ldexp(random_between(&seed, 1, 2), -9 - turn % 4);
        const algsurf_term terms[] = {{1, 0, 0, -1}, {0, 0, 1, s}};
        make_frame(&t, &seed, 1, terms, 2);
        algsurf_i_view *view = &t.frame.view;
        view->size = 1, view->alpha = view->beta[0] = view->beta[1] = 0;
        for (int i = 0; i < 3; i++) view->centre[i] = 0;
        view->noise = ldexp(random_between(&seed, 1, 2), turn % 2 ? -24 : -40);
        void *memory = malloc(algsurf_i_frame_memory(1));
        assert_int_equal(algsurf_i_frame_expand(t.surface, &t.frame, memory), 1);
        free(memory);
        algsurf_i_beam_expand(&t.frame, t.g);
        set_band(&b, &t, &seed);
        b.size = ALGSURF_I_LEAF, b.side = s / 64, b.rays.pixel = b.side, b.rays.u0 = 0, b.v0 = 0.1;
        search_band(&b, &t, algsurf_i_beams_kernel_for(algsurf_i_kernel_find(NULL)));
        double felt = t.frame.value_error + view->noise * (fabs(t.q[4]) + fabs(t.q[1]));
        for (int c = 0; c < PLACES * PLACES; c++) {
            const algsurf_i_tile *tile = b.cell[c] > 0 ? b.tiles + b.cell[c] - 1 : NULL;
            if (!tile || tile->enough == 0) continue;
            sheets[turn % 2]++;
            if (!(felt <= tile->enough * (1 + 0x1p-20)))
                fail_msg("turn %d (seed %#llx): s %a, noise %a: %a is enough", turn,
                         (unsigned long long)first_seed, s, view->noise, tile->enough);
        }
        algsurf_surface_free(t.surface);
    }
    printf("noise: %ld sheets with little of it, %ld with much\n", sheets[0], sheets[1]);
    assert_true(sheets[0] > 1000);
}

TEST(kernels_find_the_same_tiles) {
    uint64_t seed = first_seed;
    for (int turn = 0; turn < 60; turn++) {
        static test_view t;
        static test_band b, other;
        set_view(&t, &seed, 1 + turn % MOST);
        memset(&b, 0, sizeof b);
        set_band(&b, &t, &seed);
        other = b;
        search_band(&b, &t, &algsurf_i_beams_baseline);
        for (int i = 0; i < ALGSURF_KERNELS; i++) {
            const algsurf_i_kernel *kernel = algsurf_i_kernel_at(i);
            if (!kernel) continue;
            search_band(&other, &t, algsurf_i_beams_kernel_for(kernel));
            for (int c = 0; c < PLACES * PLACES; c++) {
                assert_int_equal(b.cell[c] > 0, other.cell[c] > 0);
                assert_int_equal(b.cell[c] < 0, other.cell[c] < 0);
                if (b.cell[c] <= 0) continue; /* their numbers depend on how many are searched at once */
                const algsurf_i_tile *one = b.tiles + b.cell[c] - 1, *two = other.tiles + other.cell[c] - 1;
                assert_memory_equal(one, two, sizeof *one);
            }
        }
        algsurf_surface_free(t.surface);
    }
}
