/* test_chords.c - the ends of a row's chords are off by less than their blur, over rationals.
 *
 * Two attacks on lib/beams/sight_template.h.  Lines: u, v and the slopes anywhere within the bounds of
 * forms, extents and planes about them; the line is exact, so that only the chord's own rounding is judged.
 * Pictures: cameras, extents and planes as a caller sets them; the chord judged is that of the ray that
 * algsurf_camera_ray gives, so that the view's noise is part of it.  Both look for what is hard: rays that
 * all but touch the sphere, go past an edge or a corner of a box, go along its faces or along a plane, wide
 * and tiny angles of view, far eyes, flat boxes, planes that touch the sphere, a centre far from the origin.
 *     A chord is open, undecided or empty.  Of an open one both ends are compared, and the largest of error /
 * blur is printed: above 1 the test fails.  An empty one may have no point of the exact ray.  The middle of
 * an undecided one tells nothing, but not all may be undecided.
 *
 * Breaks tried, each caught by the tests named:
 *   e = 2^-56 + 4 noise: lines.  In pictures there is always some noise, which takes roundings in
 *   e without noise; a sixty-fourth of the noise; a plane's own error left out: pictures
 *   blur not divided by the sine, on a sphere, in a box, at a plane: both
 *   nothing undecided about the edge of a sphere, along a face, along a plane: both
 *   a chord surely empty from inside < edge on: both
 *   no edge at all; ends that are told apart however close they are: lines
 *   rays clear of what is shown with CLEAR = 0.9: pictures
 * Not caught: PARALLEL = 2^-52.  Blur grows instead, and hardly a line with much noise is so parallel.
 *
 *     test_chords [lines [pictures [seed]]]
 */
#include "picture/impl.h"
#include "base/vec.h"
#include "simd/baseline.h"
#include "beams/sight_template.h"
#include "scenes.h"

ARGUMENT(1, long, line_count, 20000)
ARGUMENT(2, long, picture_count, 1500)
ARGUMENT(3, uint64_t, first_seed, 20261125)
static long clear_count; /* rays that need no chord */

static double power_between(uint64_t *seed, double lo, double hi) {
    return exp2(random_between(seed, lo, hi));
}

/* 0, or of either sign and some size between powers of two. */
static double little(uint64_t *seed, double lo, double hi) {
    return (random_int(seed, 3) - 1) * power_between(seed, lo, hi);
}

static void random_unit3(uint64_t *seed, double d[3]) {
    do
        for (int i = 0; i < 3; i++) d[i] = random_int(seed, 4) ? random_unit(seed) : 0;
    while (!algsurf_unit(d, d));
}

/* A unit vector across d. */
static void random_across(uint64_t *seed, const double d[3], double across[3]) {
    double any[3];
    do {
        random_unit3(seed, any);
        algsurf_cross(d, any, across);
    } while (!algsurf_unit(across, across));
}

/* ---- exact chords: o + t d about the extent's centre, lo <= t <= hi ---- */

typedef struct exact_line {
    mpq_t o[3], d[3], lo, hi;
    int empty;
} exact_line;

static void init_line(exact_line *l) {
    for (int i = 0; i < 3; i++) mpq_inits(l->o[i], l->d[i], NULL);
    mpq_inits(l->lo, l->hi, NULL);
    l->empty = 0;
}

static void clear_line(exact_line *l) {
    for (int i = 0; i < 3; i++) mpq_clears(l->o[i], l->d[i], NULL);
    mpq_clears(l->lo, l->hi, NULL);
}

static void exact_dot(mpq_t sum, mpq_t a[3], mpq_t b[3]) {
    mpq_t w;
    mpq_init(w);
    mpq_set_ui(sum, 0, 1);
    for (int i = 0; i < 3; i++) mpq_mul(w, a[i], b[i]), mpq_add(sum, sum, w);
    mpq_clear(w);
}

static void cut_lo(exact_line *l, const mpq_t t) {
    if (mpq_cmp(t, l->lo) > 0) mpq_set(l->lo, t);
    l->empty |= mpq_cmp(l->lo, l->hi) > 0;
}

static void cut_hi(exact_line *l, const mpq_t t) {
    if (mpq_cmp(t, l->hi) < 0) mpq_set(l->hi, t);
    l->empty |= mpq_cmp(l->lo, l->hi) > 0;
}

