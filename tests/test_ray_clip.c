/* test_ray_clip.c - algsurf_ray_clip against rational arithmetic: no point of the ray in the extent, on the
 * kept side of all planes, is off the chord, and the chord is hardly longer than it has to be.
 *
 * The exact part is an interval, bounded by planes and faces at rational t; where the line enters and leaves
 * a ball is told by the signs of |X - c|^2 - r^2 and of its slope.
 *
 * Breaks tried, each caught by the test named:
 *   extents of the largest sizes without a margin                                  nothing_is_lost
 *   no margin about the extent; planes at their rounded t                          nothing_is_lost
 *   2.5 times the margin; a hundred times the error of a plane: chords too long    nothing_is_lost
 *   directions not scaled                                                          nothing_is_lost
 *   a ray along a plane, and without an end, kept wherever it is                   along_a_plane
 *   the ray's own ends moved                                                       ends_are_kept
 *   the chord written although nothing is left                                     arguments
 */
#include "algsurf/ray.h"
#include "exact.h"
#include "unit.h"

enum { ROUNDS = 30000 };

typedef struct region_case {
    algsurf_extent extent;
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    size_t count;
    algsurf_ray ray;
} region_case;

/* ---- the exact part ---- */

/* The part of a line between t[0] and t[1], each bounded or not. */
typedef struct part {
    mpq_t t[2];
    int bounded[2], empty;
} part;

/* Keeps t with rise t <= room. */
static void keep_exactly(part *p, const mpq_t rise, const mpq_t room) {
    int end = mpq_sgn(rise) > 0;
    mpq_t t;
    if (mpq_sgn(rise) == 0) {
        p->empty |= mpq_sgn(room) < 0;
        return;
    }
    mpq_init(t);
    mpq_div(t, room, rise);
    if (!p->bounded[end] || (end ? mpq_cmp(t, p->t[1]) < 0 : mpq_cmp(t, p->t[0]) > 0)) mpq_set(p->t[end], t);
    p->bounded[end] = 1;
    mpq_clear(t);
}

/* rise = n.d, room = offset - n.o */
static void along_plane(mpq_t rise, mpq_t room, const algsurf_plane *plane, const algsurf_ray *ray) {
    mpq_t n, x;
    mpq_inits(n, x, NULL);
    mpq_set_ui(rise, 0, 1);
    exact_set(room, plane->offset);
    for (int i = 0; i < 3; i++) {
        exact_set(n, plane->normal[i]);
        exact_set(x, ray->direction[i]), mpq_mul(x, x, n), mpq_add(rise, rise, x);
        exact_set(x, ray->origin[i]), mpq_mul(x, x, n), mpq_sub(room, room, x);
    }
    mpq_clears(n, x, NULL);
}

/* The part of the ray that planes keep, in the extent if that is a box. */
static void part_of(part *p, const region_case *c) {
    const double ends[2] = {c->ray.t_min, c->ray.t_max};
    mpq_t rise, room, x;
    mpq_inits(p->t[0], p->t[1], rise, room, x, NULL);
    p->empty = 0;
    for (int k = 0; k < 2; k++) {
        p->bounded[k] = isfinite(ends[k]);
        if (p->bounded[k]) exact_set(p->t[k], ends[k]);
    }
    for (size_t i = 0; i < c->count; i++) {
        along_plane(rise, room, c->planes + i, &c->ray);
        keep_exactly(p, rise, room);
    }
    for (int i = 0; i < 6 && c->extent.kind == ALGSURF_EXTENT_BOX; i++) {
        algsurf_plane face = {{0}, 0};
        face.normal[i / 2] = i % 2 ? 1 : -1;
        along_plane(rise, room, &face, &c->ray);
        exact_set(x, c->extent.size[i / 2]), mpq_add(room, room, x);
        exact_set(x, face.normal[i / 2] * c->extent.centre[i / 2]), mpq_add(room, room, x);
        keep_exactly(p, rise, room);
    }
    p->empty |= p->bounded[0] && p->bounded[1] && mpq_cmp(p->t[0], p->t[1]) > 0;
    mpq_clears(rise, room, x, NULL);
}

