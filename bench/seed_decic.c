/* seed_decic.c - see seed.h; after figures 3 and 4 of Chuyeshov, Visualization of algebraic surfaces.
 *
 * Where a bracket is flat at one end and steep at the other, false position creeps: the steep end never
 * moves.  What it makes of the decic depends on when it stops: never before the limit of 1000 iterations; at
 * |P| <= tolerance, as that paper has it, which is no statement about t; or, as the library does, when two
 * points agree within the tolerance, which they also do when it only is slow.
 */
#include "seed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "image.h"
#include "must.h"
#include "rays.h"
#include "results.h"

static const double TOLERANCE = 1e-6;
enum { LIMIT = 1000, BRENT = 0, PLAIN = 1, SMALL = 2, AGREE = 3 };

static algsurf_refined_root solve(int row, const seed_ray *ray, int degree) {
    algsurf_refined_root root;
    const seed_method *method = &seed_methods[row == AGREE ? SEED_REGULA_FALSI : SEED_BRENT];
    double small = row == SMALL ? TOLERANCE : 0;
    if (row == PLAIN || row == SMALL)
        (void)seed_false_position(ray->c, degree, ray->lo, ray->hi, TOLERANCE, small, LIMIT, &root);
    else if (seed_solve(method, ray->c, degree, ray->lo, ray->hi, TOLERANCE, LIMIT, &root) < 0)
        cli_fail(CLI_BROKEN, "barth-decic: a bracket is refused");
    return root;
}

/* Half the chord in units of a pixel's width where the root is. */
static double half_in_pixels(const seed_view *view, const seed_ray *ray) {
    algsurf_ray chord;
    if (!seed_chord(view, ray->pixel, &chord)) return 0;
    double half = 0.5 * (chord.t_max - chord.t_min), t = chord.t_min + half * (1 + ray->root);
    return half / (2 * view->camera.half_height / view->height * t);
}

/* As an example serves best a ray on which, in the end, half of a long way is left. */
static void consider(seed_decic *decic, const seed_ray *ray, const algsurf_refined_root *root) {
    double whole = root->lo > ray->lo ? ray->root - ray->lo : ray->hi - ray->root;
    double left = fabs(root->root - ray->root), merit = fmin(left, whole - left);
    if (decic->slow && merit <= decic->merit) return;
    decic->slow = ray;
    decic->merit = merit;
}

static void count_error(seed_decic *decic, int row, const seed_ray *ray, const algsurf_refined_root *root) {
    seed_decic_row *to = &decic->row[row];
    double error = fmax(0, fabs(root->root - ray->root) - ray->radius);
    to->roots++;
    to->evaluations += root->evaluations;
    to->at_limit += root->iterations >= LIMIT;
    to->off += error > TOLERANCE;
    to->wrong += error > 10 * TOLERANCE;
    to->visible += error > TOLERANCE && error * half_in_pixels(&decic->view, ray) > 1;
    if (row == PLAIN) consider(decic, ray, root);
    to->largest = fmax(to->largest, error);
    if (row == BRENT && error > seed_allowed(&decic->view, ray, TOLERANCE))
        cli_fail(CLI_BROKEN, "barth-decic: Brent's method is off by %.3g", error);
}

/* ---- pictures ---- */

/* Orange, red, white: bench/report tells what they mean. */
static const uint8_t OFF[3] = {230, 159, 0}, VISIBLE[3] = {213, 0, 94}, BEHIND[3] = {255, 255, 255};

/* The surface's colour where the ray has the parameter x in [-1,1]. */
static void shade(const seed_view *view, const algsurf_lighting *lighting, const seed_ray *ray, double x,
                  uint8_t pixel[3]) {
    const char *name = view->entry->name;
    algsurf_ray chord;
    double point[3], gradient[3], value, colour[3], size = 0;
    if (!seed_chord(view, ray->pixel, &chord)) return;
    double t = 0.5 * (chord.t_min + chord.t_max) + 0.5 * (chord.t_max - chord.t_min) * x;
    for (int i = 0; i < 3; i++) point[i] = chord.origin[i] + t * chord.direction[i];
    must(algsurf_surface_gradient(view->surface, point, &value, gradient, NULL, NULL), name);
    for (int i = 0; i < 3; i++) size += gradient[i] * gradient[i];
    for (int i = 0; i < 3; i++) gradient[i] = size > 0 ? gradient[i] / sqrt(size) : 0;
    must(algsurf_shade(lighting, NULL, point, gradient, chord.direction, colour), name);
    must(algsurf_srgb_encode(colour, pixel), name);
}

