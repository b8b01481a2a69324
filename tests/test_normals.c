/* test_normals.c - normals against exact gradients, where rounding takes the digits of P's: far from the
 * origin, in high powers, beside singular points, at all sizes.
 *
 * The root's point comes from bisection in rationals.  What a hit may be off by is 10^-4 degrees, beside what
 * the gradient changes by from there to the reported position.
 *
 * Breaks tried, each caught by the tests named:
 *   doubles always                       far_out, powers
 *   8 bits of the gradient enough        far_out
 *   packets' normals as they are         far_out
 *   steps before the point at once       far_out, near_tips
 *   the form's exponents left out        far_out, scaled
 */
#include "exact_ray.h"
#include "scenes.h"

static const uint64_t seed = 20251125;

enum { MOST_TERMS = 50000 };

typedef struct body {
    algsurf_term *term;
    int count, degree;
    algsurf_surface *surface;
} body;

/* ---- P as a product, in doubles that are exact where the test says so ---- */

static void add(body *b, int i, int j, int k, double a) {
    for (int t = 0; t < b->count; t++) {
        algsurf_term *term = b->term + t;
        if (term->i != i || term->j != j || term->k != k) continue;
        term->a += a;
        return;
    }
    assert_true(b->count < MOST_TERMS);
    b->term[b->count++] = (algsurf_term){i, j, k, a};
}

static body constant(double a) {
    body b = {.term = malloc(MOST_TERMS * sizeof *b.term), .count = 1};
    assert_non_null(b.term);
    b.term[0] = (algsurf_term){0, 0, 0, a};
    return b;
}

static void multiply(body *b, const algsurf_term *by, int count, int degree) {
    body product = constant(0);
    for (int t = 0; t < b->count; t++)
        for (int u = 0; u < count; u++)
            add(&product, b->term[t].i + by[u].i, b->term[t].j + by[u].j, b->term[t].k + by[u].k,
                b->term[t].a * by[u].a);
    product.degree = b->degree + degree;
    free(b->term);
    *b = product;
}

/* w0 (x - c0)^2 + w1 (y - c1)^2 + w2 (z - c2)^2 - r */
static void times_quadric(body *b, const double c[3], const double w[3], double r) {
    algsurf_term q[7] = {{0, 0, 0, w[0] * c[0] * c[0] + w[1] * c[1] * c[1] + w[2] * c[2] * c[2] - r}};
    for (int i = 0; i < 3; i++) {
        q[1 + i] = (algsurf_term){i == 0, i == 1, i == 2, -2 * w[i] * c[i]};
        q[4 + i] = (algsurf_term){2 * (i == 0), 2 * (i == 1), 2 * (i == 2), w[i]};
    }
    multiply(b, q, 7, 2);
}

static void finish(body *b) {
    int kept = 0;
    for (int t = 0; t < b->count; t++)
        if (b->term[t].a != 0) b->term[kept++] = b->term[t];
    b->count = kept;
    assert_ok(algsurf_surface_from_terms(b->term, (size_t)kept, &b->surface));
}

static void drop(body *b) {
    algsurf_surface_free(b->surface);
    free(b->term);
}

/* ---- exact gradients ---- */

static void exact_power(mpq_t q, const mpq_t x, int n) {
    mpz_pow_ui(mpq_numref(q), mpq_numref(x), (unsigned long)n);
    mpz_pow_ui(mpq_denref(q), mpq_denref(x), (unsigned long)n);
}

/* Its direction, rounded; 0: there is none. */
static int exact_direction(const body *b, mpq_t x[3], long double unit[3]) {
    mpq_t sum[3], term, factor;
    mpf_t top, f;
    mpf_init2(top, 256), mpf_init2(f, 256);
    mpq_inits(sum[0], sum[1], sum[2], term, factor, NULL);
    for (int t = 0; t < b->count; t++)
        for (int axis = 0; axis < 3; axis++) {
            int e[3] = {b->term[t].i, b->term[t].j, b->term[t].k};
            if (e[axis] == 0) continue;
            exact_set(term, b->term[t].a), mpq_set_si(factor, e[axis]--, 1), mpq_mul(term, term, factor);
            for (int i = 0; i < 3; i++) exact_power(factor, x[i], e[i]), mpq_mul(term, term, factor);
            mpq_add(sum[axis], sum[axis], term);
        }
    for (int i = 0; i < 3; i++) {
        mpf_set_q(f, sum[i]), mpf_abs(f, f);
        if (mpf_cmp(f, top) > 0) mpf_set(top, f);
    }
    int found = mpf_sgn(top) != 0;
    long double length = 0;
    for (int i = 0; i < 3 && found; i++) {
        mpf_set_q(f, sum[i]), mpf_div(f, f, top);
        unit[i] = mpf_get_d(f), length += unit[i] * unit[i];
    }
    for (int i = 0; i < 3 && found; i++) unit[i] /= sqrtl(length);
    mpq_clears(sum[0], sum[1], sum[2], term, factor, NULL);
    mpf_clear(top), mpf_clear(f);
    return found;
}