/* The ball along the ray: q(t) = |X - c|^2 - r^2 = q[0] + q[1] t + q[2] t^2. */
static void ball_of(mpq_t q[3], const region_case *c) {
    mpq_t o, d, x;
    mpq_inits(o, d, x, NULL);
    exact_set(x, c->extent.size[0]), mpq_mul(x, x, x), mpq_neg(q[0], x);
    mpq_set_ui(q[1], 0, 1), mpq_set_ui(q[2], 0, 1);
    for (int i = 0; i < 3; i++) {
        exact_set(o, c->ray.origin[i]), exact_set(x, c->extent.centre[i]), mpq_sub(o, o, x);
        exact_set(d, c->ray.direction[i]);
        mpq_mul(x, o, o), mpq_add(q[0], q[0], x);
        mpq_mul(x, o, d), mpq_add(q[1], q[1], x), mpq_add(q[1], q[1], x);
        mpq_mul(x, d, d), mpq_add(q[2], q[2], x);
    }
    mpq_clears(o, d, x, NULL);
}

/* -1, 1: the whole ball is at smaller, at larger t; 0: neither, or the line misses it. */
static int ball_side(mpq_t q[3], const mpq_t t) {
    mpq_t value, slope;
    mpq_inits(value, slope, NULL);
    mpq_mul(slope, q[2], t), mpq_add(value, slope, q[1]), mpq_add(slope, slope, value);
    mpq_mul(value, value, t), mpq_add(value, value, q[0]);
    int side = mpq_sgn(value) > 0 ? mpq_sgn(slope) : 0;
    mpq_clears(value, slope, NULL);
    return -side;
}

static int line_misses_ball(mpq_t q[3]) {
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    mpq_mul(x, q[1], q[1]), mpq_mul(y, q[0], q[2]), mpq_mul_2exp(y, y, 2);
    int misses = mpq_cmp(x, y) < 0;
    mpq_clears(x, y, NULL);
    return misses;
}

/* Is the exact part empty? */
static int nothing_is_there(const part *p, mpq_t *q) {
    if (p->empty) return 1;
    if (!q) return 0;
    return line_misses_ball(q) || (p->bounded[0] && ball_side(q, p->t[0]) < 0) ||
           (p->bounded[1] && ball_side(q, p->t[1]) > 0);
}

/* Is no point of the exact part, which is not empty, before t (end 0) or behind it (end 1)?  Never is t where
 * the line meets a sphere. */
static int holds_end(const part *p, mpq_t *q, double t, int end) {
    mpq_t x;
    if (isinf(t)) return end ? t > 0 : t < 0;
    mpq_init(x);
    exact_set(x, t);
    int order = p->bounded[end] ? mpq_cmp(x, p->t[end]) : end ? -1 : 1;
    int side = q ? ball_side(q, x) : 0, holds = end ? order >= 0 || side < 0 : order <= 0 || side > 0;
    mpq_clear(x);
    return holds;
}

/* ---- how much longer the chord is ---- */

/* Is the point at t on the ray in the extent but for 2^-42 of the sizes? */
static int is_near_extent(const region_case *c, double t) {
    const algsurf_extent *e = &c->extent;
    mpq_t x, y, far, sum, room;
    int near = 1, box = e->kind == ALGSURF_EXTENT_BOX;
    mpq_inits(x, y, far, sum, room, NULL);
    for (int i = 0; i < 3; i++) { /* far: |o_i| + |c_i| + size; of a ball the largest */
        exact_set(x, fabs(c->ray.origin[i])), exact_set(y, fabs(e->centre[i])), mpq_add(x, x, y);
        exact_set(y, e->size[box ? i : 0]), mpq_add(x, x, y);
        if (box || mpq_cmp(x, far) > 0) mpq_set(far, x);
        mpq_div_2exp(room, far, 42), mpq_add(room, room, y);
        exact_set(x, t), exact_set(y, c->ray.direction[i]), mpq_mul(x, x, y);
        exact_set(y, c->ray.origin[i]), mpq_add(x, x, y);
        exact_set(y, e->centre[i]), mpq_sub(x, x, y);
        mpq_abs(x, x);
        if (box) near &= mpq_cmp(x, room) <= 0;
        mpq_mul(x, x, x), mpq_add(sum, sum, x);
    }
    mpq_mul(room, room, room);
    if (!box) near = mpq_cmp(sum, room) <= 0;
    mpq_clears(x, y, far, sum, room, NULL);
    return near;
}

