/* test_kernel_points.c - points of the surface from the depths of a row's hits, by every kernel.
 *
 * Breaks tried, each caught by the test named:
 *   a wrong stride, its factor 2x left out, an empty row or level             random_surfaces
 *   the scheme begun one coefficient late                                     random_surfaces
 *   u, v exchanged; slope without alpha or beta; the eye's depth or the
 *   unit left out of t; no step, or one the wrong way                         catalogue_hits
 *   a step longer than 2^-16, or NaN, taken                                   steps
 *   squares that underflow or overflow; NaN instead of a zero normal          scales, singular_points
 *   entries behind the last one written; lanes that depend on neighbours      same_bits
 */
#include "catalogue.h"
#include "scenes.h"
#include "beams/kernels.h"
#include "base/vec.h"

enum { WIDTH = 64, HEIGHT = 48, SPARE = 8, OUTPUTS = 10 };
static const uint64_t seed = 20240611;
static const char *const kernel_names[3] = {"baseline", "avx2", "avx512"};

/* What a kernel writes: t, position, normal, direction; and whether the root was found. */
typedef struct batch {
    double at[OUTPUTS][WIDTH + SPARE];
    uint8_t sure[WIDTH + SPARE];
} batch;

/* A row of a picture of a surface. */
typedef struct stage {
    algsurf_surface *surface;
    algsurf_camera camera;
    algsurf_i_view view;
    algsurf_i_row_form row;
    algsurf_i_row_job job;
} stage;

/* The view of a camera, of a ball about a point. */
static void set_view(stage *s, const double centre[3], double radius) {
    const algsurf_camera *camera = &s->camera;
    const double *axis[3] = {camera->right, camera->up, camera->forward};
    double eye[3], unit = ldexp(1, -s->surface->unit), side[3];
    for (int i = 0; i < 3; i++) eye[i] = (camera->eye[i] - centre[i]) * unit;
    s->view = (algsurf_i_view){.size = radius * unit};
    for (int k = 0; k < 3; k++) {
        s->view.centre[k] = centre[k] * unit;
        memcpy(s->view.axis[k], axis[k], sizeof s->view.axis[k]);
        side[k] = algsurf_dot(eye, axis[k]) / s->view.size;
    }
    double distance = camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC ? 0 : -side[2];
    s->view.alpha = camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC ? 0 : 1 / distance;
    s->view.beta[0] = camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC ? 0 : -side[0] / distance;
    s->view.beta[1] = camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC ? 0 : -side[1] / distance;
    s->job = (algsurf_i_row_job){.view = &s->view,
                                 .row = &s->row,
                                 .offset = 0.5 - 0.5 * WIDTH,
                                 .pixel = camera->half_height / (0.5 * HEIGHT),
                                 .u0 = side[0],
                                 .du = camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC ? unit / s->view.size
                                                                                   : distance,
                                 .near = side[2]};
}

static void set_row(stage *s, int y) {
    double eye[3], above;
    for (int i = 0; i < 3; i++) eye[i] = ldexp(s->camera.eye[i], -s->surface->unit) - s->view.centre[i];
    above = algsurf_dot(eye, s->camera.up) / s->view.size;
    s->row.v = above + s->job.du * (0.5 * HEIGHT - (y + 0.5)) * s->job.pixel;
    s->job.slope = s->view.alpha * s->row.v + s->view.beta[1];
}

/* Looks past the centre of a ball from a random place outside. */
static void random_view(stage *s, const double centre[3], double radius, int orthographic, uint64_t *state) {
    double eye[3], aim[3], up[3], distance = radius * (2 + 6 * fabs(random_unit(state)));
    do {
        for (int i = 0; i < 3; i++) up[i] = random_unit(state), eye[i] = random_unit(state);
    } while (!algsurf_unit(eye, eye) || fabs(algsurf_dot(eye, up)) > 0.9 * algsurf_length(up));
    for (int i = 0; i < 3; i++) {
        eye[i] = centre[i] + distance * eye[i];
        aim[i] = centre[i] + 0.2 * radius * random_unit(state);
    }
    algsurf_status status =
        orthographic ? algsurf_camera_orthographic(eye, aim, up, 2.2 * radius, &s->camera)
                     : algsurf_camera_pinhole(eye, aim, up, 40 + 30 * random_unit(state), &s->camera);
    assert_ok(status);
    set_view(s, centre, radius);
}