/* The root of a square, but for 2^-200 of it. */
static void exact_root(mpq_t r, const mpq_t square) {
    long bits = (long)mpz_sizeinbase(mpq_numref(square), 2) - (long)mpz_sizeinbase(mpq_denref(square), 2);
    long shift = bits < 400 ? (401 - bits) / 2 : 0;
    mpz_t n;
    mpz_init(n);
    mpz_mul_2exp(n, mpq_numref(square), 2 * (mp_bitcnt_t)shift);
    mpz_fdiv_q(n, n, mpq_denref(square));
    mpz_sqrt(n, n);
    mpq_set_z(r, n);
    mpq_div_2exp(r, r, (mp_bitcnt_t)shift);
    mpz_clear(n);
}

/* The ball |X| <= r. */
static void cut_to_ball(exact_line *l, const mpq_t r) {
    mpq_t a, b, c, w;
    mpq_inits(a, b, c, w, NULL);
    exact_dot(a, l->d, l->d), exact_dot(b, l->o, l->d), exact_dot(c, l->o, l->o);
    mpq_mul(w, r, r), mpq_sub(c, c, w);
    mpq_mul(w, b, b), mpq_mul(c, c, a), mpq_sub(w, w, c);
    if (mpq_sgn(w) < 0) {
        l->empty = 1;
    } else {
        exact_root(w, w);
        mpq_neg(b, b);
        mpq_sub(c, b, w), mpq_div(c, c, a), cut_lo(l, c);
        mpq_add(c, b, w), mpq_div(c, c, a), cut_hi(l, c);
    }
    mpq_clears(a, b, c, w, NULL);
}

/* above + t rise <= 0. */
static void cut_to_side(exact_line *l, const mpq_t above, const mpq_t rise) {
    mpq_t t;
    mpq_init(t);
    if (mpq_sgn(rise) == 0) {
        l->empty |= mpq_sgn(above) > 0;
    } else {
        mpq_div(t, above, rise), mpq_neg(t, t);
        if (mpq_sgn(rise) > 0)
            cut_hi(l, t);
        else
            cut_lo(l, t);
    }
    mpq_clear(t);
}

/* |coordinate k| <= h. */
static void cut_to_slab(exact_line *l, int k, const mpq_t h) {
    mpq_t above, rise;
    mpq_inits(above, rise, NULL);
    mpq_sub(above, l->o[k], h), cut_to_side(l, above, l->d[k]);
    mpq_add(above, l->o[k], h), mpq_neg(above, above), mpq_neg(rise, l->d[k]), cut_to_side(l, above, rise);
    mpq_clears(above, rise, NULL);
}

/* normal.X <= offset. */
static void cut_to_plane(exact_line *l, const double normal[3], const mpq_t offset) {
    mpq_t n[3], above, rise;
    mpq_inits(n[0], n[1], n[2], above, rise, NULL);
    for (int i = 0; i < 3; i++) exact_set(n[i], normal[i]);
    exact_dot(above, n, l->o), mpq_sub(above, above, offset);
    exact_dot(rise, n, l->d);
    cut_to_side(l, above, rise);
    mpq_clears(n[0], n[1], n[2], above, rise, NULL);
}

/* ---- what was computed against it ---- */

enum { LOST, GHOST, OFF, OPEN, UNDECIDED, EMPTY, KINDS };
static const char *const kind_names[KINDS] = {"lost", "ghosts", "off", "open", "undecided", "empty"};

static struct {
    long count[KINDS];
    double worst[2]; /* of a sphere, of a box */
    double cut;      /* of either, with planes */
} seen;

static double error_of(double depth, const mpq_t exact, double blur) {
    mpq_t e;
    mpq_init(e);
    exact_set(e, depth), mpq_sub(e, e, exact);
    double error = fabs(mpq_get_d(e)) / blur;
    mpq_clear(e);
    return error;
}