static double degrees_between(const long double a[3], const long double b[3]) {
    long double cross = 0, dot = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        long double c = a[j] * b[k] - a[k] * b[j];
        cross += c * c, dot += a[i] * b[i];
    }
    return (double)(atan2l(sqrtl(cross), dot) * 57.29577951308232L);
}

/* The root in [t_lo,t_hi] as the middle of a rational interval. */
static void root_of(mpq_t root, const body *b, const algsurf_ray *ray, const algsurf_hit *hit) {
    exact_line line = exact_line_of(b->term, b->count, b->degree, ray);
    mpq_t lo, hi, value, c;
    mpq_inits(lo, hi, value, c, NULL);
    exact_set(lo, hit->t_lo), exact_set(hi, hit->t_hi);
    for (int step = 0; step <= 120; step++) {
        mpq_add(root, lo, hi), mpq_div_2exp(root, root, 1);
        if (mpq_equal(lo, hi)) break;
        mpq_set_si(value, 0, 1);
        for (int k = b->degree; k >= 0; k--)
            mpq_mul(value, value, root), mpq_set_z(c, line.c[k]), mpq_add(value, value, c);
        if (mpq_sgn(value) == 0) break;
        mpq_set(mpq_sgn(value) == hit->side ? lo : hi, root);
    }
    mpq_clears(lo, hi, value, c, NULL);
    exact_line_clear(&line);
}

typedef struct tally {
    int hits, sharp; /* simple hits; those of which the normal is the root's to 10^-6 degrees */
} tally;

static void check_normal(const body *b, const algsurf_ray *ray, const algsurf_hit *hit, const char *family,
                         tally *judged) {
    mpq_t t, x[3], p[3];
    long double at_root[3], there[3], normal[3];
    if (hit->state != ALGSURF_STATE_HIT || hit->multiplicity != 1) return;
    mpq_inits(t, x[0], x[1], x[2], p[0], p[1], p[2], NULL);
    root_of(t, b, ray, hit);
    for (int i = 0; i < 3; i++) {
        exact_set(x[i], ray->direction[i]), mpq_mul(x[i], x[i], t);
        exact_set(p[i], ray->origin[i]), mpq_add(x[i], x[i], p[i]);
        exact_set(p[i], hit->position[i]);
        normal[i] = hit->normal[i];
    }
    assert_true(exact_direction(b, x, at_root));
    double allowed = exact_direction(b, p, there) ? 1.01 * degrees_between(at_root, there) + 1e-4 : 180;
    double off = degrees_between(normal, at_root);
    if (!(off <= allowed)) {
        exact_print_doubles("origin, direction", ray->origin, 6);
        exact_print_doubles("position, normal", hit->position, 6);
        fail_msg("%s, seed %llu: off by %g degrees, not %g", family, (unsigned long long)seed, off, allowed);
    }
    judged->hits++;
    judged->sharp += off < 1e-6;
    mpq_clears(t, x[0], x[1], x[2], p[0], p[1], p[2], NULL);
}

/* A ray's hits, the first one also alone and in a packet that asks for normals only: the same normal. */
static void check_ray(const body *b, const algsurf_ray *ray, const algsurf_extent *extent, const char *family,
                      tally *judged) {
    algsurf_hit hits[ALGSURF_MAX_DEGREE], first;
    int count;
    assert_ok(algsurf_intersect_all(b->surface, extent, ray, NULL, hits, ALGSURF_MAX_DEGREE, &count));
    assert_ok(algsurf_intersect_first(b->surface, extent, ray, NULL, &first));
    for (int k = 0; k < count; k++) check_normal(b, ray, hits + k, family, judged);
    check_normal(b, ray, &first, family, judged);
    const double *o = ray->origin, *d = ray->direction;
    unsigned char state;
    double normal[3];
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = 1,
                                     .origin = {o, o + 1, o + 2},
                                     .direction = {d, d + 1, d + 2},
                                     .t_min = &ray->t_min,
                                     .t_max = &ray->t_max};
    const algsurf_hit_packet to = {
        .size = sizeof to, .state = &state, .normal = {normal, normal + 1, normal + 2}};
    assert_ok(algsurf_intersect_packet(b->surface, extent, &rays, NULL, &to));
    assert_int_equal(state, first.state);
    assert_memory_equal(normal, first.normal, sizeof normal);
}