static void run(const algsurf_i_kernel *kernel, const stage *s, const int *pixel, const double *depth,
                int count, batch *out) {
    algsurf_i_points points = {out->at[0],
                               {out->at[1], out->at[2], out->at[3]},
                               {out->at[4], out->at[5], out->at[6]},
                               {out->at[7], out->at[8], out->at[9]},
                               {{NULL}, {NULL}, {NULL}}};
    const algsurf_i_point_job job = {s->surface, &s->job, NULL, 0};
    algsurf_i_beams_kernel_for(kernel)->points(&job, pixel, depth, count, NULL, out->sure, &points);
}

static void get(const batch *b, int entry, int first, double v[3]) {
    for (int i = 0; i < 3; i++) v[i] = b->at[first + i][entry];
}

/* The largest difference of a component from what it should be. */
static double off(const double got[3], const double expected[3]) {
    double largest = 0;
    for (int i = 0; i < 3; i++)
        largest = !(fabs(got[i] - expected[i]) <= largest) ? fabs(got[i] - expected[i]) : largest;
    return largest;
}

/* How much the unit gradient turns about x, or so, where x moves by `way`; differences over a millionth of
 * `far`. */
static double turn_of(const algsurf_surface *s, const double x[3], double far, double way) {
    double value, g[3], there[3], bound, bounds[3], bend = 0;
    assert_ok(algsurf_surface_gradient(s, x, &value, g, &bound, bounds));
    for (int i = 0; i < 3; i++) {
        double y[3] = {x[0], x[1], x[2]};
        y[i] += 0x1p-20 * far;
        assert_ok(algsurf_surface_gradient(s, y, &value, there, &bound, bounds));
        bend += off(there, g) / (0x1p-20 * far);
    }
    return bend * way / algsurf_max_abs(g);
}

/* The rows of beams/kernels.h and surface/view.h written down for one pixel, against what a kernel gave; 0
 * where rounding decides whether the step is taken. */
static int check_entry(const stage *s, int pixel, double depth, const batch *out, int entry) {
    const algsurf_i_view *view = &s->view;
    double a = (pixel + s->job.offset) * s->job.pixel, u = s->job.u0 + s->job.du * a, v = s->row.v;
    double slope = view->alpha * u + view->beta[0], x[3], along[3], here[3], unit[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        along[i] = view->axis[2][i] + slope * view->axis[0][i] + s->job.slope * view->axis[1][i];
        x[i] = view->centre[i] +
               view->size * ((u + depth * slope) * view->axis[0][i] +
                             (v + depth * s->job.slope) * view->axis[1][i] + depth * view->axis[2][i]);
        here[i] = ldexp(x[i], s->surface->unit);
    }
    double gradient[3], value = algsurf_i_surface_value(s->surface, x, gradient), value_bound, bound[3], p,
                        g[3];
    assert_ok(algsurf_surface_gradient(s->surface, here, &p, g, &value_bound, bound));
    double length = algsurf_length(along), rise = fabs(algsurf_dot(g, along)) / length, doubt = 0, z = depth;
    double step = -value / (view->size * algsurf_dot(gradient, along));
    if (fabs(fabs(step) / 0x1p-16 - 1) < 0.01) return 0;
    if (fabs(step) > 0x1p-16) { /* another root may be as near */
        assert_int_equal(out->sure[entry], 0);
        return 1;
    }
    if (fabs(step) < 0x1p-27) assert_int_equal(out->sure[entry], 1);
    if (!out->sure[entry]) return 1;
    double far = algsurf_length(here) + ldexp(view->size, s->surface->unit);
    double way = fabs(step) * ldexp(view->size * length, s->surface->unit), steep = algsurf_max_abs(g) / rise;
    double turn = turn_of(s->surface, here, far, way), blur = turn_of(s->surface, here, far, 1e-15 * far);
    z += step; /* another one may follow */
    doubt = 64 * (value_bound / rise + way * algsurf_max_abs(bound) / rise) + way * turn * steep;
    (void)algsurf_unit(gradient, unit);
    for (int i = 0; i < 3; i++) {
        here[i] = ldexp(x[i] + (z - depth) * view->size * along[i], s->surface->unit);
        along[i] /= length;
    }
    double t = ldexp((z - s->job.near) * view->size * length, s->surface->unit), got[3];
    double near = 1e-13 * (fabs(t) + algsurf_length(here)) + doubt;
    int right = fabs(out->at[0][entry] - t) <= near;
    get(out, entry, 1, got);
    right &= off(got, here) <= near;
    get(out, entry, 4, got);
    right &= off(got, unit) <= 1e-12 + 64 * algsurf_max_abs(bound) / algsurf_max_abs(g) + 2 * turn + blur;
    get(out, entry, 7, got);
    right &= off(got, along) <= 1e-15;
    if (!right) {
        exact_print_doubles("u, v, depth", (double[3]){u, v, depth}, 3);
        exact_print_doubles("t, got", (double[2]){t, out->at[0][entry]}, 2);
        get(out, entry, 1, got);
        exact_print_doubles("position", here, 3), exact_print_doubles("got", got, 3);
        get(out, entry, 4, got);
        exact_print_doubles("normal", unit, 3), exact_print_doubles("got", got, 3);
        fail_msg("seed %llu, entry %d, pixel %d", (unsigned long long)seed, entry, pixel);
    }
    return 1;
}