/* Is the point at t kept by the plane but for 2^-46 of the sizes, those at `far` along the ray? */
static int is_near_plane(const algsurf_plane *plane, const algsurf_ray *ray, double t, double far) {
    mpq_t rise, room, x, y, size;
    mpq_inits(rise, room, x, y, size, NULL);
    along_plane(rise, room, plane, ray);
    exact_set(size, fabs(plane->offset));
    for (int i = 0; i < 3; i++) {
        exact_set(x, fabs(ray->direction[i])), exact_set(y, far), mpq_mul(x, x, y);
        exact_set(y, fabs(ray->origin[i])), mpq_add(x, x, y);
        exact_set(y, fabs(plane->normal[i])), mpq_mul(x, x, y), mpq_add(size, size, x);
    }
    mpq_div_2exp(size, size, 46);
    exact_set(x, t), mpq_mul(x, x, rise), mpq_sub(x, x, room);
    int near = mpq_cmp(x, size) <= 0;
    mpq_clears(rise, room, x, y, size, NULL);
    return near;
}

/* ---- cases ---- */

static void set_direction(double v[3], uint64_t *seed) {
    do {
        for (int i = 0; i < 3; i++) v[i] = random_int(seed, 3) ? random_halves(seed, 2) : 0;
    } while (v[0] == 0 && v[1] == 0 && v[2] == 0);
    if (random_int(seed, 2))
        for (int i = 0; i < 3; i++) v[i] += random_unit(seed);
}

/* Numbers that are short, so that rays touch, go along planes and through edges; or not, near or far. */
static void set_case(region_case *c, uint64_t *seed) {
    double far = random_int(seed, 3) ? 1 : pow(10, random_int(seed, 12));
    c->extent = (algsurf_extent){.kind = random_int(seed, 3)};
    for (int i = 0; i < 3; i++) {
        c->extent.centre[i] = random_halves(seed, 1);
        c->extent.size[i] = 0.5 + fabs(random_halves(seed, 2)) + (far > 1 ? fabs(random_unit(seed)) : 0);
        c->ray.origin[i] = random_halves(seed, 3);
    }
    set_direction(c->ray.direction, seed);
    for (int i = 0; i < 3 && far > 1; i++) c->ray.origin[i] -= far * c->ray.direction[i];
    c->ray.t_min = random_int(seed, 3) ? 0 : -INFINITY;
    c->ray.t_max = random_int(seed, 3) ? INFINITY : far + random_halves(seed, 3);
    c->count = (size_t)random_int(seed, random_int(seed, 4) ? 3 : ALGSURF_MAX_CLIP_PLANES + 1);
    for (size_t k = 0; k < c->count; k++) {
        int scale = random_int(seed, 8) ? 0 : random_int(seed, 600) - 300;
        set_direction(c->planes[k].normal, seed);
        for (int i = 0; i < 3; i++) c->planes[k].normal[i] = ldexp(c->planes[k].normal[i], scale);
        c->planes[k].offset = ldexp(random_halves(seed, 3), scale);
    }
}

/* The same, as large as doubles are: sizes that no margin can be added to. */
static void make_large(region_case *c, uint64_t *seed) {
    double most = random_int(seed, 2) ? DBL_MAX : DBL_MAX * (1 - 0x1p-43 * fabs(random_unit(seed)));
    for (int i = 0; i < 3; i++) {
        c->extent.centre[i] *= random_int(seed, 2) ? 0x1p1022 : 1;
        c->extent.size[i] = random_int(seed, 3) ? most : 0x1p1021 * c->extent.size[i];
        c->ray.origin[i] = random_int(seed, 2) ? c->ray.origin[i] : 0x1p1020 * random_unit(seed);
    }
    c->count = 0;
}

/* From so far away that doubles there are farther apart than the extent is long; the line goes through 0. */
static void make_far(region_case *c, uint64_t *seed) {
    int e = 20 + random_int(seed, 60);
    for (int i = 0; i < 3; i++) c->ray.origin[i] = -ldexp(c->ray.direction[i], e);
}

/* Past the centre of the ball at 1 - 2^-k or 1 + 2^-k radii. */
static void make_grazing(region_case *c, uint64_t *seed) {
    algsurf_extent *e = &c->extent;
    double side[3], along = 0, norm = 0, square = 0, gap = ldexp(1, -1 - random_int(seed, 50));
    if (random_int(seed, 3) == 0) gap = -gap;
    e->kind = ALGSURF_EXTENT_SPHERE;
    for (int i = 0; i < 3; i++) {
        side[i] = random_unit(seed);
        along += side[i] * c->ray.direction[i], norm += c->ray.direction[i] * c->ray.direction[i];
    }
    for (int i = 0; i < 3; i++) side[i] -= along / norm * c->ray.direction[i], square += side[i] * side[i];
    double back = pow(10, random_int(seed, 4));
    for (int i = 0; i < 3; i++)
        c->ray.origin[i] =
            e->centre[i] + e->size[0] * (1 - gap) / sqrt(square) * side[i] - back * c->ray.direction[i];
    c->ray.t_min = -INFINITY, c->ray.t_max = INFINITY;
}

