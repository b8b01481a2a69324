/* test_camera.c - frames and rays of both cameras.
 *
 * Breaks tried, each caught by the test named:
 *   left-handed frame, y up instead of down, x and y scaled apart     corners, aspect
 *   fov taken as half the angle or as horizontal                      corners
 *   cross products in plain double                                    frames (nearly parallel up)
 *   look_at - eye with less than double precision                     frames
 *   up accepted when parallel but for rounding                        bad_cameras
 *   orthographic direction fanned out                                 orthographic
 */
#include <limits.h>

#include "algsurf/camera.h"
#include "exact.h"
#include "unit.h"

static const double origin[3] = {0, 0, 0}, z_up[3] = {0, 0, 1};

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static double det(const double a[3], const double b[3], const double c[3]) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

static void assert_near(double got, double expected, double allowed) {
    if (!(fabs(got - expected) <= allowed)) fail_msg("%.17g, not %.17g within %g", got, expected, allowed);
}

static algsurf_camera pinhole(const double eye[3], const double look_at[3], const double up[3], double fov) {
    algsurf_camera camera;
    assert_ok(algsurf_camera_pinhole(eye, look_at, up, fov, &camera));
    return camera;
}

static algsurf_ray ray_at(const algsurf_camera *camera, int width, int height, double x, double y) {
    algsurf_ray ray;
    assert_ok(algsurf_camera_ray(camera, width, height, x, y, &ray));
    assert_true(ray.t_min == 0 && ray.t_max == INFINITY);
    assert_near(dot(ray.direction, ray.direction), 1, 1e-15);
    return ray;
}

/* Orthonormal to rounding, right-handed, forward towards look_at, up on up's side; also far away, at
 * the ends of the range, and with up nearly along the view. */
TEST(frames) {
    uint64_t seed = 41;
    for (int k = 0; k < 2000; k++) {
        double eye[3], look_at[3], up[3], view[3], scale = ldexp(1, random_int(&seed, 1900) - 950);
        for (int i = 0; i < 3; i++) {
            look_at[i] = random_unit(&seed) * scale;
            eye[i] = random_unit(&seed) * scale * pow(10, k % 9);
            up[i] = random_unit(&seed);
            view[i] = (look_at[i] - eye[i]) / scale;
        }
        if (k % 3 == 0) /* the angle between up and view is about 1e-1 .. 1e-8 */
            for (int i = 0; i < 3; i++) up[i] = view[i] + up[i] * pow(10, k % 8 - 8) * sqrt(dot(view, view));
        algsurf_camera c;
        algsurf_status status = k % 2 ? algsurf_camera_pinhole(eye, look_at, up, 40, &c)
                                      : algsurf_camera_orthographic(eye, look_at, up, 2, &c);
        assert_ok(status);
        const double *axis[3] = {c.right, c.up, c.forward};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) assert_near(dot(axis[i], axis[j]), i == j, 1e-15);
        assert_near(det(c.right, c.up, c.forward), -1, 1e-15); /* right x up = -forward */
        assert_near(dot(c.forward, view) / sqrt(dot(view, view)), 1, 1e-15);
        assert_true(dot(c.up, up) > 0);
        assert_memory_equal(c.eye, eye, sizeof eye);
    }
}

TEST(centre_looks_at) {
    const double eye[3] = {4, 3, 2.5}, at[3] = {0.5, -0.25, 1};
    algsurf_camera c = pinhole(eye, at, z_up, 30);
    algsurf_ray r = ray_at(&c, 641, 481, 320.5, 240.5);
    double distance = sqrt(3.5 * 3.5 + 3.25 * 3.25 + 1.5 * 1.5);
    for (int i = 0; i < 3; i++) assert_near(r.origin[i] + distance * r.direction[i], at[i], 1e-14);
    assert_memory_equal(r.origin, eye, sizeof eye);
}