/* Every kernel on a batch of one row, each entry checked; the number of those checked. */
static int check_row(const stage *s, const int *pixel, const double *depth, int count) {
    static batch out;
    int checked = 0;
    for (int k = 0; k < 3; k++) {
        const algsurf_i_kernel *kernel = algsurf_i_kernel_find(kernel_names[k]);
        if (!kernel) continue;
        run(kernel, s, pixel, depth, count, &out);
        for (int i = 0; i < count; i++) checked += check_entry(s, pixel[i], depth[i], &out, i);
    }
    return checked;
}

/* The hits of a row as the intersection of single rays finds them: t, position and normal there. */
static int hits_of_row(const stage *s, const algsurf_extent *extent, int y, int *pixel, double *depth,
                       algsurf_hit *hits) {
    int count = 0;
    for (int x = 0; x < WIDTH; x++) {
        algsurf_hit *hit = &hits[count];
        double from_centre[3];
        algsurf_ray ray = pixel_ray(&s->camera, WIDTH, HEIGHT, x + 0.5, y + 0.5);
        assert_true(algsurf_intersect_first(s->surface, extent, &ray, NULL, hit) >= 0);
        if (hit->state != ALGSURF_STATE_HIT || fabs(algsurf_dot(hit->normal, ray.direction)) < 0.05) continue;
        for (int i = 0; i < 3; i++)
            from_centre[i] = ldexp(hit->position[i], -s->surface->unit) - s->view.centre[i];
        depth[count] = algsurf_dot(from_centre, s->camera.forward) / s->view.size;
        pixel[count++] = x;
    }
    return count;
}

/* Hits of catalogue surfaces, their depths off by 2^-30: what single rays find. */
TEST(catalogue_hits) {
    static algsurf_hit hits[WIDTH];
    static batch out;
    uint64_t random = seed;
    int pixel[WIDTH], checked = 0;
    double depth[WIDTH], got[3];
    for (const catalogue_entry *e = catalogue; e->name; e++)
        for (int turn = 0; turn < 8; turn++) {
            stage s = {.surface = surface_of(e->equation)};
            random_view(&s, e->extent.centre, e->extent.size[0], turn % 2, &random);
            int y = random_int(&random, HEIGHT);
            set_row(&s, y);
            int count = hits_of_row(&s, &e->extent, y, pixel, depth, hits);
            for (int i = 0; i < count; i++) depth[i] += i % 2 ? 0x1p-30 : -0x1p-30;
            checked += check_row(&s, pixel, depth, count);
            run(algsurf_i_kernel_find(NULL), &s, pixel, depth, count, &out);
            for (int i = 0; i < count; i++) {
                double size = e->extent.size[0], far = algsurf_length(hits[i].position) + size;
                /* Newton's steps from as far as that, where the surface turns; a 20th of it along the ray */
                double way = 0x1p-30 * size, bend = turn_of(s.surface, hits[i].position, far, way);
                double value, g[3], bound, bounds[3];
                assert_ok(algsurf_surface_gradient(s.surface, hits[i].position, &value, g, &bound, bounds));
                double doubt = 20 * (way * bend + bound / algsurf_max_abs(g));
                int right = fabs(out.at[0][i] - hits[i].t) <= 1e-13 * (size + hits[i].t) + doubt;
                get(&out, i, 1, got);
                right &= off(got, hits[i].position) <= 1e-12 * far + doubt;
                get(&out, i, 4, got);
                right &= off(got, hits[i].normal) <= 1e-10 + 4 * bend;
                if (!right) fail_msg("%s, view %d, pixel %d %d", e->name, turn, pixel[i], y);
            }
        }
    assert_in_range(checked, 1500, INT32_MAX); /* so many when there is one kernel only */
}