/* Pale grey for what is right. */
static void mark(const seed_view *view, const seed_ray *ray, double error, uint8_t pixel[3]) {
    double grey = 110 + 0.5 * (0.3 * pixel[0] + 0.6 * pixel[1] + 0.1 * pixel[2]);
    memset(pixel, (int)grey, 3);
    if (error > TOLERANCE && error * half_in_pixels(view, ray) > 1)
        memcpy(pixel, VISIBLE, 3);
    else if (error > 10 * TOLERANCE)
        memcpy(pixel, OFF, 3);
}

enum { READABLE = 640 }; /* pixels: narrower pictures are enlarged by a whole number */

static void write_picture(const uint8_t *picture, int width, int height, const char *folder,
                          const char *name) {
    int by = width < READABLE ? READABLE / width : 1;
    size_t across = (size_t)width * (size_t)by, down = (size_t)height * (size_t)by;
    uint8_t *large = must_allocate(across * down, 3);
    for (size_t i = 0; i < across * down; i++) {
        size_t column = i % across / (size_t)by, row = i / across / (size_t)by;
        memcpy(large + 3 * i, picture + 3 * (row * (size_t)width + column), 3);
    }
    FILE *file = results_open(folder, name, "wb");
    if (image_write(file, IMAGE_PNG, (int)across, (int)down, large)) cli_no_memory();
    results_finish(file, folder, name);
    free(large);
}

static void draw(const seed_decic *decic, const double *found, int marked, const char *folder,
                 const char *name) {
    const seed_view *view = &decic->view;
    size_t pixels = (size_t)view->width * (size_t)view->height;
    uint8_t *picture = must_allocate(pixels, 3);
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    algsurf_scene *scene = rays_scene(view->surface, &view->entry->extent, &view->camera);
    must(algsurf_scene_get_lighting(scene, lights, &lighting), view->entry->name);
    for (size_t i = 0; i < pixels; i++) memcpy(picture + 3 * i, BEHIND, 3);
    for (size_t i = 0; i < view->count; i++) {
        const seed_ray *ray = &view->rays[i];
        uint8_t *pixel = picture + 3 * (size_t)ray->pixel;
        if (!ray->bracketed) continue;
        shade(view, &lighting, ray, found[i], pixel);
        if (marked) mark(view, ray, fabs(found[i] - ray->root), pixel);
    }
    write_picture(picture, view->width, view->height, folder, name);
    algsurf_scene_free(scene);
    free(picture);
}

/* ---- all of it ---- */

/* found: the root of each ray that has a bracket. */
static void solve_all(seed_decic *decic, int row, double *found) {
    const seed_view *view = &decic->view;
    for (size_t i = 0; i < view->count; i++) {
        if (!view->rays[i].bracketed) continue;
        algsurf_refined_root root = solve(row, &view->rays[i], view->entry->degree);
        count_error(decic, row, &view->rays[i], &root);
        found[i] = root.root;
    }
    decic->row[row].evaluations /= (double)decic->row[row].roots;
}

void seed_decic_run(seed_decic *decic, int width, int height, const char *folder) {
    static const seed_decic_row rows[SEED_DECIC_ROWS] = {
        [BRENT] = {.method = "Brent", .stop = "narrow bracket"},
        [PLAIN] = {.method = "regula falsi", .stop = "1000 iterations"},
        [SMALL] = {.method = "regula falsi", .stop = "|P| <= 1e-6"},
        [AGREE] = {.method = "regula falsi", .stop = "points agree"}};
    decic->slow = NULL;
    memcpy(decic->row, rows, sizeof rows);
    seed_open(&decic->view, "barth-decic", width, height);
    if (decic->view.bracketed == 0) cli_fail(CLI_BROKEN, "barth-decic: no root at all");
    double *found = must_allocate(decic->view.count, sizeof *found);
    for (int row = 0; row < SEED_DECIC_ROWS; row++) {
        solve_all(decic, row, found);
        if (folder && row == BRENT) draw(decic, found, 0, folder, "seed_decic_brent.png");
        if (folder && row == PLAIN) {
            draw(decic, found, 0, folder, "seed_decic_regula_falsi.png");
            draw(decic, found, 1, folder, "seed_decic_wrong.png");
        }
    }
    free(found);
}
