/* peers_scene.c - see peers.h.
 *
 * What makes the scenes alike, from the programs' sources and from their pictures:
 * - POV-Ray's pixel centres are at (i+1/2)/W, as ours are.  It clips only rays that it has solved unless
 *   `bounded_by` stands beside `clipped_by`.
 * - surf turns the surface about y, x, z in this order, scales it, then applies the perspective; its window
 * is 20 units on the shorter side.  The centres of its corner pixels lie on the window's edge: x and y have
 *   different pitches, which its scales undo; the clip sphere then is an ellipsoid, 0.03 % off at this size.
 *   Without `clip=sphere` it clips elsewhere; lights 3 and 8 are on unless told otherwise.
 */
#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "peers.h"
#include "rays.h"

static const double DISTANCE = 4, HALF_HEIGHT = 1.1; /* in radii, as rays_camera */

enum { LIGHTS = 2 };
static const struct {
    double at[3]; /* along the axes of the view, in radii */
    int percent;
} lights[LIGHTS] = {{{-10, 10, 10}, 70}, {{10, 4, 10}, 40}};

static void light_position(const peers_scene *s, int light, double position[3]) {
    for (int c = 0; c < 3; c++) {
        position[c] = 0;
        for (int i = 0; i < 3; i++) position[c] += s->radius * lights[light].at[i] * s->axis[i][c];
    }
}

/* ---- the surface, moved ---- */

/* Every line of the cube along one axis is a polynomial; X becomes X + by, by repeated synthetic division. */
static void shift(double *cube, int degree, size_t stride, double by) {
    size_t side = (size_t)degree + 1, all = side * side * side;
    for (size_t from = 0; from < all; from++) {
        if (from / stride % side != 0) continue;
        for (int i = 0; i < degree; i++)
            for (int k = degree - 1; k >= i; k--)
                cube[from + (size_t)k * stride] += by * cube[from + (size_t)(k + 1) * stride];
    }
}

static void make_cube(peers_scene *s, const catalogue_entry *entry) {
    algsurf_surface *surface = rays_surface(entry);
    size_t side = (size_t)s->degree + 1, count;
    const size_t stride[3] = {side * side, side, 1};
    algsurf_term *term = rays_terms(surface, &count);
    s->cube = must_allocate(side * side * side, sizeof *s->cube);
    for (size_t n = 0; n < count; n++)
        s->cube[(size_t)term[n].i * stride[0] + (size_t)term[n].j * stride[1] + (size_t)term[n].k] =
            term[n].a;
    for (int i = 0; i < 3; i++)
        if (entry->extent.centre[i] != 0) shift(s->cube, s->degree, stride[i], entry->extent.centre[i]);
    free(term);
    algsurf_surface_free(surface);
}

static double entry_at(const peers_scene *s, int i, int j, int k) {
    return s->cube[(i * (s->degree + 1) + j) * (s->degree + 1) + k];
}

/* The terms that there are. */
static algsurf_term *make_terms(const peers_scene *s, size_t *count) {
    const int n = s->degree;
    algsurf_term *term = must_allocate((size_t)((n + 1) * (n + 1) * (n + 1)), sizeof *term);
    *count = 0;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++)
            for (int k = 0; k <= n; k++)
                if (entry_at(s, i, j, k) != 0)
                    term[(*count)++] = (algsurf_term){i, j, k, entry_at(s, i, j, k)};
    return term;
}

/* ---- this library's scene ---- */

static void make_scene(peers_scene *s) {
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {s->radius, 0, 0}};
    const algsurf_camera camera = rays_camera(&extent);
    algsurf_light light[LIGHTS] = {{.samples_u = 1, .samples_v = 1}, {.samples_u = 1, .samples_v = 1}};
    size_t count;
    algsurf_term *term = make_terms(s, &count);
    must(algsurf_surface_from_terms(term, count, &s->surface), s->name);
    free(term);
    for (int c = 0; c < 3; c++) {
        s->axis[0][c] = camera.right[c];
        s->axis[1][c] = camera.up[c];
        s->axis[2][c] = -camera.forward[c];
    }
    for (int i = 0; i < LIGHTS; i++) {
        light_position(s, i, light[i].position);
        for (int c = 0; c < 3; c++) light[i].colour[c] = lights[i].percent / 100.0;
    }
    s->scene = rays_scene(s->surface, &extent, &camera);
    must(algsurf_scene_set_lights(s->scene, light, LIGHTS), s->name);
    must(algsurf_scene_set_quality(s->scene, ALGSURF_QUALITY_STANDARD), s->name);
}

void peers_scene_open(peers_scene *s, const catalogue_entry *entry) {
    *s = (peers_scene){.name = entry->name, .degree = entry->degree, .radius = entry->extent.size[0]};
    make_cube(s, entry);
    make_scene(s);
}

