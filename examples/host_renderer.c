/* host_renderer.c - a small ray tracer of balls and a floor, to which an algebraic surface is one more
 * geometry: host_renderer --help.
 *
 *     host_renderer_surface.c  the surface as user geometry: bounds, intersect, occluded
 *     host_renderer_host.h     what the renderer asks of a geometry
 *     host_renderer_shapes.c   balls, floor
 *     host_renderer_trace.c    hits, shadows, mirrors
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "catalogue.h"
#include "cli_surface.h"
#include "host_renderer_host.h"
#include "output.h"
#include "view.h"

typedef struct host_options {
    const char *extra; /* a plain argument, which this program does not take */
    const char *output;
    view_options view; /* the size only */
    int packet, antialias, cut_away, flush;
} host_options;

#define FIELD(member) offsetof(host_options, member)

static const cli_option options_table[] = {
    {"--size", "WxH", "size of the picture, default 640x480", view_set_size, FIELD(view), 0, 0},
    {"--output", "FILE",
     ".png, .bmp, .ppm by its ending, default host_renderer.png; - is a PPM on\nstandard output",
     cli_set_text, FIELD(output), 0, 0},
    {"--antialias", "N", "N x N samples a pixel and of the lamp, default 1", cli_set_int, FIELD(antialias), 1,
     16},
    {"--packet", "N", "rays that are traced together, default 64; 1: single rays", cli_set_int, FIELD(packet),
     1, HOST_MAX_RAYS},
    {"--cut-away", NULL, "a box is removed from the surface", cli_set_flag, FIELD(cut_away), 0, 0},
    {"--flush-to-zero", NULL,
     "trace as most renderers do, with subnormal numbers taken for zero:\nthe picture stays the same",
     cli_set_flag, FIELD(flush), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "host_renderer",
    .synopsis = "[options]",
    .about = "Draws a tanglecube among balls and over a floor: shadows, mirrors, packets of rays, a\n"
             "cut-away.",
    .options = options_table,
    .positional = FIELD(extra),
};

/* Subnormal operands and results become zero, as Embree asks of its users. */
static void flush_to_zero(void) {
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040u);
#elif defined(__aarch64__)
    unsigned long long fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    __asm__ volatile("msr fpcr, %0" ::"r"(fpcr | 1ull << 24));
#else
    cli_fail(CLI_BROKEN, "--flush-to-zero: not known for this processor");
#endif
}

/* The rays of pixels [x, x+N) of a row through place (a,b) of n x n in each pixel. */
static void fill(const algsurf_camera *camera, const host_options *o, int x, int y, int N, int a, int b,
                 host_rays *rays) {
    for (int i = 0; i < N; i++) {
        algsurf_ray ray;
        (void)algsurf_camera_ray(camera, o->view.width, o->view.height, x + i + (a + 0.5) / o->antialias,
                                 y + (b + 0.5) / o->antialias, &ray);
        host_set_ray(rays, i, ray.origin, ray.direction, INFINITY);
    }
}

/* N pixels of a row, from the mean of their samples; square roots: light to the values of a screen. */
static void draw(const host_scene *scene, const algsurf_camera *camera, const host_options *o, int x, int y,
                 int N, uint8_t *pixels) {
    enum { DEPTH = 4 };
    double sum[HOST_MAX_RAYS][3] = {{0}}, colour[HOST_MAX_RAYS][3];
    int valid[HOST_MAX_RAYS];
    for (int i = 0; i < N; i++) valid[i] = -1;
    for (int s = 0; s < o->antialias * o->antialias; s++) {
        host_rays rays;
        int a = s % o->antialias, b = s / o->antialias;
        fill(camera, o, x, y, N, a, b, &rays);
        host_trace(scene, &rays, valid, N, a, b, DEPTH, colour);
        for (int i = 0; i < N; i++)
            for (int k = 0; k < 3; k++) sum[i][k] += fmin(colour[i][k], 1);
    }
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 3; k++) pixels[3 * i + k] = (uint8_t)(255 * sqrt(sum[i][k]) / o->antialias + 0.5);
}