/* From (0,0,5) down to the origin with y up: right is x.  At fov 90 the picture reaches to +-5 high. */
TEST(corners) {
    const double eye[3] = {0, 0, 5}, up[3] = {0.3, 7, 1000};
    const double flat_up[3] = {0, 1, 0};
    algsurf_camera c = pinhole(eye, origin, flat_up, 90);
    for (int corner = 0; corner < 4; corner++) {
        double x = corner & 1 ? 200 : 0, y = corner & 2 ? 100 : 0;
        algsurf_ray r = ray_at(&c, 200, 100, x, y);
        double t = -5 / r.direction[2];
        assert_near(r.direction[0] * t, corner & 1 ? 10 : -10, 1e-14);
        assert_near(r.direction[1] * t, corner & 2 ? -5 : 5, 1e-14);
    }
    c = pinhole(eye, origin, up, 90); /* only up's part across the view counts */
    algsurf_ray r = ray_at(&c, 100, 100, 50, 0);
    assert_near(r.direction[0] / r.direction[1], 0.3 / 7, 1e-15);
}

/* Pixels are square, whatever the size of the picture; its height fixes the scale. */
TEST(aspect) {
    const int sizes[5][2] = {{100, 100}, {400, 100}, {30, 300}, {1, 1}, {65535, 7}};
    algsurf_camera c = pinhole((double[]){0, -8, 0}, origin, z_up, 50);
    for (int k = 0; k < 5; k++) {
        double w = sizes[k][0], h = sizes[k][1];
        algsurf_ray top = ray_at(&c, sizes[k][0], sizes[k][1], w / 2, 0);
        assert_near(top.direction[2] / top.direction[1], tan(25 * acos(-1) / 180), 1e-15);
        algsurf_ray side = ray_at(&c, sizes[k][0], sizes[k][1], w / 2 + h / 2, h / 2);
        assert_near(side.direction[0] / side.direction[1], tan(25 * acos(-1) / 180), 1e-15);
    }
}

/* Where the ray meets the plane through look_at across the view, in camera axes. */
static void plane_point(const algsurf_camera *c, const double at[3], double x, double y, double out[2]) {
    algsurf_ray r = ray_at(c, 320, 240, x, y);
    double q[3], side[3];
    for (int i = 0; i < 3; i++) q[i] = at[i] - r.origin[i];
    double t = dot(q, c->forward) / dot(r.direction, c->forward);
    for (int i = 0; i < 3; i++) side[i] = t * r.direction[i] - q[i];
    out[0] = dot(side, c->right), out[1] = dot(side, c->up);
}

/* From 10^6 away and with the field of view narrowed the picture is the one from nearby; the direction is
 * a double, so a point at distance D is known to about 2^-53 D. */
TEST(far_eye) {
    const double at[3] = {0.5, 0.25, -0.75}, towards[3] = {2.0 / 3, -1.0 / 3, 2.0 / 3};
    const double half_height = 1.25, pi = acos(-1);
    for (int power = 0; power <= 8; power++) {
        double distance = 4 * pow(10, power), eye[3], fov = 360 / pi * atan(half_height / distance);
        for (int i = 0; i < 3; i++) eye[i] = at[i] + distance * towards[i];
        algsurf_camera c = pinhole(eye, at, z_up, fov);
        double allowed = power <= 6 ? 1e-9 * half_height : 1e-7 * half_height;
        for (int k = 0; k < 9; k++) {
            double p[2], x = 160.0 * (k % 3), y = 120.0 * (k / 3);
            plane_point(&c, at, x, y, p);
            assert_near(p[0], (x - 160) / 120 * half_height, allowed);
            assert_near(p[1], (120 - y) / 120 * half_height, allowed);
        }
    }
    algsurf_camera c = pinhole((double[]){1e8, 0, 0}, origin, z_up, 1e-6);
    algsurf_ray r = ray_at(&c, 100, 100, 50, 0);
    assert_near(r.direction[2] / (pi / 180 * 0.5e-6), 1, 1e-14);
}