void peers_scene_close(peers_scene *s) {
    algsurf_scene_free(s->scene);
    algsurf_surface_free(s->surface);
    free(s->cube);
}

/* ---- the others' ---- */

static void write_vector(FILE *file, const double *v, double times) {
    fprintf(file, "<%.17g,%.17g,%.17g>", times * v[0], times * v[1], times * v[2]);
}

void peers_write_povray(const peers_scene *s, int sturm, FILE *file) {
    const double half = HALF_HEIGHT * s->radius, distance = DISTANCE * s->radius;
    const char *between = "<";
    fprintf(file, "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 2 }\n"
                  "background { rgb <0,0,1> }\ncamera { perspective location ");
    write_vector(file, s->axis[2], distance);
    fprintf(file, " direction ");
    write_vector(file, s->axis[2], -distance);
    fprintf(file, " right ");
    write_vector(file, s->axis[0], 2 * half * PEERS_WIDTH / PEERS_HEIGHT);
    fprintf(file, " up ");
    write_vector(file, s->axis[1], 2 * half);
    fprintf(file, " }\n");
    for (int i = 0; i < LIGHTS; i++) {
        double position[3];
        light_position(s, i, position);
        fprintf(file, "light_source { ");
        write_vector(file, position, 1);
        fprintf(file, ", rgb %g shadowless }\n", lights[i].percent / 100.0);
    }
    fprintf(file, "poly { %d, ", s->degree);
    for (int i = s->degree; i >= 0; i--) /* all of them, in falling order */
        for (int j = s->degree - i; j >= 0; j--)
            for (int k = s->degree - i - j; k >= 0; k--) {
                fprintf(file, "%s%.17g", between, entry_at(s, i, j, k));
                between = ",\n ";
            }
    fprintf(file,
            "> %s\n clipped_by { sphere { 0, %.17g } } bounded_by { clipped_by }\n"
            " pigment { rgb <1,0.7,0.4> } finish { ambient 0.2 diffuse 0.8 } }\n",
            sturm ? "sturm" : "", s->radius);
}

void peers_write_surf(const peers_scene *s, int empty, const char *picture, FILE *file) {
    const double window = 2 * HALF_HEIGHT * s->radius / PEERS_HEIGHT; /* a pixel */
    const double sx = window * (PEERS_WIDTH - 1) * PEERS_HEIGHT / (20.0 * PEERS_WIDTH);
    const double sy = window * (PEERS_HEIGHT - 1) / 20.0, radius = s->radius / sy;
    const double(*e)[3] = s->axis;
    size_t count;
    algsurf_term *term = make_terms(s, &count);
    fprintf(file, "width=%d; height=%d;\n", PEERS_WIDTH, PEERS_HEIGHT);
    fprintf(file, "rot_x=%.17g; rot_y=%.17g; rot_z=%.17g;\n", asin(e[2][1]), atan2(e[2][0], e[2][2]),
            atan2(-e[0][1], e[1][1]));
    fprintf(file, "scale_x=%.17g; scale_y=%.17g; scale_z=%.17g;\n", sx, sy, sy);
    fprintf(file, "perspective=central; spec_z=%.17g;\n", DISTANCE * radius);
    fprintf(file, "clip=sphere; radius=%.17g; clip_front=%.17g; clip_back=%.17g;\n", empty ? 1e-9 : radius,
            radius, -radius);
    fprintf(file, "root_finder=bezier_all_roots; epsilon=0.0001; iterations=200;\n"
                  "background_red=0; background_green=0; background_blue=255;\n"
                  "surface_red=255; surface_green=178; surface_blue=102;\n"
                  "inside_red=255; inside_green=178; inside_blue=102;\n"
                  "ambient=20; diffuse=80; reflected=0; light3_vol=0; light8_vol=0;\n");
    for (int i = 0; i < LIGHTS; i++)
        fprintf(file, "light%d_x=%.17g; light%d_y=%.17g; light%d_z=%.17g; light%d_vol=%d;\n", i + 1,
                lights[i].at[0] * radius, i + 1, lights[i].at[1] * radius, i + 1, lights[i].at[2] * radius,
                i + 1, lights[i].percent);
    fprintf(file, "surface=");
    for (size_t n = 0; n < count; n++)
        fprintf(file, "%s(%.17g)*x^%d*y^%d*z^%d", n > 0 ? "+" : "", term[n].a, term[n].i, term[n].j,
                term[n].k);
    fprintf(file,
            ";\nclear_screen;\ndraw_surface;\ncolor_file_format=ppm;\nfilename=\"%s\";\n"
            "save_color_image;\n",
            picture);
    free(term);
}
