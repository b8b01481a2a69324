/* test_mesh.c - triangles of surfaces whose topology and volume are known.
 *
 * Catches: an edge without its second triangle, triangles turned around, a hole or handle too many, vertices
 * off the surface, a volume that is not that of the surface, a cut that is not on the extent, a wall that
 * leaks, what a lattice cannot show and nobody tells, a mesh that depends on the threads. */
#include "mesh_make.h"
#include "mesh_measure.h"
#include "mesh_open.h"
#include "mesh_threads.h"
#include "mesh_write.h"
#include "scenes.h"

static const double PI = 3.14159265358979323846;

static algsurf_extent ball(double radius) {
    return (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {radius, 0, 0}};
}

static algsurf_extent box(double x, double y, double z) {
    return (algsurf_extent){ALGSURF_EXTENT_BOX, {0, 0, 0}, {x, y, z}};
}

static mesh make(const char *equation, algsurf_extent extent, const mesh_options *options) {
    algsurf_surface *surface = surface_of(equation);
    mesh m;
    assert_ok(mesh_make(surface, &extent, options, &m));
    return m;
}

static mesh_measures measure(const mesh *m) {
    mesh_measures of;
    assert_true(mesh_measure(m, &of));
    assert_int_equal(of.irregular, 0);
    return of;
}

static void near(double expected, double got, double relative) {
    if (!(fabs(got - expected) <= relative * fabs(expected)))
        fail_msg("%.9g, not %.9g: off by %.3g", got, expected, got / expected - 1);
}

/* A closed surface: Euler's number, pieces, and its volume; 0: not known. */
static void closed(const char *equation, algsurf_extent extent, int cells, long euler, long pieces,
                   double volume) {
    const mesh_options options = {.cells = cells};
    mesh m = make(equation, extent, &options);
    const mesh_measures of = measure(&m);
    assert_int_equal(of.open, 0);
    assert_int_equal(of.euler, euler);
    assert_int_equal(of.pieces, pieces);
    assert_true(of.volume > 0);
    if (volume > 0) near(volume, of.volume, 1e-4);
    mesh_free(&m);
}

TEST(test_spheres_and_tori) {
    closed("x^2 + y^2 + z^2 = 1", ball(1.2), 128, 2, 1, 4 * PI / 3);
    closed("(x^2+y^2+z^2 - 0.81 - 6.25)^2 = 25 (0.81 - z^2)", ball(3.6), 128, 0, 1, 2 * PI * PI * 2.5 * 0.81);
    closed("x^2 + y^2/4 + z^2/9 = 1", ball(3.9), 128, 2, 1, 8 * PI);
    closed("x^2 + y^2 + z^2 = 1", box(1.5, 1.01, 3), 16, 2, 1, 0);
    closed("x^2 + y^2 + z^2 = 1e-18", ball(1.2e-9), 32, 2, 1, 0);
    closed("x^2 + y^2 + z^2 = 1e18", ball(1.2e9), 32, 2, 1, 0);
    closed("(x-1)^2 + y^2 + z^2 = 1/4; ", ball(2), 32, 2, 1, 0);
}

TEST(test_more_handles) {
    closed("(x^2 (1 - x^2) - y^2)^2 + z^2 = 0.01", ball(1.5), 64, -2, 1, 0);
    closed("(y^2 - (4 - x^2) (x^2 - 1)^2)^2 + z^2 = 0.5", ball(3), 160, -4, 1, 0); /* three holes */
    /* Chmutov: 8 minima of T_4 + T_4 + T_4, 12 saddles of index 1, 6 of index 2 (Morse) */
    closed("T_4(x) + T_4(y) + T_4(z) = 0", ball(1.9), 48, 2 * (8 - 12), 1, 0);
    closed("T_4(x) + T_4(y) + T_4(z) = 2", ball(1.9), 48, 2 * (8 - 12 + 6), 2, 0);
    closed("T_4(x) + T_4(y) + T_4(z) = -2", ball(1.9), 48, 2 * 8, 8, 0);
}