TEST(orthographic) {
    const double eye[3] = {0, 0, 5}, up[3] = {0, 1, 0}, down[3] = {0, 0, -1};
    algsurf_camera c;
    assert_ok(algsurf_camera_orthographic(eye, origin, up, 3, &c));
    for (int corner = 0; corner < 4; corner++) {
        algsurf_ray r = ray_at(&c, 200, 100, corner & 1 ? 200 : 0, corner & 2 ? 100 : 0);
        const double expected[3] = {corner & 1 ? 3 : -3, corner & 2 ? -1.5 : 1.5, 5};
        for (int i = 0; i < 3; i++) {
            assert_near(r.origin[i], expected[i], 1e-15);
            assert_near(r.direction[i], down[i], 0);
        }
    }
}

/* Calls both makers with one argument spoiled; the camera must stay as it was. */
static void refuse(const double eye[3], const double at[3], const double up[3], double aperture,
                   algsurf_status expected) {
    algsurf_camera c, before;
    memset(&c, 0x5a, sizeof c);
    memset(&before, 0x5a, sizeof before);
    assert_int_equal(algsurf_camera_pinhole(eye, at, up, aperture, &c), expected);
    assert_int_equal(algsurf_camera_orthographic(eye, at, up, aperture, &c), expected);
    assert_memory_equal(&c, &before, sizeof c);
}

TEST(bad_cameras) {
    const double eye[3] = {1, 2, 3}, at[3] = {4, 6, 8}, zero[3] = {0, -0.0, 0};
    const double along[3] = {-3e-200, -4e-200, -5e-200}, third[3] = {1.0 / 3, 4.0 / 9, 5.0 / 9};
    const double bad[2] = {NAN, INFINITY};
    refuse(NULL, at, z_up, 30, ALGSURF_E_ARGUMENT);
    refuse(eye, NULL, z_up, 30, ALGSURF_E_ARGUMENT);
    refuse(eye, at, NULL, 30, ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_camera_pinhole(eye, at, z_up, 30, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_camera_orthographic(eye, at, z_up, 30, NULL), ALGSURF_E_ARGUMENT);
    refuse(eye, eye, z_up, 30, ALGSURF_E_ARGUMENT);
    refuse(eye, at, zero, 30, ALGSURF_E_ARGUMENT);
    refuse(eye, at, along, 30, ALGSURF_E_ARGUMENT);
    refuse(eye, at, third, 30, ALGSURF_E_ARGUMENT); /* parallel but for rounding */
    refuse(eye, at, z_up, 0, ALGSURF_E_ARGUMENT);
    refuse(eye, at, z_up, -1, ALGSURF_E_ARGUMENT);
    refuse(eye, at, z_up, 0x1p-1074, ALGSURF_E_ARGUMENT); /* half of it is nothing */
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            double v[3] = {1, -2, 0.5};
            v[i] = bad[k];
            refuse(v, at, z_up, 30, ALGSURF_E_NOT_FINITE);
            refuse(eye, v, z_up, 30, ALGSURF_E_NOT_FINITE);
            refuse(eye, at, v, 30, ALGSURF_E_NOT_FINITE);
            refuse(eye, at, z_up, bad[k], ALGSURF_E_NOT_FINITE);
        }
    algsurf_camera c = {.half_height = 7};
    assert_int_equal(algsurf_camera_pinhole(eye, at, z_up, 180, &c), ALGSURF_E_ARGUMENT);
    assert_true(c.half_height == 7);
    assert_ok(algsurf_camera_pinhole(eye, at, z_up, nextafter(180, 0), &c));
    assert_ok(algsurf_camera_orthographic(eye, at, z_up, 1000, &c));
}