/* In other units of length, and of t. */
static void make_scaled(region_case *c, uint64_t *seed) {
    int length = random_int(seed, 500) - 250, speed = random_int(seed, 1200) - 600;
    for (int i = 0; i < 3; i++) {
        c->extent.centre[i] = ldexp(c->extent.centre[i], length);
        c->extent.size[i] = ldexp(c->extent.size[i], length);
        c->ray.origin[i] = ldexp(c->ray.origin[i], length);
        c->ray.direction[i] = ldexp(c->ray.direction[i], speed);
    }
    for (size_t k = 0; k < c->count; k++) c->planes[k].offset = ldexp(c->planes[k].offset, length);
    c->ray.t_min = ldexp(c->ray.t_min, length - speed), c->ray.t_max = ldexp(c->ray.t_max, length - speed);
}

static void print_case(const algsurf_extent *e, const algsurf_ray *r, const double *got) {
    fprintf(stderr, "kind %d\n", (int)e->kind);
    exact_print_doubles("centre", e->centre, 3);
    exact_print_doubles("size", e->size, 3);
    exact_print_doubles("origin", r->origin, 3);
    exact_print_doubles("direction", r->direction, 3);
    exact_print_doubles("ends", got, 2);
}

static void fail_case(const region_case *c, int round, const algsurf_ray *chord, const char *why) {
    const double ends[2] = {chord->t_min, chord->t_max}, given[2] = {c->ray.t_min, c->ray.t_max};
    print_case(&c->extent, &c->ray, ends);
    exact_print_doubles("of", given, 2);
    for (size_t k = 0; k < c->count; k++) {
        exact_print_doubles("normal", c->planes[k].normal, 3);
        exact_print_doubles("offset", &c->planes[k].offset, 1);
    }
    fail_msg("round %d: %s", round, why);
}

static int clip(const region_case *c, size_t count, algsurf_ray *chord) {
    int meets = -1;
    assert_ok(algsurf_ray_clip(&c->ray, &c->extent, c->planes, count, chord, &meets));
    return meets;
}

/* Why a chord is wrong, or null. */
static const char *verdict(const region_case *c, const part *p, mpq_t *q, int meets,
                           const algsurf_ray *chord) {
    const double ends[2] = {chord->t_min, chord->t_max};
    algsurf_ray whole = *chord;
    int empty = nothing_is_there(p, q);
    if (!meets) return empty ? NULL : "there is something";
    for (int end = 0; end < 2; end++) {
        if (!empty && !holds_end(p, q, ends[end], end)) return end ? "behind the chord" : "before the chord";
        if (!(fabs(ends[end]) < DBL_MAX)) continue; /* no double is nearer */
        if (c->extent.kind != ALGSURF_EXTENT_ALL && !is_near_extent(c, ends[end])) return "far outside";
    }
    (void)clip(c, 0, &whole);
    double far = fmax(fabs(whole.t_min), fabs(whole.t_max));
    for (size_t k = 0; k < c->count && isfinite(far); k++)
        for (int end = 0; end < 2; end++)
            if (!is_near_plane(c->planes + k, &c->ray, ends[end], far)) return "far beyond a plane";
    return NULL;
}

TEST(nothing_is_lost) {
    uint64_t seed = 20261124;
    int met = 0, missed = 0, tight = 0;
    mpq_t q[3];
    mpq_inits(q[0], q[1], q[2], NULL);
    for (int round = 0; round < ROUNDS; round++) {
        region_case c;
        algsurf_ray chord;
        part p;
        set_case(&c, &seed);
        if (round % 8 == 0) make_large(&c, &seed);
        if (round % 8 == 1) make_far(&c, &seed);
        if (round % 8 < 4 && round % 8 > 1) make_grazing(&c, &seed);
        if (round % 8 == 3 || round % 8 == 4) make_scaled(&c, &seed);
        int ball = c.extent.kind == ALGSURF_EXTENT_SPHERE;
        if (ball) ball_of(q, &c);
        part_of(&p, &c);
        chord = c.ray;
        int meets = clip(&c, c.count, &chord);
        const char *wrong = verdict(&c, &p, ball ? q : NULL, meets, &chord);
        if (wrong) fail_case(&c, round, &chord, wrong);
        met += meets, missed += !meets;
        tight += meets && c.count > 0 && (chord.t_min > c.ray.t_min || chord.t_max < c.ray.t_max);
        mpq_clears(p.t[0], p.t[1], NULL);
    }
    mpq_clears(q[0], q[1], q[2], NULL);
    printf("%d met, %d of them cut by planes or extent, %d missed\n", met, tight, missed);
    assert_true(met > ROUNDS / 4 && missed > ROUNDS / 4 && tight > ROUNDS / 8);
}