TEST(test_extents) {
    static const algsurf_plane half = {{0, 0, 1}, 0.25}, other = {{1, 1, 0}, 0};
    const mesh_options solid = {.cells = 96, .solid = 1}, cut = {96, 1, 0, &half, 1, NULL, NULL, NULL, NULL};
    mesh m = make("x", box(1, 2, 3), &solid);
    mesh_measures of = measure(&m);
    assert_int_equal(of.open, 0);
    near(24, of.volume, 1e-9); /* corners and edges are exact */
    assert_int_equal(of.euler, 2);
    mesh_free(&m);
    m = make("x", ball(1), &solid);
    of = measure(&m);
    near(2 * PI / 3, of.volume, 1e-3);
    mesh_free(&m);
    m = make("x^2 + y^2 + z^2 = 1", ball(2), &cut);
    of = measure(&m);
    assert_int_equal(of.open, 0);
    near(4 * PI / 3 - PI * 0.75 * 0.75 * 2.25 / 3, of.volume, 1e-3);
    mesh_free(&m);
    const mesh_options open = {.cells = 64, .planes = &other, .plane_count = 1};
    m = make("x^2 + y^2 + z^2 = 1", ball(2), &open);
    of = measure(&m);
    assert_true(of.open > 100);
    assert_int_equal(of.euler, 1); /* a disc */
    near(2 * PI, of.area, 2e-3);
    mesh_free(&m);
}

TEST(test_boundary_on_the_extent) {
    const mesh_options options = {.cells = 48};
    mesh m = make("x^2 + y^2 - z^2 = 0.1", ball(1), &options);
    const mesh_measures of = measure(&m);
    assert_true(of.open > 100);
    assert_int_equal(of.euler, 0);
    int on_rim = 0;
    for (size_t i = 0; i < m.points; i++) {
        const double *x = m.at[i], r = hypot(hypot(x[0], x[1]), x[2]);
        assert_true(r < 1 + 0.05 * m.h);
        on_rim += fabs(r - 1) < 1e-9;
    }
    assert_true((size_t)on_rim > of.open / 2);
    mesh_free(&m);
}

TEST(test_vertices_on_the_surface) {
    const mesh_options options = {.cells = 40, .on_surface = 1};
    mesh m = make("x^2 + y^2 + z^2 = 1", ball(1.2), &options);
    double most = 0;
    for (size_t i = 0; i < m.points; i++) {
        const double *x = m.at[i], r = hypot(hypot(x[0], x[1]), x[2]);
        const double along =
            (x[0] * (double)m.normal[i][0] + x[1] * (double)m.normal[i][1] + x[2] * (double)m.normal[i][2]) /
            r;
        assert_true(along > 1 - 1e-6);
        most = fmax(most, fabs(r - 1));
    }
    assert_true(most < 1e-3 * m.h);
    mesh_free(&m);
    const mesh_options even = {.cells = 40};
    algsurf_surface *sphere = surface_of("x^2 + y^2 + z^2 = 1");
    mesh better = make("x^2 + y^2 + z^2 = 1", ball(1.2), &even);
    m = make("x^2 + y^2 + z^2 = 1", ball(1.2), &options);
    assert_true(mesh_deviation(&better, sphere) < 0.7 * mesh_deviation(&m, sphere));
    mesh_free(&m);
    mesh_free(&better);
}

TEST(test_walls) {
    const mesh_options options = {.cells = 64};
    mesh m = make("x^2 + y^2 - z^2 = 0.25", ball(1), &options);
    const double area = measure(&m).area;
    assert_true(mesh_open_thicken(&m, 0.02));
    mesh_measures of = measure(&m);
    assert_int_equal(of.open, 0);
    assert_int_equal(of.euler, 0);
    near(0.02 * area, of.volume, 0.01);
    mesh_free(&m);
    m = make("x^2 + y^2 + z^2 = 1", ball(1.2), &options); /* a closed one: two spheres */
    assert_true(mesh_open_thicken(&m, 0.02));
    of = measure(&m);
    assert_int_equal(of.open, 0);
    assert_int_equal(of.euler, 4);
    near(4 * PI / 3 * (1.01 * 1.01 * 1.01 - 0.99 * 0.99 * 0.99), of.volume, 1e-3);
    mesh_free(&m);
    m = make("x y z", ball(1), &options); /* sheets that cross: closed all the same */
    assert_true(mesh_open_thicken(&m, 0.02));
    assert_int_equal(measure(&m).open, 0);
    mesh_free(&m);
}