/* Lane 0; lo, hi of the exact chord are depths.  Returns what it is. */
static int judge(const chord *c, mask open, const exact_line *exact, int box, int planes, double *error) {
    int is_open = bits(open) & 1, undecided = bits(c->undecided) & 1, kind;
    *error = 0;
    if (is_open && exact->empty) {
        kind = GHOST;
    } else if (is_open) {
        *error =
            fmax(error_of(c->near[0], exact->lo, c->blur[0]), error_of(c->far[0], exact->hi, c->blur[0]));
        seen.worst[box] = fmax(seen.worst[box], *error);
        if (planes) seen.cut = fmax(seen.cut, *error);
        kind = *error <= 1 ? OPEN : OFF;
    } else if (undecided) {
        kind = UNDECIDED;
    } else {
        kind = exact->empty ? EMPTY : LOST;
    }
    seen.count[kind]++;
    return kind;
}

static void report(const char *what) {
    print_message("%s:", what);
    for (int i = 0; i < KINDS; i++) print_message(" %s %ld,", kind_names[i], seen.count[i]);
    print_message(" error / blur: sphere %.3f, box %.3f, with planes %.3f\n", seen.worst[0], seen.worst[1],
                  seen.cut);
    assert_true(seen.count[LOST] + seen.count[GHOST] + seen.count[OFF] == 0);
    assert_true(seen.count[OPEN] > seen.count[UNDECIDED] && seen.count[EMPTY] > seen.count[OPEN] / 20);
}

/* ---- lines ---- */

/* A view without noise, and a line of sight. */
typedef struct test_line {
    algsurf_i_view view;
    algsurf_extent extent;
    algsurf_i_cut_plane planes[2];
    algsurf_i_row_form form;
    algsurf_i_row_job job;
    double u, v, a, b;
} test_line;

static void random_axes(uint64_t *seed, double axis[3][3]) {
    random_unit3(seed, axis[2]);
    random_across(seed, axis[2], axis[0]);
    algsurf_cross(axis[2], axis[0], axis[1]);
    (void)algsurf_unit(axis[1], axis[1]);
}

/* Through (x,y,z), within the bounds of forms; the slopes of either sign, large, small or 0. */
static void aim_line(test_line *l, uint64_t *seed, const double at[3]) {
    do {
        l->a = random_int(seed, 3) ? random_between(seed, -4, 4) : little(seed, -30, 0);
        l->b = random_int(seed, 3) ? random_between(seed, -4, 4) : little(seed, -30, 0);
        l->u = at[0] - l->a * at[2], l->v = at[1] - l->b * at[2];
    } while (!(fabs(l->u) + fabs(l->a) < 4 && fabs(l->v) + fabs(l->b) < 4));
}

/* Beside a point where it touches the ball of radius r. */
static void touch_ball(test_line *l, uint64_t *seed, double r) {
    const double middle[3] = {0, 0, 0};
    do {
        double at[3], direction[3];
        aim_line(l, seed, middle);
        const double along[3] = {l->a, l->b, 1}, off = r * (1 + little(seed, -52, -2));
        (void)algsurf_unit(along, direction);
        random_across(seed, direction, at);
        l->u = off * (at[0] - l->a * at[2]), l->v = off * (at[1] - l->b * at[2]);
    } while (!(fabs(l->u) + fabs(l->a) < 4 && fabs(l->v) + fabs(l->b) < 4));
}

/* Coordinates about the view's axes, of a point given about the box's. */
static void in_view(const test_line *l, const double point[3], double at[3]) {
    for (int i = 0; i < 3; i++) at[i] = algsurf_dot(l->view.axis[i], point);
}

/* Past a corner or an edge, or all but along a face. */
static void pass_box(test_line *l, uint64_t *seed) {
    double point[3], at[3], *h = l->job.extent_size;
    for (int i = 0; i < 3; i++) {
        double side = random_int(seed, 2) ? 1 : -1;
        point[i] =
            random_int(seed, 3) ? side * h[i] + little(seed, -52, -8) : random_between(seed, -h[i], h[i]);
    }
    in_view(l, point, at);
    aim_line(l, seed, at);
    if (random_int(seed, 2)) return;
    double along[3], across[3], direction[3], n[3] = {0, 0, 0};
    n[random_int(seed, 3)] = 1;
    random_across(seed, n, across);
    for (int i = 0; i < 3; i++) across[i] += n[i] * little(seed, -30, -10);
    in_view(l, across, along);
    for (int i = 0; i < 3; i++) direction[i] = along[i] / along[2];
    double u = at[0] - direction[0] * at[2], v = at[1] - direction[1] * at[2];
    if (!(fabs(u) + fabs(direction[0]) < 4 && fabs(v) + fabs(direction[1]) < 4)) return;
    l->u = u, l->v = v, l->a = direction[0], l->b = direction[1];
}

