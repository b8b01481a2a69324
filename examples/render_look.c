/* render_look.c - see render_look.h. */
#include "render_look.h"

#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* The edge of the square light, in parts of its distance: shadows with soft ends. */
static const double EDGE = 0.45;
#define FARTHEST 1e100  /* coordinate of a light told by its place */
enum { DISTANCE = 16 }; /* of a light told by angles, in radii of what is shown */

void render_set_background(const cli_option *option, const char *value, void *field) {
    render_look *look = field;
    look->transparent = strcmp(value, "none") == 0 || strcmp(value, "transparent") == 0;
    if (!look->transparent) colour_set(option, value, &look->background);
}

void render_set_light(const cli_option *option, const char *value, void *field) {
    render_look *look = field;
    double *p = look->place;
    p[2] = 0;
    if (cli_numbers(value, ',', 3, p) && fmax(fmax(fabs(p[0]), fabs(p[1])), fabs(p[2])) <= FARTHEST) {
        look->light = LIGHT_POINT;
    } else if (cli_numbers(value, ':', 2, p) && fabs(p[0]) <= 180 && fabs(p[1]) <= 90) {
        look->light = LIGHT_ANGLES;
    } else {
        cli_expected(option, value);
    }
}

void render_set_lights(const cli_option *option, const char *value, void *field) {
    render_look *look = field;
    (void)value;
    look->paper = cli_choice(option, value);
    look->usual = !look->paper;
}

void render_look_follow(render_look *look, const jsurf_file *file) {
    if (!look->outside.given) {
        look->outside = file->front;
        if (!look->inside.given) look->inside = file->inside;
    }
    if (!look->background.given && !look->transparent) look->background = file->background;
    if (look->light != LIGHT_DEFAULT || look->paper || look->usual) return;
    for (int i = 0; i < JSURF_LIGHTS; i++)
        if (file->lights[i].on && file->lights[i].placed)
            look->file_lights[look->file_light_count++] = file->lights[i];
    if (look->file_light_count > 0) look->light = LIGHT_FILE;
}

void render_paint(const render_look *look, algsurf_material *material) {
    const css_colour *outside = &look->outside, *inside = look->inside.given ? &look->inside : outside;
    if (outside->given) colour_of(outside, material->outside);
    if (inside->given) colour_of(inside, material->inside);
}

static double length(const double v[3]) { return hypot(hypot(v[0], v[1]), v[2]); }

/* Of a ball that holds it. */
static double radius_of(const algsurf_extent *extent) {
    return extent->kind == ALGSURF_EXTENT_SPHERE ? extent->size[0] : length(extent->size);
}

/* The lights of Chuyeshov's pictures, as far as these tell: two squares of 5 x 5 points each, above on both
 * sides; in camera axes (right, up, towards the viewer), in radii of what is shown. */
static const struct {
    double place[3], brightness;
} paper_lights[2] = {{{-4.0, 5.0, 6.5}, 0.8}, {{5.0, 2.5, 5.5}, 0.45}};
static const double PAPER_EDGE = 1.2;
enum { PAPER_SAMPLES = 5 };

static void set_paper_lights(const algsurf_camera *camera, const algsurf_lighting *usual,
                             algsurf_light light[2]) {
    double radius = usual->radius;
    for (int l = 0; l < 2; l++) {
        const double *place = paper_lights[l].place;
        light[l] = (algsurf_light){.samples_u = PAPER_SAMPLES, .samples_v = PAPER_SAMPLES};
        for (int i = 0; i < 3; i++) {
            light[l].position[i] =
                usual->centre[i] + radius * (place[0] * camera->right[i] + place[1] * camera->up[i] -
                                             place[2] * camera->forward[i]);
            light[l].edge_u[i] = PAPER_EDGE * radius * camera->right[i];
            light[l].edge_v[i] = PAPER_EDGE * radius * camera->up[i];
            light[l].colour[i] = paper_lights[l].brightness;
        }
    }
}