TEST(test_doubts) {
    const mesh_options options = {.cells = 32};
    mesh m = make("z^2 = 1e-6", box(1, 1, 1), &options);
    assert_true(m.doubts[MESH_CROWDED].count >= 900);
    assert_int_equal(m.triangles, 0);
    mesh_free(&m);
    m = make("(x^2 + y^2 + z^2 - 1)^2", ball(1.2), &options);
    assert_true(m.doubts[MESH_TOUCHED].count > 1000);
    assert_int_equal(m.triangles, 0);
    mesh_free(&m);
    m = make("x^2 + y^2 = z^2", ball(1), &options);
    assert_in_range(m.doubts[MESH_SHARP].count, 1, 16);
    assert_true(fabs(m.doubts[MESH_SHARP].at[2]) < 3 * m.h);
    mesh_free(&m);
    m = make("x^2 + y^2 + z^2 = 1", ball(1.2), &options);
    assert_int_equal(m.doubts[MESH_SHARP].count, 0);
    assert_int_equal(m.doubts[MESH_TOUCHED].count, 0);
    assert_int_equal(m.doubts[MESH_UNDECIDED].count, 0);
    mesh_free(&m);
}

TEST(test_undecided_is_told) {
    algsurf_surface *exact = surface_of("(x^2 + y^2 + z^2 - 1)^2");
    const algsurf_extent extent = ball(1.2);
    const mesh_options options = {.cells = 16};
    mesh m;
    const algsurf_surface *rough = surface_with_error(exact, 1e-9);
    assert_ok(mesh_make(rough, &extent, &options, &m));
    assert_true(m.doubts[MESH_UNDECIDED].count > 100);
    assert_int_equal(measure(&m).open, 0); /* whatever it is, it is closed */
    mesh_free(&m);
}

/* Planes and lines of the lattice in the surface, or as near as doubles are. */
TEST(test_degenerate) {
    static const char *const equations[] = {"x y z",
                                            "x^2 - y^2",
                                            "x (x^2 + y^2 + z^2 - 1)",
                                            "x^3 + y^3 + z^3",
                                            "(x^2 + y^2 + z^2)^2 = x^2 + y^2",
                                            "x y + y z + z x",
                                            "z^5 + x^2 y"};
    for (size_t i = 0; i < sizeof equations / sizeof *equations; i++)
        for (int cells = 4; cells <= 34; cells += 5) {
            const mesh_options solid = {.cells = cells, .solid = 1}, open = {.cells = cells};
            mesh m = make(equations[i], i % 2 ? ball(1) : box(1, 0.7, 1.1), &solid);
            assert_int_equal(measure(&m).open, 0);
            assert_true(measure(&m).volume > 0);
            mesh_free(&m);
            m = make(equations[i], ball(1), &open);
            (void)measure(&m);
            mesh_free(&m);
        }
    algsurf_surface *plane = surface_of("x + y + z"); /* in a lattice plane, exactly */
    algsurf_extent extent = box(1, 1, 1);
    const mesh_options options = {.cells = 10, .solid = 1};
    mesh_space space = {.surface = plane, .extent = extent};
    assert_ok(mesh_space_begin(&space, 10));
    algsurf_term terms[2] = {{1, 0, 0, 1}, {0, 0, 0, -space.point[0][5]}};
    const algsurf_surface *lattice_plane = surface_of_terms(terms, 2);
    mesh m;
    assert_ok(mesh_make(lattice_plane, &extent, &options, &m));
    const mesh_measures of = measure(&m);
    assert_int_equal(of.open, 0);
    near(4 * (1 + space.point[0][5]), of.volume, 1e-4); /* vertices keep off the faces of cells */
    mesh_free(&m);
    mesh_space_end(&space);
}