static const host_floor ground = {-2.27, 60};
static const host_ball chrome = {{0, 0, 0}, 1.2}, red = {{3.6, -1.9, -1.57}, 0.7},
                       blue = {{-1.0, -4.6, -1.82}, 0.45};

static host_scene make_scene(const host_surface *surface, int lamp_samples) {
    const host_material enamel = {{0.05, 0.16, 0.30}, {0.80, 0.42, 0.06}, 0.07, 0},
                        steel = {{0.05, 0.05, 0.05}, {0.05, 0.05, 0.05}, 0.85, 0},
                        ruby = {{0.62, 0.04, 0.05}, {0.62, 0.04, 0.05}, 0.06, 0},
                        sea = {{0.03, 0.30, 0.38}, {0.03, 0.30, 0.38}, 0.06, 0},
                        tiles = {{0.60, 0.56, 0.50}, {0.36, 0.32, 0.29}, 0.05, 1};
    return (host_scene){.geometry = {host_floor_geometry(&ground, &tiles),
                                     host_ball_geometry(&chrome, &steel), host_ball_geometry(&red, &ruby),
                                     host_ball_geometry(&blue, &sea),
                                     host_surface_geometry(surface, &enamel)},
                        .count = 5,
                        .light = {.position = {3, -11, 14},
                                  .colour = {0.95, 0.85, 0.70},
                                  .edge_u = {2, 0.6, 0},
                                  .edge_v = {-0.5, 1.6, 1.2},
                                  .samples_u = lamp_samples,
                                  .samples_v = lamp_samples}};
}

static void picture(const host_scene *scene, const host_options *o, uint8_t *pixels) {
    const double eye[3] = {7.6, -13.2, 5.6}, look_at[3] = {0.5, 0, -0.2}, up[3] = {0, 0, 1};
    int width = o->view.width;
    algsurf_camera camera;
    (void)algsurf_camera_pinhole(eye, look_at, up, 27, &camera);
    for (int y = 0; y < o->view.height; y++)
        for (int x = 0; x < width; x += o->packet) {
            int N = o->packet < width - x ? o->packet : width - x;
            draw(scene, &camera, o, x, y, N, pixels + 3 * ((size_t)y * (size_t)width + (size_t)x));
        }
}

int main(int argc, char **argv) {
    host_options o = {
        .output = "host_renderer.png", .view = {.width = 640, .height = 480}, .packet = 64, .antialias = 1};
    image_format format = IMAGE_PPM;
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s': there is one scene", cli_quote(o.extra).text);
    if (!image_format_of(o.output, &format) && strcmp(o.output, "-") != 0 && !output_is_special(o.output))
        cli_fail(CLI_BAD_INPUT, "--output: expected a name ending in .png, .bmp or .ppm, got '%s'",
                 cli_quote(o.output).text);
    output_check(&o.output, 1, NULL);
    uint8_t *pixels = malloc((size_t)o.view.width * (size_t)o.view.height * 3);
    if (!pixels) cli_no_memory();

    cli_surface name = {.name = "tangle"};
    host_surface tangle = {.surface = cli_make_surface(&name),
                           .extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3.7, 0, 0}},
                           .cut = o.cut_away,
                           .removed = {{-4, -4, -4}, {4, -1.55, 4}}};
    host_scene scene = make_scene(&tangle, o.antialias);
    host_commit(&scene);
    if (o.flush) flush_to_zero();
    picture(&scene, &o, pixels);

    output_set files = {.count = 0};
    output_image(&files, o.output, format, o.view.width, o.view.height, pixels);
    output_commit(&files);
    algsurf_surface_free(tangle.surface);
    free(pixels);
    return 0;
}