/* A ray without an end along a plane is on one side of it. */
TEST(along_a_plane) {
    const algsurf_ray ray = {{1, 2, 3}, {0, 0.1, 0}, -INFINITY, INFINITY};
    const algsurf_plane kept = {{3, 0, -1}, 0.5}, lost = {{3, 0, -1}, -0.5}, in = {{3, 0, -1}, 0};
    algsurf_ray chord;
    int meets;
    assert_ok(algsurf_ray_clip(&ray, NULL, &kept, 1, &chord, &meets));
    assert_int_equal(meets, 1);
    assert_true(chord.t_min == -INFINITY && chord.t_max == INFINITY);
    assert_ok(algsurf_ray_clip(&ray, NULL, &lost, 1, &chord, &meets));
    assert_int_equal(meets, 0);
    assert_ok(algsurf_ray_clip(&ray, NULL, &in, 1, &chord, &meets));
    assert_int_equal(meets, 1);
}

/* Touching is meeting: along a face, an edge, at a corner, at an end of the ray. */
TEST(borders_belong) {
    static const algsurf_extent box = {ALGSURF_EXTENT_BOX, {1, 2, 3}, {0.5, 0.25, 0.125}},
                                ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    static const struct {
        const algsurf_extent *extent;
        algsurf_ray ray;
        double lo, hi;
    } touching[] = {{&box, {{1.5, 2, 3}, {1, 0, 0}, 0, INFINITY}, 0, 0},
                    {&box, {{1.5, 2, 3}, {-2, 0, 0}, 0, INFINITY}, 0, 0.5},
                    {&box, {{1.5, 2, 0}, {-0.0, 0.0, 1}, 0, INFINITY}, 2.875, 3.125},
                    {&box, {{1.5, 2.25, 0}, {0, 0, -1}, -INFINITY, INFINITY}, -3.125, -2.875},
                    {&box, {{0, 1, 2}, {0.5, 1.25, 1.125}, 0, INFINITY}, 1, 1},
                    {&ball, {{-4, 0, 0}, {1, 0, 0}, 0, 3}, 3, 3},
                    {&ball, {{-4, 0, 0}, {1, 0, 0}, 5, INFINITY}, 5, 5},
                    {&ball, {{-4, 1, 0}, {1, 0, 0}, 0, INFINITY}, 4, 4},
                    {&ball, {{1e300, 0, 0}, {-1, 0, 0}, 0, INFINITY}, 1e300, 1e300}};
    for (size_t i = 0; i < sizeof touching / sizeof *touching; i++) {
        algsurf_ray chord;
        int meets = 0;
        assert_ok(algsurf_ray_clip(&touching[i].ray, touching[i].extent, NULL, 0, &chord, &meets));
        assert_int_equal(meets, 1);
        assert_true(chord.t_min <= touching[i].lo && touching[i].hi <= chord.t_max);
    }
}

/* Bit for bit, where they are the tighter ones; without points there is no chord. */
TEST(ends_are_kept) {
    static const algsurf_extent extents[] = {{ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}},
                                             {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}},
                                             {ALGSURF_EXTENT_ALL, {NAN, 0, 0}, {0, 0, 0}}};
    static const algsurf_plane plane = {{1, 0, 0}, 2};
    for (int k = 0; k < 4; k++) {
        const algsurf_extent *e = k < 3 ? extents + k : NULL;
        algsurf_ray chord, r = {{-4, 0, 0}, {1, 0, 0}, 3 + 1.0 / 3, 4 + 1.0 / 3};
        int meets = 0;
        assert_ok(algsurf_ray_clip(&r, e, &plane, 1, &chord, &meets));
        assert_int_equal(meets, 1);
        assert_memory_equal(&chord, &r, sizeof r);
        r.t_min = 4.5, r.t_max = 4;
        assert_ok(algsurf_ray_clip(&r, e, &plane, 1, &chord, &meets));
        assert_int_equal(meets, 0);
        r.t_min = 5.001, r.t_max = INFINITY;
        assert_ok(algsurf_ray_clip(&r, e, NULL, 0, &chord, &meets));
        assert_int_equal(meets, k > 1);
    }
}