/* What is before, or after, a plane; inside, or outside, of two planes. */
static void check_layers(const mesh_space *space, int axis, double low, double high, int sign) {
    const mesh_options solid = {.cells = 12, .solid = 1};
    const double between = 4 * (high - low);
    char text[200];
    snprintf(text, sizeof text, "%d (%c - (%a))", sign, "xyz"[axis], low);
    mesh m = make(text, space->extent, &solid);
    near(4 * (1 + sign * low), measure(&m).volume, 2e-3);
    mesh_free(&m);
    snprintf(text, sizeof text, "%d (%c - (%a)) (%c - (%a))", sign, "xyz"[axis], low, "xyz"[axis], high);
    m = make(text, space->extent, &solid);
    if (high - low > 1.5 * space->h || m.doubts[MESH_CROWDED].count == 0)
        near(sign > 0 ? between : 8 - between, measure(&m).volume, 2e-3);
    mesh_free(&m);
}

/* Planes through points of the lattice: no layer of a cell or more is lost. */
TEST(test_layers) {
    mesh_space space = {.surface = surface_of("x"), .extent = box(1, 1, 1)};
    assert_ok(mesh_space_begin(&space, 12));
    for (int axis = 0; axis < 3; axis++)
        for (int i = 3; i < 9; i++)
            for (int j = i + 1; j < 10; j++)
                for (int sign = -1; sign < 2; sign += 2)
                    check_layers(&space, axis, space.point[axis][i], space.point[axis][j], sign);
    const mesh_options solid = {.cells = 12, .solid = 1};
    mesh m = make("(x - (0x1.e3779b97f6815p-4))(x - (-0x1.8722191a025fbp-2))", box(1, 1, 1),
                  &(mesh_options){.cells = 6, .solid = 1}); /* both are at points, exactly */
    near(2, measure(&m).volume, 1e-6);
    mesh_free(&m);
    for (int axis = 0; axis < 3; axis++) { /* a plane behind the last point, by less than doubles show */
        const double *p = &space.point[axis][12];
        int k = 3;
        while (*p > 1) p--;
        while (!(fma(k, *p, -(k * *p)) < 0 && k * *p / k == *p)) k++;
        algsurf_term terms[2] = {{0, 0, 0, -(k * *p)}, {axis == 0, axis == 1, axis == 2, k}};
        assert_ok(mesh_make(surface_of_terms(terms, 2), &space.extent, &solid, &m));
        near(4 * (1 + *p), measure(&m).volume, 2e-3);
        mesh_free(&m);
    }
    mesh_space_end(&space);
}

/* Extents farther and farther away: a mesh as near the origin, or none. */
TEST(test_range) {
    const mesh_options solid = {.cells = 32, .solid = 1};
    static const char *const equations[] = {"x", "y", "z"};
    mesh m;
    for (int axis = 0; axis < 3; axis++)
        for (int e = 0; e < 1024; e += e < 64 ? 1 : 96) {
            algsurf_extent extent = box(1, 1, 1);
            extent.centre[(axis + 1) % 3] = ldexp(1, e);
            const algsurf_status status = mesh_make(surface_of(equations[axis]), &extent, &solid, &m);
            assert_int_equal(status, e < 38 ? ALGSURF_OK : ALGSURF_E_RANGE);
            if (status == ALGSURF_OK) near(4, measure(&m).volume, 1e-9);
            mesh_free(&m);
        }
    for (int e = -1074; e<1024; e += e> - 110 && e < 110 ? 5 : 50) {
        const algsurf_extent extent = ball(ldexp(1, e));
        const algsurf_status status = mesh_make(surface_of("x"), &extent, &solid, &m);
        assert_int_equal(status, e > -100 && e < 100 ? ALGSURF_OK : ALGSURF_E_RANGE);
        if (status == ALGSURF_OK) near(2 * PI / 3, measure(&m).volume / ldexp(1, 3 * e), 0.01);
        mesh_free(&m);
    }
}