/* A ray that begins some radii from a place and passes it within one. */
static algsurf_ray ray_about(const double place[3], double radius, double near, uint64_t *random) {
    algsurf_ray ray = {.t_min = 0, .t_max = INFINITY};
    for (int i = 0; i < 3; i++) {
        double start = place[i] + 8 * radius * random_unit(random);
        double end = place[i] + near * radius * random_unit(random);
        ray.origin[i] = start, ray.direction[i] = end - start;
    }
    return ray;
}

/* ---- the families ---- */

static const double round_weights[3] = {1, 1, 1}, cone_weights[3] = {1, 1, -1};

/* Quadrics and products of two with exact coefficients, 10^3 to 10^6 radii from the origin. */
TEST(far_out) {
    uint64_t random = seed;
    tally judged = {0};
    for (int turn = 0; turn < 120; turn++) {
        const int s = 7 + turn % 11, quartic = turn % 2; /* centres m 2^s, |m| < 128, with few bits */
        double c[3], e[3];
        for (int i = 0; i < 3; i++) {
            c[i] = ldexp(random_int(&random, 15) - 7, s);
            e[i] = c[i] + random_int(&random, 5) - 2;
        }
        body b = constant(1);
        times_quadric(&b, c, turn % 3 ? round_weights : (const double[3]){1, 2, 4}, 1);
        if (quartic) times_quadric(&b, s < 9 ? e : c, round_weights, 4);
        finish(&b);
        const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {c[0], c[1], c[2]}, {16, 0, 0}};
        for (int k = 0; k < 6; k++) {
            const algsurf_ray ray = ray_about(c, 1, 0.8, &random);
            check_ray(&b, &ray, k % 2 ? &extent : NULL, "far out", &judged);
        }
        drop(&b);
    }
    /* two balls, all of whose coefficients are whole numbers below 2^53 */
    body b = constant(1);
    const double c[3] = {2867, -835, 7787}, e[3] = {2868, -834, 7787};
    times_quadric(&b, c, round_weights, 1), times_quadric(&b, e, round_weights, 1);
    finish(&b);
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {c[0], c[1], c[2]}, {10, 0, 0}};
    for (int k = 0; k < 100; k++) {
        const algsurf_ray ray = ray_about(c, 1, 0.8, &random);
        check_ray(&b, &ray, &extent, "two balls", &judged);
    }
    drop(&b);
    if (judged.hits < 1000 || judged.sharp < judged.hits * 3 / 4)
        fail_msg("%d hits, %d sharp", judged.hits, judged.sharp);
}

/* (x + 2.1 y + z + 1)^k, coefficients rounded. */
static body power_of_plane(int k) {
    body b = constant(0);
    mpz_t a, choose;
    mpz_inits(a, choose, NULL);
    b.count = 0, b.degree = k;
    for (int i = 0; i <= k; i++)
        for (int j = 0; i + j <= k; j++)
            for (int l = 0; i + j + l <= k; l++) {
                mpz_bin_uiui(a, (unsigned long)k, (unsigned long)i);
                mpz_bin_uiui(choose, (unsigned long)(k - i), (unsigned long)j), mpz_mul(a, a, choose);
                mpz_bin_uiui(choose, (unsigned long)(k - i - j), (unsigned long)l), mpz_mul(a, a, choose);
                b.term[b.count++] = (algsurf_term){i, j, l, mpz_get_d(a) * pow(2.1, j)};
            }
    mpz_clears(a, choose, NULL);
    finish(&b);
    return b;
}

TEST(powers) {
    uint64_t random = seed + 1;
    tally judged = {0};
    static const int exponents[] = {5, 9, 13, 16, 21};
    const double place[3] = {-0.3, -0.4, 0.1};
    for (int turn = 0; turn < 5; turn++) {
        body b = power_of_plane(exponents[turn]);
        for (int k = 0; k < 4; k++) {
            const algsurf_ray ray = ray_about(place, 0.5, 0.5, &random);
            check_ray(&b, &ray, NULL, "powers", &judged);
        }
        drop(&b);
    }
    if (judged.hits < 20) fail_msg("%d hits", judged.hits);
}