/* Through about the chord: any, all but along the line, or one that touches the ball. */
static void random_plane(test_line *l, uint64_t *seed, algsurf_i_cut_plane *p) {
    double z = random_between(seed, -1, 1), direction[3];
    const double at[3] = {l->u + z * l->a, l->v + z * l->b, z}, along[3] = {l->a, l->b, 1};
    (void)algsurf_unit(along, direction);
    random_unit3(seed, p->normal);
    if (random_int(seed, 3) == 0) {
        random_across(seed, direction, p->normal);
        for (int i = 0; i < 3; i++) p->normal[i] += direction[i] * little(seed, -30, -10);
        (void)algsurf_unit(p->normal, p->normal);
    }
    p->offset = algsurf_dot(p->normal, at) + (random_int(seed, 2) ? little(seed, -50, -10) : 0);
    if (random_int(seed, 6) == 0) p->offset = random_between(seed, -11, 4);
    p->error = 0;
}

static void random_line(test_line *l, uint64_t *seed) {
    memset(l, 0, sizeof *l);
    int box = random_int(seed, 2), tangent = random_int(seed, 2);
    double at[3] = {random_between(seed, -0.6, 0.6), random_between(seed, -0.6, 0.6),
                    random_between(seed, -0.6, 0.6)};
    random_axes(seed, l->view.axis);
    l->extent.kind = box ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE;
    l->job =
        (algsurf_i_row_job){.view = &l->view, .row = &l->form, .extent = &l->extent, .planes = l->planes};
    for (int i = 0; i < 3; i++)
        l->job.extent_size[i] = !box                  ? 1 / (1 + 0x1p-20)
                                : random_int(seed, 4) ? random_between(seed, 0.1, 0.57)
                                                      : power_between(seed, -45, -1.5);
    aim_line(l, seed, at);
    if (tangent && box) pass_box(l, seed);
    if (tangent && !box) touch_ball(l, seed, l->job.extent_size[0]);
    l->job.plane_count = random_int(seed, 3);
    for (int i = 0; i < l->job.plane_count; i++) random_plane(l, seed, l->planes + i);
}

/* The line's exact chord; t is the depth. */
static void chord_of_line(const test_line *l, exact_line *x) {
    const double foot[3] = {l->u, l->v, 0}, along[3] = {l->a, l->b, 1};
    mpq_t w, h;
    mpq_inits(w, h, NULL);
    mpq_set_si(x->lo, -8, 1), mpq_set_ui(x->hi, 8, 1);
    exact_set(h, l->job.extent_size[0]);
    for (int i = 0; i < 3; i++) exact_set(x->o[i], foot[i]), exact_set(x->d[i], along[i]);
    if (l->extent.kind == ALGSURF_EXTENT_SPHERE) cut_to_ball(x, h);
    for (int i = 0; i < l->job.plane_count; i++)
        exact_set(h, l->planes[i].offset), cut_to_plane(x, l->planes[i].normal, h);
    if (l->extent.kind == ALGSURF_EXTENT_BOX) {
        for (int k = 0; k < 3; k++) {
            mpq_set_ui(x->o[k], 0, 1), mpq_set_ui(x->d[k], 0, 1);
            for (int i = 0; i < 3; i++) {
                exact_set(w, l->view.axis[i][k]), exact_set(h, foot[i]), mpq_mul(h, h, w);
                mpq_add(x->o[k], x->o[k], h);
                exact_set(h, along[i]), mpq_mul(h, h, w), mpq_add(x->d[k], x->d[k], h);
            }
            exact_set(h, l->job.extent_size[k]);
            cut_to_slab(x, k, h);
        }
    }
    mpq_clears(w, h, NULL);
}