static void refuse(const algsurf_extent *e, const algsurf_ray *r, const algsurf_plane *planes, size_t count,
                   algsurf_status expected) {
    algsurf_ray chord, before;
    int meets = 77;
    memset(&chord, 0x5a, sizeof chord);
    memset(&before, 0x5a, sizeof before);
    assert_int_equal(algsurf_ray_clip(r, e, planes, count, &chord, &meets), expected);
    assert_int_equal(meets, 77);
    assert_memory_equal(&chord, &before, sizeof chord);
}

TEST(bad_numbers) {
    static const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}};
    static const algsurf_ray ray = {{-4, 0, 0}, {1, 0, 0}, 0, 10};
    static const algsurf_plane plane = {{1, 0, 0}, 0.5};
    const double bad[3] = {NAN, INFINITY, -INFINITY};
    algsurf_extent e = box;
    algsurf_ray r = ray;
    algsurf_plane p = plane;
    for (int k = 0; k < 9; k++) {
        int i = k % 3;
        r = ray, r.origin[i] = bad[k / 3], refuse(&box, &r, NULL, 0, ALGSURF_E_NOT_FINITE);
        r = ray, r.direction[i] = bad[k / 3], refuse(&box, &r, NULL, 0, ALGSURF_E_NOT_FINITE);
        e = box, e.centre[i] = bad[k / 3], refuse(&e, &ray, NULL, 0, ALGSURF_E_NOT_FINITE);
        e = box, e.size[i] = bad[k / 3], refuse(&e, &ray, NULL, 0, ALGSURF_E_NOT_FINITE);
        p = plane, p.normal[i] = bad[k / 3], refuse(&box, &ray, &p, 1, ALGSURF_E_NOT_FINITE);
        p = plane, p.offset = bad[k / 3], refuse(&box, &ray, &p, 1, ALGSURF_E_NOT_FINITE);
        e = box, e.size[i] = k < 3 ? 0 : -1, refuse(&e, &ray, NULL, 0, ALGSURF_E_ARGUMENT);
    }
    r = ray, r.t_min = NAN, refuse(&box, &r, NULL, 0, ALGSURF_E_NOT_FINITE);
    r = ray, r.t_max = NAN, refuse(&box, &r, NULL, 0, ALGSURF_E_NOT_FINITE);
    r = ray, r.direction[0] = -0.0, refuse(&box, &r, NULL, 0, ALGSURF_E_ARGUMENT);
    e = box, e.kind = 3, refuse(&e, &ray, NULL, 0, ALGSURF_E_ARGUMENT);
    e = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {0, 1, 1}};
    refuse(&e, &ray, NULL, 0, ALGSURF_E_ARGUMENT);
    p = plane, p.normal[0] = 0, refuse(&box, &ray, &p, 1, ALGSURF_E_ARGUMENT);
    refuse(&box, NULL, NULL, 0, ALGSURF_E_ARGUMENT);
    refuse(&box, &ray, NULL, 1, ALGSURF_E_ARGUMENT);
    refuse(&box, &ray, &plane, ALGSURF_MAX_CLIP_PLANES + 1, ALGSURF_E_ARGUMENT);
}

TEST(arguments) {
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    const algsurf_ray ray = {{-2, 0, 0}, {1, 0, 0}, 0, 9};
    const algsurf_plane plane = {{1, 0, 0}, 0.5}, far = {{1, 0, 0}, -2};
    algsurf_ray same = ray, before = ray;
    int meets = -1;
    assert_int_equal(algsurf_ray_clip(&ray, &ball, &plane, 1, &same, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_ray_clip(&ray, &ball, &plane, 1, NULL, &meets), ALGSURF_E_ARGUMENT);
    assert_int_equal(meets, -1);
    assert_ok(algsurf_ray_clip(&same, &ball, &far, 1, &same, &meets));
    assert_int_equal(meets, 0);
    assert_memory_equal(&same, &before, sizeof same);
    assert_ok(algsurf_ray_clip(&same, &ball, &plane, 1, &same, &meets));
    assert_int_equal(meets, 1);
    assert_true(same.t_min <= 1 && same.t_min > 1 - 1e-11 && same.t_max >= 2.5 && same.t_max < 2.5 + 1e-13);
    assert_memory_equal(same.origin, before.origin, sizeof same.origin + sizeof same.direction);
}