/* Cones passed at distances from 1 to 10^-9, and through their tips, where the normal is one seen beside. */
TEST(near_tips) {
    uint64_t random = seed + 2;
    tally judged = {0};
    int seen = 0;
    for (int turn = 0; turn < 300; turn++) {
        double c[3];
        for (int i = 0; i < 3; i++) c[i] = (random_int(&random, 129) - 64) * 0.125;
        body b = constant(1);
        times_quadric(&b, c, cone_weights, 0);
        finish(&b);
        algsurf_ray ray = ray_about(c, 1, ldexp(1, -turn % 32), &random);
        check_ray(&b, &ray, NULL, "near a tip", &judged);
        for (int i = 0; i < 3; i++) ray.direction[i] = random_int(&random, 9) - 4;
        for (int i = 0; i < 3; i++) ray.origin[i] = c[i] - 3 * ray.direction[i];
        const double *d = ray.direction;
        long double square = 0, before[3], normal[3];
        for (int i = 0; i < 3; i++) before[i] = -cone_weights[i] * d[i], square += before[i] * before[i];
        if (square > 0 && d[0] * d[0] + d[1] * d[1] != d[2] * d[2]) {
            algsurf_hit hit = first_hit_of(b.surface, NULL, &ray, NULL);
            assert_int_equal(hit.multiplicity, 2);
            for (int i = 0; i < 3; i++) normal[i] = hit.normal[i];
            double off = degrees_between(normal, before);
            if (!(off < 0.1)) fail_msg("seed %llu, turn %d: %g degrees", (unsigned long long)seed, turn, off);
            seen++;
        }
        drop(&b);
    }
    if (judged.hits < 300 || seen < 200) fail_msg("%d hits, %d tips", judged.hits, seen);
}

/* Surfaces of all sizes. */
TEST(scaled) {
    uint64_t random = seed + 3;
    tally judged = {0};
    for (int turn = 0; turn < 60; turn++) {
        const int scale = random_int(&random, 665) - 332;
        const int far = turn % 3 == 0 ? 20 : 2;
        double c[3], unit = ldexp(1, scale), place[3];
        for (int i = 0; i < 3; i++) c[i] = ldexp(random_int(&random, 15) - 7, far), place[i] = c[i] * unit;
        body b = constant(1);
        times_quadric(&b, c, round_weights, 1);
        for (int t = 0; t < b.count; t++)
            b.term[t].a = ldexp(b.term[t].a, scale * (2 - b.term[t].i - b.term[t].j - b.term[t].k));
        finish(&b);
        for (int k = 0; k < 6; k++) {
            const algsurf_ray ray = ray_about(place, unit, 0.5, &random);
            check_ray(&b, &ray, NULL, "scaled", &judged);
        }
        drop(&b);
    }
    if (judged.hits < 500 || judged.sharp < judged.hits * 3 / 4)
        fail_msg("%d hits, %d sharp", judged.hits, judged.sharp);
}

/* Pictures of balls, 1 to 10^7 radii from the origin, whose pixels are rays where rounding counts. */
TEST(pictures) {
    enum { SIDE = 24 };
    static float normals[3 * SIDE * SIDE];
    static double t[SIDE * SIDE];
    for (int s = 0; s < 24; s++) {
        const double c[3] = {ldexp(1, s), ldexp(3, s - 1), -ldexp(1, s - 1)}, up[3] = {0, 1, 0};
        const double eye[3] = {c[0] + 4, c[1] + 2, c[2] + 5};
        body b = constant(1);
        times_quadric(&b, c, round_weights, 1);
        if (s < 13) times_quadric(&b, c, round_weights, 4);
        finish(&b);
        const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {c[0], c[1], c[2]}, {3, 0, 0}};
        const algsurf_render_options options = {
            .size = sizeof options, .width = SIDE, .height = SIDE, .row_end = SIDE};
        const algsurf_picture picture = {.size = sizeof picture, .t = t, .normals = normals};
        algsurf_camera camera = pinhole_of(eye, c, up, 0.5);
        algsurf_scene *scene = scene_of(b.surface, NULL, NULL, NULL);
        assert_ok(algsurf_scene_set_extent(scene, &extent));
        assert_ok(algsurf_scene_set_camera(scene, &camera));
        assert_ok(algsurf_render(scene, &options, &picture, NULL));
        int seen = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            long double radial[3], normal[3], dot = 0;
            if (!isfinite(t[i])) continue;
            algsurf_ray ray = pixel_ray(&camera, SIDE, SIDE, i % SIDE + 0.5, i / SIDE + 0.5);
            for (int k = 0; k < 3; k++) {
                normal[k] = normals[3 * i + k];
                radial[k] = ((long double)ray.origin[k] - c[k]) + (long double)t[i] * ray.direction[k];
                dot += radial[k] * normal[k];
            }
            for (int k = 0; k < 3 && dot < 0; k++) radial[k] = -radial[k];
            double off = degrees_between(normal, radial);
            if (!(off < 0.01)) fail_msg("2^%d from the origin, pixel %d: off by %g degrees", s, i, off);
            seen++;
        }
        assert_true(seen > 50);
        drop(&b);
    }
}