TEST(lines_within_rounding) {
    uint64_t seed = first_seed;
    int shown = 0;
    memset(&seen, 0, sizeof seen);
    for (long i = 0; i < line_count; i++) {
        test_line l;
        exact_line x;
        mask open;
        double error;
        random_line(&l, &seed);
        init_line(&x);
        chord_of_line(&l, &x);
        const sight s = {all_lanes(l.u), all_lanes(l.a), all_lanes(l.v), all_lanes(l.b)};
        const chord c = clip(&l.job, &s, all_lanes(-8), &open);
        int kind = judge(&c, open, &x, l.extent.kind == ALGSURF_EXTENT_BOX, l.job.plane_count, &error);
        if (kind <= OFF && shown++ < 5)
            print_message(
                "line %ld %s: kind %d, %d planes, u %a v %a a %a b %a, near %a far %a blur %a, %g\n", i,
                kind_names[kind], (int)l.extent.kind, l.job.plane_count, l.u, l.v, l.a, l.b, c.near[0],
                c.far[0], c.blur[0], error);
        clear_line(&x);
    }
    report("lines");
}

/* ---- pictures ---- */

enum { COLUMNS = 24, ROWS = 3 };

typedef struct test_view {
    long number;
    algsurf_camera camera;
    algsurf_extent extent;
    algsurf_plane planes[2];
    int plane_count;
} test_view;

/* What the camera looks at: a place inside, where it touches the sphere, a box's edge; and from where. */
static void random_aim(const test_view *v, uint64_t *seed, double eye[3], double aim[3]) {
    const double *h = v->extent.size;
    int box = v->extent.kind == ALGSURF_EXTENT_BOX, face = random_int(seed, 3);
    double radius = box ? algsurf_length(h) : h[0], away[3], across[3];
    double far = random_int(seed, 3) ? random_between(seed, 1.01, 6) : power_between(seed, -2, 26);
    int hard = random_int(seed, 4);
    random_unit3(seed, away);
    random_across(seed, away, across);
    double slant = far > 1 ? 1 / far : 0, off = 1 + little(seed, -50, -10);
    for (int i = 0; i < 3; i++) {
        eye[i] = far * radius * away[i];
        aim[i] = 0.5 * h[box ? i : 0] * random_unit(seed);
        if (hard == 1 && !box)
            aim[i] = off * radius * (slant * away[i] + sqrt(1 - slant * slant) * across[i]);
        if (hard == 1 && box && random_int(seed, 3)) aim[i] = copysign(h[i], random_unit(seed)) * off;
    }
    if (hard != 2 || !box) return;
    aim[face] = copysign(h[face], random_unit(seed)) * off; /* along a face */
    eye[face] = aim[face] + far * radius * little(seed, -30, -12);
}

/* Across the camera's direction, all but along it, or touching the sphere. */
static void random_cut(const test_view *v, uint64_t *seed, const double aim[3], algsurf_plane *p) {
    double length = power_between(seed, -40, 40), at[3];
    random_unit3(seed, p->normal);
    if (random_int(seed, 3) == 0) {
        random_across(seed, v->camera.forward, p->normal);
        for (int i = 0; i < 3; i++) p->normal[i] += v->camera.forward[i] * little(seed, -30, -10);
    }
    for (int i = 0; i < 3; i++) at[i] = v->extent.centre[i] + aim[i];
    if (random_int(seed, 4) == 0)
        for (int i = 0; i < 3; i++) at[i] = v->extent.centre[i] + v->extent.size[0] * p->normal[i];
    for (int i = 0; i < 3; i++) p->normal[i] *= length;
    p->offset = algsurf_dot(p->normal, at) * (1 + little(seed, -52, -20));
}