/* An equation and a plane times a power of two are the same. */
TEST(test_scales) {
    mesh first = {.points = 0};
    for (int e = -960; e <= 960; e += 120) {
        const double s = ldexp(1, e);
        const algsurf_term terms[4] = {{0, 0, 0, -s}, {2, 0, 0, s}, {0, 2, 0, s}, {0, 0, 2, s}};
        const algsurf_plane plane = {{s, s, -s}, s / 4};
        const algsurf_extent extent = ball(1.2);
        const mesh_options options = {.cells = 16, .solid = 1, .planes = &plane, .plane_count = 1};
        mesh m;
        assert_ok(mesh_make(surface_of_terms(terms, 4), &extent, &options, &m));
        if (first.points == 0) first = m;
        assert_int_equal(m.points, first.points);
        assert_memory_equal(m.at, first.at, m.points * sizeof *m.at);
        assert_memory_equal(m.normal, first.normal, m.points * sizeof *m.normal);
        if (m.at != first.at) mesh_free(&m);
    }
    mesh_free(&first);
}

static int stop(int done, int total, void *data) {
    assert_in_range(done, 0, total);
    return --*(int *)data == 0;
}

TEST(test_calls) {
    algsurf_surface *surface = surface_of("x^2 + y^2 + z^2 = 1");
    const algsurf_extent extent = ball(1.2), all = {.kind = ALGSURF_EXTENT_ALL};
    int left = 3, threads = 4;
    const mesh_options options = {.cells = 40, .progress = stop, .progress_data = &left},
                       small = {.cells = 3}, serial = {.cells = 40},
                       parallel = {.cells = 40, .run = mesh_threads_run, .run_data = &threads};
    mesh m, other;
    assert_int_equal(mesh_make(surface, &extent, &options, &m), ALGSURF_CANCELLED);
    mesh_free(&m);
    assert_int_equal(mesh_make(surface, &extent, &small, &m), ALGSURF_E_ARGUMENT);
    mesh_free(&m);
    assert_int_equal(mesh_make(surface, &all, &serial, &m), ALGSURF_E_ARGUMENT);
    mesh_free(&m);
    assert_ok(mesh_make(surface, &extent, &serial, &m));
    assert_ok(mesh_make(surface, &extent, &parallel, &other));
    assert_int_equal(m.points, other.points);
    assert_int_equal(m.triangles, other.triangles);
    assert_memory_equal(m.at, other.at, m.points * sizeof *m.at);
    assert_memory_equal(m.corner, other.corner, m.triangles * sizeof *m.corner);
    mesh_free(&m);
    mesh_free(&other);
}

static int count_bytes(const void *bytes, size_t count, void *data) {
    size_t *room = data;
    (void)bytes;
    if (*room < count) return 0;
    *room -= count;
    return 1;
}

typedef struct bytes {
    unsigned char at[1 << 17];
    size_t count;
} bytes;

static int keep(const void *more, size_t count, void *data) {
    bytes *to = data;
    if (count > sizeof to->at - to->count) return 0;
    memcpy(to->at + to->count, more, count);
    to->count += count;
    return 1;
}

/* Normals in .glb are of unit length, on both sides, also where there is none. */
TEST(test_no_normal) {
    static const double colour[3] = {1, 0.5, 0};
    static bytes file;
    const mesh_options options = {.cells = 16};
    mesh m = make("x", ball(1), &options);
    memset(m.normal[0], 0, sizeof *m.normal);
    assert_true(mesh_write(&m, MESH_GLB, colour, colour, keep, &file));
    const unsigned char *json = file.at + 12, *rest = json + 8 + (json[0] | json[1] << 8) + 8;
    for (int side = 0; side < 2; side++) {
        const unsigned char *z = rest + 12 * m.points * (size_t)(1 + side) + 8;
        assert_int_equal(z[3], side ? 0xbf : 0x3f); /* 1 or -1, as little-endian floats */
        assert_int_equal(z[2], 0x80);
    }
    mesh_free(&m);
}

TEST(test_sinks) {
    const double colour[3] = {1, 0.5, 0};
    const mesh_options options = {.cells = 20};
    mesh m = make("x^2 + y^2 + z^2 = 1", ball(1.2), &options);
    size_t room = 84 + 50 * m.triangles;
    assert_true(mesh_write(&m, MESH_STL, colour, colour, count_bytes, &room));
    assert_int_equal(room, 0);
    for (mesh_format format = MESH_STL; format <= MESH_GLB; format++) {
        room = 20000; /* full before the end */
        assert_false(mesh_write(&m, format, colour, colour, count_bytes, &room));
    }
    mesh_free(&m);
}