/* A surface of a degree with only even powers of some coordinates (bits of `even`), many terms missing. */
static algsurf_surface *random_surface(int degree, int even, uint64_t *state) {
    algsurf_term terms[300];
    size_t count = 0;
    for (int i = 0; i <= degree; i++)
        for (int j = 0; i + j <= degree; j++)
            for (int k = 0; i + j + k <= degree; k++) {
                if ((i & even) % 2 || (j & even >> 1) % 2 || (k & even >> 2) % 2) continue;
                if (random_int(state, 3) == 0 || count == 0)
                    terms[count++] = (algsurf_term){i, j, k, random_unit(state)};
            }
    return surface_of_terms(terms, count);
}

/* P and its gradient at random points, whatever the shape of the polynomial. */
TEST(random_surfaces) {
    uint64_t random = seed + 1;
    const double centre[3] = {0.125, -0.25, 0.0625};
    for (int turn = 0; turn < 600; turn++) {
        stage s = {.surface = random_surface(1 + turn % 9, turn % 8, &random)};
        int pixel[WIDTH], count = random_int(&random, 20);
        double depth[WIDTH];
        random_view(&s, centre, ldexp(1.5, s.surface->unit), turn % 3 == 0, &random);
        set_row(&s, random_int(&random, HEIGHT));
        for (int i = 0; i < count; i++)
            pixel[i] = random_int(&random, WIDTH), depth[i] = random_unit(&random);
        assert_in_range(check_row(&s, pixel, depth, count), count, 3 * count);
    }
}

/* A parallel view down the z-axis from height 2: u is x, v is y, the depth is -z. */
static void look_down_z(stage *s, const char *equation, double v) {
    s->surface = surface_of(equation);
    s->camera = (algsurf_camera){.eye = {0, 0, 2},
                                 .right = {1, 0, 0},
                                 .up = {0, 1, 0},
                                 .forward = {0, 0, -1},
                                 .kind = ALGSURF_CAMERA_ORTHOGRAPHIC};
    s->camera.half_height = 0.5 * HEIGHT;
    set_view(s, (double[3]){0, 0, 0}, 1);
    s->row.v = v;
}

/* One entry at u, by all kernels alike; out is the first one's. */
static void one(stage *s, double u, double depth, batch *out) {
    const int pixel = 0;
    s->job.offset = u, s->job.pixel = 1;
    for (int k = 0; k < 3; k++) {
        const algsurf_i_kernel *kernel = algsurf_i_kernel_find(kernel_names[k]);
        static batch other;
        if (!kernel) continue;
        memset(&other, 0, sizeof other);
        run(kernel, s, &pixel, &depth, 1, k == 0 ? out : &other);
        for (int i = 0; i < OUTPUTS && k > 0; i++)
            assert_memory_equal(&other.at[i][0], &out->at[i][0], sizeof(double));
    }
}

/* On a plane the step is the distance: taken up to 2^-16, refused beyond, and where it is not a number. */
TEST(steps) {
    static batch out;
    stage s;
    double normal[3];
    look_down_z(&s, "z - 1/4", 0.5);
    for (int sign = -1; sign <= 1; sign += 2) {
        one(&s, 0.5, -0.25 + sign * 0x1p-16, &out);
        assert_true(out.at[0][0] == 1.75 && out.at[3][0] == 0.25);
        one(&s, 0.5, -0.25 + sign * 0x1.01p-16, &out);
        assert_true(out.at[0][0] == 1.75 + sign * 0x1.01p-16 && out.at[3][0] == 0.25 - sign * 0x1.01p-16);
        get(&out, 0, 4, normal);
        assert_true(off(normal, (double[3]){0, 0, 1}) == 0);
        assert_true(out.at[1][0] == 0.5 && out.at[2][0] == 0.5);
    }
    look_down_z(&s, "x^2 + y^2 - 1/2", 0.5); /* the gradient is across the ray */
    one(&s, 0.5, 0.75, &out);
    assert_true(out.at[0][0] == 2.75 && out.at[3][0] == -0.75);
}