static void random_view(test_view *v, uint64_t *seed) {
    static const double sizes[] = {1, 1, 3, 1e-20, 1e20};
    double radius = sizes[random_int(seed, 5)], eye[3], aim[3], look[3], up[3];
    double fov = random_int(seed, 2) ? random_between(seed, 1, 170) : pow(10, -random_between(seed, 0, 9));
    int box = random_int(seed, 2), parallel = random_int(seed, 4) == 0;
    double far = random_int(seed, 3) ? 0 : radius * power_between(seed, 0, 26);
    v->extent.kind = box ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE;
    for (int i = 0; i < 3; i++) {
        v->extent.centre[i] = far * random_unit(seed);
        v->extent.size[i] = box || i == 0 ? radius : 0;
        if (box)
            v->extent.size[i] *=
                random_int(seed, 4) ? random_between(seed, 0.2, 1) : power_between(seed, -40, 0);
    }
    random_aim(v, seed, eye, aim);
    for (int i = 0; i < 3; i++) eye[i] += v->extent.centre[i], look[i] = aim[i] + v->extent.centre[i];
    do random_unit3(seed, up);
    while ((parallel ? algsurf_camera_orthographic(eye, look, up, radius * fov / 40, &v->camera)
                     : algsurf_camera_pinhole(eye, look, up, fov, &v->camera)) != ALGSURF_OK);
    v->plane_count = random_int(seed, 3);
    for (int i = 0; i < v->plane_count; i++) random_cut(v, seed, aim, v->planes + i);
}

/* Depth z = z0 + t z1 of o + t d, by Cramer's rule: the axes are not quite orthonormal. */
static void depth_line(const algsurf_i_view *view, int unit, exact_line *x, mpq_t z0, mpq_t z1) {
    mpq_t axis[3][3], n[3], w, det;
    mpq_inits(w, det, NULL);
    for (int k = 0; k < 3; k++) {
        mpq_init(n[k]);
        for (int i = 0; i < 3; i++) mpq_init(axis[k][i]), exact_set(axis[k][i], view->axis[k][i]);
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpq_mul(n[i], axis[0][j], axis[1][k]), mpq_mul(w, axis[0][k], axis[1][j]), mpq_sub(n[i], n[i], w);
    }
    exact_dot(det, n, axis[2]);
    exact_set(w, view->size), mpq_mul(det, det, w);
    if (unit >= 0)
        mpq_mul_2exp(det, det, (mp_bitcnt_t)unit);
    else
        mpq_div_2exp(det, det, (mp_bitcnt_t)-unit);
    exact_dot(z0, n, x->o), mpq_div(z0, z0, det);
    exact_dot(z1, n, x->d), mpq_div(z1, z1, det);
    for (int k = 0; k < 3; k++) {
        mpq_clear(n[k]);
        for (int i = 0; i < 3; i++) mpq_clear(axis[k][i]);
    }
    mpq_clears(w, det, NULL);
}

/* The exact chord of a ray of the caller's; its ends as depths. */
static void chord_of_ray(const test_view *v, const algsurf_i_view *view, int unit, const algsurf_ray *ray,
                         exact_line *x) {
    mpq_t w, c, n, z0, z1;
    mpq_inits(w, c, n, z0, z1, NULL);
    for (int i = 0; i < 3; i++) {
        exact_set(x->o[i], ray->origin[i]), exact_set(w, v->extent.centre[i]), mpq_sub(x->o[i], x->o[i], w);
        exact_set(x->d[i], ray->direction[i]);
    }
    exact_set(x->hi, 0x1p200);
    for (int i = 0; i < 3; i++) {
        exact_set(w, v->extent.size[i]);
        if (v->extent.kind == ALGSURF_EXTENT_BOX) cut_to_slab(x, i, w);
        if (v->extent.kind == ALGSURF_EXTENT_SPHERE && i == 0) cut_to_ball(x, w);
    }
    for (int k = 0; k < v->plane_count; k++) {
        exact_set(c, v->planes[k].offset);
        for (int i = 0; i < 3; i++) {
            exact_set(w, v->extent.centre[i]), exact_set(n, v->planes[k].normal[i]);
            mpq_mul(w, w, n), mpq_sub(c, c, w);
        }
        cut_to_plane(x, v->planes[k].normal, c);
    }
    depth_line(view, unit, x, z0, z1);
    mpq_mul(x->lo, x->lo, z1), mpq_add(x->lo, x->lo, z0);
    mpq_mul(x->hi, x->hi, z1), mpq_add(x->hi, x->hi, z0);
    mpq_clears(w, c, n, z0, z1, NULL);
}

