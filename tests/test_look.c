/* test_look.c - the named surfaces as a viewer gets them: no side is black, nothing burns out, the colours of
 * both sides are equally light, and pictures are neither dark nor pale.  Of pixels that the surface covers
 * wholly, in standard and in full quality, 3 x 3 samples.
 *
 * Breaks caught, each tried: shadows that take all light, no light from the eye, a highlight that adds
 * instead of mixing, bytes without the curve of sRGB.
 */
#include "catalogue.h"
#include "scenes.h"

enum { WIDTH = 320, HEIGHT = 240 };

/* L* of CIE 1976. */
static double lightness(const double colour[3]) {
    double y = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
    return y > 0.008856 ? 116 * cbrt(y) - 16 : 903.3 * y;
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static algsurf_scene *shown(const catalogue_entry *entry, algsurf_quality quality,
                            algsurf_surface **surface) {
    algsurf_camera camera = pinhole_of(entry->eye, entry->look_at, entry->up, entry->fov);
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    *surface = surface_of(entry->equation);
    algsurf_scene *scene = scene_of(*surface, &entry->extent, &camera, NULL);
    assert_ok(algsurf_scene_set_quality(scene, quality));
    assert_ok(algsurf_scene_set_background(scene, NULL));
    assert_ok(algsurf_scene_set_antialias(scene, 3));
    assert_ok(algsurf_scene_get_lighting(scene, lights, &lighting));
    algsurf_material material = *lighting.material;
    for (int i = 0; i < 3; i++) {
        material.outside[i] = entry->outside[i];
        material.inside[i] = entry->inside[i];
    }
    assert_ok(algsurf_scene_set_material(scene, &material));
    return scene;
}

static void check(const catalogue_entry *entry, algsurf_quality quality) {
    static unsigned char pixels[4 * WIDTH * HEIGHT];
    static double light[WIDTH * HEIGHT];
    const algsurf_render_options size = {.size = sizeof size, .width = WIDTH, .height = HEIGHT};
    const algsurf_picture planes = {.size = sizeof planes, .pixels = pixels, .format = ALGSURF_RGBA8};
    algsurf_surface *surface;
    algsurf_scene *scene = shown(entry, quality, &surface);
    int count = 0, darkest = 255, dark = 0, burnt = 0;
    assert_ok(algsurf_render(scene, &size, &planes, NULL));
    for (const unsigned char *p = pixels; p < pixels + sizeof pixels; p += 4) {
        double colour[3];
        int largest = p[0] > p[1] ? p[0] : p[1];
        if (p[3] < 255) continue;
        if (p[2] > largest) largest = p[2];
        darkest = largest < darkest ? largest : darkest;
        dark += largest < 60;
        burnt += largest == 255;
        assert_ok(algsurf_srgb_decode(p, colour));
        light[count++] = lightness(colour);
    }
    qsort(light, (size_t)count, sizeof *light, by_size);
    double first = light[count / 100], middle = light[count / 2], last = light[count - 1 - count / 100];
    int fine = darkest >= 45 && dark <= count / 200 && burnt <= count / 5000 && first >= 20 && middle >= 45 &&
               middle <= 75 && last <= 82;
    if (!fine)
        fail_msg("%s, quality %d: largest channel of the darkest %d, below 60 %d of %d, burnt out %d, L* "
                 "%.1f %.1f %.1f",
                 entry->name, (int)quality, darkest, dark, count, burnt, first, middle, last);
}

TEST(standard) {
    for (const catalogue_entry *entry = catalogue; entry->name; entry++)
        check(entry, ALGSURF_QUALITY_STANDARD);
}

TEST(full) {
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) check(entry, ALGSURF_QUALITY_FULL);
}

TEST(sides) {
    for (const catalogue_entry *entry = catalogue; entry->name; entry++)
        assert_true(fabs(lightness(entry->outside) - lightness(entry->inside)) <= 2.5);
}