/* Points without a gradient: where it is 0, and where it leaves the range of double. */
TEST(singular_points) {
    static const struct {
        const char *equation;
        double u, v, depth;
    } cases[] = {{"x^2 + y^2 - z^2", 0, 0, 0},        {"x^2 z + y^2", 0, 0, 0.375},
                 {"x^2 + y^2 + z^2 - 1", 0, 0, 0},    {"7", 0.25, 0.5, 0.125},
                 {"x^4 + y^4 - z^4", 0, 0, -0x1p400}, {"(x-y)^3 + x^2 y^2 z^5", 0x1p300, 0x1p300, 0x1p10},
                 {"x^9 - y^9", 0x1p128, 0x1p128, 0}};
    static batch out;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        stage s;
        look_down_z(&s, cases[k].equation, cases[k].v);
        one(&s, cases[k].u, cases[k].depth, &out);
        for (int i = 4; i < 7; i++) assert_true(out.at[i][0] == 0);
        assert_true(out.at[0][0] == cases[k].depth + 2 && out.at[1][0] == cases[k].u);
        assert_true(out.at[2][0] == cases[k].v && out.at[3][0] == -cases[k].depth);
    }
}

/* Gradients whose squares underflow or overflow have a direction all the same: (0, 6, 3) / sqrt 45. */
TEST(scales) {
    static const double sizes[] = {1e-150, 1e-100, 1e-60, 1, 1e60, 1e100};
    const double expected[3] = {0, 2 / sqrt(5), 1 / sqrt(5)};
    static batch out;
    double normal[3];
    for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++) {
        stage s;
        look_down_z(&s, "z^3 + 2y^3", sizes[k]);
        one(&s, 0, -sizes[k], &out);
        get(&out, 0, 4, normal);
        if (!(off(normal, expected) <= 1e-15)) fail_msg("at %g", sizes[k]);
    }
    stage s;
    look_down_z(&s, "z^2 + 2y^2", 0x1p-1060); /* its squares are 0, its gradient is not */
    one(&s, 0, -0x1p-1060, &out);
    get(&out, 0, 4, normal);
    assert_true(off(normal, expected) <= 1e-15);
}

/* Any number of entries, by any kernel: the bits of each entry alone; the rest of the arrays untouched.
 * Pixels and depths end where their memory does, for the sanitizers. */
TEST(same_bits) {
    static batch alone, out, entry;
    enum { ENTRIES = 17 };
    uint64_t random = seed + 2;
    int *pixel = malloc(ENTRIES * sizeof *pixel);
    double *depth = malloc(ENTRIES * sizeof *depth);
    assert_true(pixel && depth);
    for (int turn = 0; turn < 12; turn++) {
        const catalogue_entry *e = &catalogue[turn];
        stage s = {.surface = surface_of(e->equation)};
        random_view(&s, e->extent.centre, e->extent.size[0], turn % 2, &random);
        set_row(&s, random_int(&random, HEIGHT));
        memset(&alone, 0xa5, sizeof alone);
        for (int i = 0; i < ENTRIES; i++) {
            pixel[i] = random_int(&random, WIDTH), depth[i] = i == 5 ? NAN : random_unit(&random);
            run(algsurf_i_kernel_find("baseline"), &s, pixel + i, depth + i, 1, &entry);
            for (int k = 0; k < OUTPUTS; k++) alone.at[k][i] = entry.at[k][0];
        }
        for (int begin = 0; begin <= ENTRIES; begin++)
            for (int k = 0; k < 3; k++) {
                const algsurf_i_kernel *kernel = algsurf_i_kernel_find(kernel_names[k]);
                if (!kernel) continue;
                memset(&out, 0xa5, sizeof out);
                run(kernel, &s, pixel + begin, depth + begin, ENTRIES - begin, &out);
                for (int o = 0; o < OUTPUTS; o++) {
                    assert_memory_equal(out.at[o], alone.at[o] + begin, (size_t)(ENTRIES - begin) * 8);
                    assert_memory_equal(out.at[o] + ENTRIES - begin, alone.at[o] + ENTRIES, SPARE * 8);
                }
            }
    }
    free(pixel), free(depth);
}
