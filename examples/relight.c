/* relight.c - a host that lights a surface itself.  The library says once what each pixel shows: how far away
 * (t), how it lies (its normal), and whether there is anything (state).  Any number of pictures are made from
 * that, with no further ray: here two, as text, of a torus under a light from the left and from the right.
 *
 *     cc -O2 -ffp-contract=off -I../include relight.c $(find ../lib -name "*.c") -lm -pthread -o relight
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "algsurf/algsurf.h"

enum { WIDTH = 38, HEIGHT = 32 }; /* in pixels; a letter is two of them, one above the other */

static algsurf_camera camera;
static double t[WIDTH * HEIGHT];
static float normals[WIDTH * HEIGHT][3];
static unsigned char state[WIDTH * HEIGHT];

static void check(algsurf_status status) {
    if (status == ALGSURF_OK) return;
    fprintf(stderr, "%s\n", algsurf_status_text(status));
    exit(1);
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* What the pixels show; no colours are asked for. */
static void look_at_torus(void) {
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3, 0, 0}};
    const double eye[3] = {0, -9, 8}, middle[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    const algsurf_render_options options = {.size = sizeof options, .width = WIDTH, .height = HEIGHT};
    const algsurf_picture picture = {.size = sizeof picture, .t = t, .normals = normals[0], .state = state};
    algsurf_surface *torus;
    algsurf_scene *scene;
    check(algsurf_surface_from_equation("(x^2 + y^2 + z^2 + 3)^2 = 16 (x^2 + y^2)", NULL, 0, &torus, NULL));
    check(algsurf_camera_pinhole(eye, middle, up, 24, &camera));
    check(algsurf_scene_create(torus, &scene));
    check(algsurf_scene_set_extent(scene, &ball));
    check(algsurf_scene_set_camera(scene, &camera));
    check(algsurf_render(scene, &options, &picture, NULL));
    algsurf_scene_free(scene);
    algsurf_surface_free(torus);
}

/* 0 where there is nothing, otherwise 0.2 to 1: Lambert's law for a light at a point. */
static double brightness(int pixel, const double light[3]) {
    algsurf_ray ray;
    double normal[3], to_light[3];
    if (state[pixel] == ALGSURF_STATE_MISS) return 0;
    check(algsurf_camera_ray(&camera, WIDTH, HEIGHT, pixel % WIDTH + 0.5, pixel / WIDTH + 0.5, &ray));
    for (int i = 0; i < 3; i++) {
        normal[i] = normals[pixel][i];
        to_light[i] = light[i] - (ray.origin[i] + t[pixel] * ray.direction[i]);
    }
    double side = dot(normal, ray.direction) > 0 ? -1 : 1; /* that of the viewer */
    double cosine = side * dot(normal, to_light) / sqrt(dot(to_light, to_light));
    return 0.2 + 0.8 * fmax(0, cosine);
}

static char letter(int x, int y, const double light[3]) {
    static const char letters[] = " .:-=+*#%@";
    int above = 2 * y * WIDTH + x;
    double sum = brightness(above, light) + brightness(above + WIDTH, light);
    return letters[(int)(0.5 * sum * (sizeof letters - 2) + 0.5)];
}

int main(int argc, char **argv) {
    const double lights[2][3] = {{-7, -4, 3}, {7, -4, 3}};
    if (argc > 1) {
        fprintf(stderr, "%s: takes no arguments\n", argv[0]);
        return 2;
    }
    look_at_torus();
    for (int y = 0; y < HEIGHT / 2; y++) {
        char line[2 * WIDTH];
        int end = 0; /* without blanks at the end */
        for (int x = 0; x < 2 * WIDTH; x++) {
            line[x] = letter(x % WIDTH, y, lights[x / WIDTH]);
            if (line[x] != ' ') end = x + 1;
        }
        printf("%.*s\n", end, line);
    }
    return 0;
}