static void refuse_ray(const algsurf_camera *c, int width, int height, double x, double y,
                       algsurf_status expected) {
    algsurf_ray r, before;
    memset(&r, 0x5a, sizeof r);
    memset(&before, 0x5a, sizeof before);
    assert_int_equal(algsurf_camera_ray(c, width, height, x, y, &r), expected);
    assert_memory_equal(&r, &before, sizeof r);
}

static void refuse_kind(const algsurf_camera *good, int kind) {
    algsurf_camera c = *good;
    c.kind = kind;
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_ARGUMENT);
}

static void refuse_reserved(const algsurf_camera *good, int i, double x) {
    algsurf_camera c = *good;
    c.reserved[i] = x;
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_ARGUMENT);
}

/* Both makers set all members, whatever was there; -0 counts as 0. */
TEST(kinds) {
    const double eye[3] = {1, 2, 3};
    for (int parallel = 0; parallel < 2; parallel++) {
        algsurf_camera c;
        algsurf_ray ray, same;
        memset(&c, 0xff, sizeof c);
        assert_ok(
            (parallel ? algsurf_camera_orthographic : algsurf_camera_pinhole)(eye, origin, z_up, 3, &c));
        assert_int_equal(c.kind, parallel ? ALGSURF_CAMERA_ORTHOGRAPHIC : ALGSURF_CAMERA_PINHOLE);
        for (int i = 0; i < 8; i++) assert_true(c.reserved[i] == 0);
        assert_ok(algsurf_camera_ray(&c, 10, 10, 1, 2, &ray));
        for (int i = 0; i < 8; i++) c.reserved[i] = -0.0;
        assert_ok(algsurf_camera_ray(&c, 10, 10, 1, 2, &same));
        assert_memory_equal(&ray, &same, sizeof ray);
    }
}

TEST(bad_rays) {
    const algsurf_camera good = pinhole((double[]){1, 2, 3}, origin, z_up, 30);
    algsurf_camera c = good;
    refuse_ray(NULL, 10, 10, 0, 0, ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_camera_ray(&good, 10, 10, 0, 0, NULL), ALGSURF_E_ARGUMENT);
    refuse_ray(&good, 0, 10, 0, 0, ALGSURF_E_ARGUMENT);
    refuse_ray(&good, 10, -1, 0, 0, ALGSURF_E_ARGUMENT);
    refuse_ray(&good, 10, 10, NAN, 0, ALGSURF_E_NOT_FINITE);
    refuse_ray(&good, 10, 10, 0, INFINITY, ALGSURF_E_NOT_FINITE);
    c.up[1] = NAN;
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_NOT_FINITE);
    c = good, c.eye[2] = INFINITY;
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_NOT_FINITE);
    c = good, c.half_height = 0;
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_ARGUMENT);
    c = good, c.half_height = NAN;
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_NOT_FINITE);
    for (int kind = -3; kind < 6; kind++)
        if (kind != ALGSURF_CAMERA_PINHOLE && kind != ALGSURF_CAMERA_ORTHOGRAPHIC) refuse_kind(&good, kind);
    refuse_kind(&good, INT_MIN), refuse_kind(&good, INT_MAX);
    for (int i = 0; i < 8; i++) {
        refuse_reserved(&good, i, 1), refuse_reserved(&good, i, -0x1p-1074);
        refuse_reserved(&good, i, NAN), refuse_reserved(&good, i, -INFINITY);
    }
    c = good, c.forward[0] += 0.01;
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_ARGUMENT);
    c = good, memcpy(c.up, c.right, sizeof c.up);
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_ARGUMENT);
    c = (algsurf_camera){.half_height = 1};
    refuse_ray(&c, 10, 10, 0, 0, ALGSURF_E_ARGUMENT);
    c = good, c.kind = ALGSURF_CAMERA_ORTHOGRAPHIC, c.half_height = 1e308;
    refuse_ray(&c, 10000, 1, 0, 0, ALGSURF_E_NOT_FINITE); /* reaches beyond all doubles */
}