/* The lights of a file of SURFER, points; they go with the camera. */
static algsurf_status set_file_lights(const render_look *look, const algsurf_camera *camera,
                                      const algsurf_extent *extent, algsurf_scene *scene) {
    algsurf_light lights[JSURF_LIGHTS];
    for (int l = 0; l < look->file_light_count; l++) {
        const jsurf_light *from = &look->file_lights[l];
        lights[l] = (algsurf_light){.samples_u = 1, .samples_v = 1};
        colour_of(&from->colour, lights[l].colour);
        for (int i = 0; i < 3; i++) {
            lights[l].colour[i] *= from->intensity;
            lights[l].position[i] =
                extent->centre[i] +
                radius_of(extent) * (from->place[0] * camera->right[i] + from->place[1] * camera->up[i] -
                                     from->place[2] * camera->forward[i]);
        }
    }
    return algsurf_scene_set_lights(scene, lights, (size_t)look->file_light_count);
}

/* Where the light is, and one it would be asked for once more is the same: angles go with the camera. */
static void find_light(const render_look *look, const algsurf_camera *camera, const algsurf_extent *extent,
                       double position[3]) {
    if (look->light == LIGHT_POINT) {
        memcpy(position, look->place, sizeof look->place);
        return;
    }
    double right = look->place[0] * PI / 180, above = look->place[1] * PI / 180;
    double radius = radius_of(extent);
    for (int i = 0; i < 3; i++)
        position[i] = extent->centre[i] +
                      DISTANCE * radius *
                          (cos(above) * (sin(right) * camera->right[i] - cos(right) * camera->forward[i]) +
                           sin(above) * camera->up[i]);
}

/* Two edges across the way from the light to the centre of what is shown. */
static void spread(algsurf_light *light, const double centre[3], const double up[3]) {
    double way[3], u[3], far;
    for (int i = 0; i < 3; i++) way[i] = centre[i] - light->position[i];
    far = length(way);
    for (int i = 0; i < 3; i++)
        u[i] = way[(i + 1) % 3] * up[(i + 2) % 3] - way[(i + 2) % 3] * up[(i + 1) % 3];
    if (!(far > 0) || !(length(u) > 1e-6 * far)) { /* at the centre, or right above: any direction across */
        int least = fabs(way[0]) <= fabs(way[1]) ? (fabs(way[0]) <= fabs(way[2]) ? 0 : 2)
                                                 : (fabs(way[1]) <= fabs(way[2]) ? 1 : 2);
        double axis[3] = {least == 0, least == 1, least == 2};
        for (int i = 0; i < 3; i++)
            u[i] = way[(i + 1) % 3] * axis[(i + 2) % 3] - way[(i + 2) % 3] * axis[(i + 1) % 3];
    }
    double across = length(u);
    for (int i = 0; i < 3 && across > 0; i++) {
        light->edge_u[i] = EDGE * far * u[i] / across;
        light->edge_v[i] =
            EDGE * (u[(i + 1) % 3] * way[(i + 2) % 3] - u[(i + 2) % 3] * way[(i + 1) % 3]) / across;
    }
}

algsurf_status render_light_scene(const render_look *look, const algsurf_camera *camera,
                                  const algsurf_extent *extent, algsurf_scene *scene) {
    double rgb[3];
    colour_of(&look->background, rgb);
    algsurf_status status = ALGSURF_OK;
    if (look->transparent || look->background.given)
        status = algsurf_scene_set_background(scene, look->transparent ? NULL : rgb);
    if (status != ALGSURF_OK || (look->light == LIGHT_DEFAULT && !look->paper)) return status;
    if (look->paper) {
        algsurf_light lights[ALGSURF_MAX_LIGHTS];
        algsurf_lighting usual = {.size = sizeof usual};
        status = algsurf_scene_get_lighting(scene, lights, &usual);
        if (status != ALGSURF_OK) return status;
        set_paper_lights(camera, &usual, lights);
        return algsurf_scene_set_lights(scene, lights, 2);
    }
    if (look->light == LIGHT_FILE) return set_file_lights(look, camera, extent, scene);
    algsurf_light light = {.colour = {1, 1, 1}};
    find_light(look, camera, extent, light.position);
    spread(&light, extent->centre, camera->up);
    return algsurf_scene_set_lights(scene, &light, 1);
}