/* The ray through a pixel's middle: its exact chord, in depths, and what is computed of it. */
static void check_pixel(const test_view *v, const algsurf_i_picture *picture, const algsurf_i_row_job *job,
                        int i, int y) {
    static int shown;
    exact_line x;
    mask open;
    double error;
    init_line(&x);
    algsurf_ray ray = pixel_ray(&v->camera, COLUMNS, ROWS, i + 0.5, y + 0.5);
    chord_of_ray(v, job->view, picture->scene->surface->unit, &ray, &x);
    const sight s = sight_at(job, all_lanes(i));
    const chord c = clip(job, &s, all_lanes(job->near), &open);
    int kind = judge(&c, open, &x, v->extent.kind == ALGSURF_EXTENT_BOX, v->plane_count, &error);
    if (kind <= OFF && shown++ < 5)
        print_message("seed %llu, view %ld, pixel %d %d %s: %g of blur %a, noise %a\n",
                      (unsigned long long)first_seed, v->number, i, y, kind_names[kind], error, c.blur[0],
                      job->view->noise);
    clear_line(&x);
}

/* A ray that is said to miss since it stays clear of the view's ball; whichever place in the pixel it has. */
static void check_clear(const test_view *v, const algsurf_i_picture *picture, uint64_t *seed, int i, int y) {
    double sx = random_int(seed, 2) ? 0 : 1, sy = random_int(seed, 2) ? 0 : 1;
    algsurf_ray ray, part;
    int meets;
    assert_ok(algsurf_camera_ray(&v->camera, COLUMNS, ROWS, i + sx, y + sy, &ray));
    /* all that lies within the rounding of a chord counts as inside: so a miss is one, and a hit is decided
     */
    assert_ok(algsurf_ray_clip(&ray, &v->extent, NULL, 0, &part, &meets));
    if (meets) {
        exact_line x;
        init_line(&x);
        chord_of_ray(v, picture->geometry->rays.view, picture->scene->surface->unit, &ray, &x);
        meets = !x.empty;
        clear_line(&x);
    }
    if (meets)
        print_message("seed %llu, view %ld: pixel %d %d is not clear\n", (unsigned long long)first_seed,
                      v->number, i, y);
    assert_false(meets);
    clear_count++;
}

static void check_row(const test_view *v, const algsurf_i_picture *picture, uint64_t *seed, int y) {
    algsurf_i_row_form form;
    algsurf_i_row_job job;
    int begin, end, clear = algsurf_i_pixels_within_bounds(picture, y, y + 1, 1, &begin, &end);
    algsurf_i_make_row(picture, y + 0.5, 0.5, 1, &form, &job);
    for (int i = begin; i < end; i++) check_pixel(v, picture, &job, i, y);
    for (int i = 0; clear && i < COLUMNS; i++)
        if (i < begin || i >= end) check_clear(v, picture, seed, i, y);
}

static int check_view(const test_view *v, uint64_t *seed) {
    const algsurf_term terms[2] = {{2, 0, 0, 1}, {0, 0, 0, -v->extent.size[0] * v->extent.size[0]}};
    static algsurf_i_geometry geometry;
    algsurf_surface *surface = surface_of_terms(terms, 2);
    algsurf_scene *scene = scene_of(surface, NULL, NULL, NULL);
    assert_ok(algsurf_scene_set_extent(scene, &v->extent));
    assert_ok(algsurf_scene_set_camera(scene, &v->camera));
    assert_ok(algsurf_scene_set_clip(scene, v->planes, (size_t)v->plane_count));
    memset(&geometry, 0, sizeof geometry);
    algsurf_i_picture picture = {.scene = scene, .width = COLUMNS, .height = ROWS, .geometry = &geometry};
    algsurf_i_scene_lighting(scene, picture.lights, &picture.lighting);
    int suits = algsurf_i_find_geometry(&picture, &geometry);
    for (int y = 0; suits && y < ROWS; y++) check_row(v, &picture, seed, y);
    return suits;
}

TEST(pictures_within_blur) {
    uint64_t seed = first_seed;
    long suited = 0;
    memset(&seen, 0, sizeof seen);
    for (long i = 0; i < picture_count; i++) {
        test_view v = {.number = i};
        random_view(&v, &seed);
        suited += check_view(&v, &seed);
    }
    print_message("%ld of %ld pictures are for geometry\n", suited, picture_count);
    report("pictures");
    print_message("%ld pixels are clear of what is shown\n", clear_count);
    assert_true(2 * suited > picture_count);
    assert_true(clear_count > picture_count);
}
