/* test_fit.c - the view that is chosen for an equation: what it holds, what of the picture is filled, how
 * long it takes.
 *
 * Surfaces for which a view once took seconds, or showed something else than the surface.  Each has the
 * radius that its ball must have, or half the edge of its box, and the share of the picture's pixels that
 * must show something.  Then the times of all famous surfaces (tests/data/famous.tsv); the worst is printed.
 *
 * Breaks caught, each tried: a ball about a surface of degree 64; glances that go to integers; no probes; a
 * point's own box as extent; the usual side for a plane; no look for a part by itself.
 */
#include "unit.h"

#include "fit.h"

static const double LONGEST = 0.4; /* seconds of processor time; a quiet machine takes a quarter of it */

static double worst;
static char worst_of[600];

static view fit(const algsurf_surface *surface, const char *text, fit_choice *choice) {
    view_options options;
    view v;
    memset(&options, 0, sizeof options);
    options.width = 640, options.height = 480;
    const double begun = unit_seconds();
    assert_ok(fit_choose(&v, &options, surface, 0, 1, choice));
    const double took = unit_seconds() - begun;
    if (took > worst) worst = took, snprintf(worst_of, sizeof worst_of, "%.590s", text);
    return v;
}

/* Per cent of the pixels that show something. */
static double share_seen(const algsurf_surface *surface, const view *v) {
    enum { W = 48, H = 36 };
    static unsigned char state[W * H];
    static const double colour[3] = {1, 1, 1};
    const algsurf_render_options size = {.size = sizeof size, .width = W, .height = H};
    const algsurf_picture planes = {.size = sizeof planes, .state = state};
    algsurf_scene *scene;
    algsurf_camera camera;
    int seen = 0;
    assert_ok(algsurf_scene_create(surface, &scene));
    assert_ok(view_make_camera(v, 0, 1, &camera));
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    assert_ok(algsurf_scene_set_extent(scene, &v->extent));
    assert_ok(algsurf_scene_set_thin(scene, colour));
    assert_ok(algsurf_render(scene, &size, &planes, NULL));
    for (int i = 0; i < W * H; i++) seen += state[i] != ALGSURF_STATE_MISS;
    algsurf_scene_free(scene);
    return 100.0 * seen / (W * H);
}

TEST(test_named) {
    static const struct {
        const char *equation;
        double least, most; /* radius, or half of a box's edges */
        double seen[2];     /* per cent */
    } cases[] = {
        {"(x^2+y^2+z^2-16)^3 + 27*16 x^2 y^2 z^2 = 0", 4, 10, {25, 50}},
        {"4(x^2+y^2+z^2-13)^3 + 27(3x^2+y^2-4z^2-12)^2 = 0", 3, 7, {25, 60}},
        {"x^4 y^2 + y^4 x^2 - x^2 y^2 + z^6 = 0", 1, 4, {40, 70}},
        {"x^40 + y^40 + z^40 = 1", 1, 1.2, {25, 55}},
        {"x^64 + y^64 + z^64 = 1", 1, 1.2, {25, 55}},
        {"(x^2+y^2+z^2)^20 = 1", 1, 2.1, {25, 60}},
        {"(x+y+z)^6 = 0", 3, 4, {30, 60}},
        {"x + y + z = 1", 3, 4, {30, 60}},
        {"(x^2+y^2+z^2-1)^12 = 0", 1, 1.9, {30, 60}},
        {"x^50 + y^50 = z", 3, 4, {15, 50}},
        {"x^4 + y^2 + z^2 = 0", 0.5, 2, {0, 0.1}},
        {"x^6 + y^2 + z^2 = 0", 0.5, 2, {0, 0.1}},
        {"(x-1)^4 + y^2 + z^2 = 0", 0.5, 7, {0, 0.1}},
        {"x^2 + y^2 + (z^2-x)^2 = 0", 0.5, 4, {0.01, 0.1}},
        {"5x^2 + 2x z^2 + 5y^6 + 15y^4 + 5z^2 - 15y^5 - 5y^3 = 0", 0.5, 0.7, {10, 40}},
        {"(x-1)^2 + y^2 + z^2 = 1/1000000", 0.001, 0.002, {30, 60}}, /* small, but no point */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        algsurf_surface *surface;
        fit_choice choice;
        assert_ok(algsurf_surface_from_equation(cases[i].equation, NULL, 0, &surface, NULL));
        const view v = fit(surface, cases[i].equation, &choice);
        const double radius = v.extent.size[0], seen = share_seen(surface, &v);
        if (!(radius >= cases[i].least && radius <= cases[i].most && seen >= cases[i].seen[0] &&
              seen <= cases[i].seen[1]))
            fail_msg("%s: radius %g, %.2f %% are seen", cases[i].equation, radius, seen);
        algsurf_surface_free(surface);
    }
    printf("longest: %.3f s, %s\n", worst, worst_of);
    assert_true(worst < LONGEST);
}

TEST(test_famous_times) {
    char line[2000];
    int count = 0;
    double sum = 0;
    FILE *file = fopen(TEST_DATA "/famous.tsv", "r");
    assert_non_null(file);
    for (worst = 0; fgets(line, sizeof line, file); count++) {
        char *equation = strrchr(line, '\t');
        algsurf_surface *surface;
        fit_choice choice;
        assert_non_null(equation);
        line[strcspn(line, "\n")] = 0;
        assert_ok(algsurf_surface_from_equation(equation + 1, NULL, 0, &surface, NULL));
        const double begun = unit_seconds();
        (void)fit(surface, line, &choice);
        sum += unit_seconds() - begun;
        algsurf_surface_free(surface);
    }
    fclose(file);
    printf("%d famous surfaces: mean %.3f s, longest %.3f s, %s\n", count, sum / count, worst, worst_of);
    assert_true(count > 40 && worst < LONGEST);
}
