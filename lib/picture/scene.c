/* scene.c - a scene: its defaults, its setters, its lights. */
#include "../base/arithmetic.h"
#include "scene_impl.h"

#include <stdlib.h>

#include "../base/fpenv.h"
#include "../rays/intersect_impl.h"
#include "../base/options.h"
#include "colours.h"
#include "../base/vec.h"

static const algsurf_material default_material = {
    .size = sizeof(algsurf_material),
    .outside = {0.14, 0.46, 1.0},
    .inside = {0.92, 0.36, 0.06},
    .diffuse = 0.72,
    .ambient = 0.135,
    .fill = 0.135,
    .specular = 0.32,
    .roughness = 0.2,
    .haze = 0.2,
};

/* The default light, in camera axes (right, up, towards the viewer): a square that faces the centre of what
 * is shown, 16 radii away from it, above left and on the viewer's side.  Its edges are 0.45 of the way. */
static const double light_place[3] = {-0.45, 0.50, 0.74};
static const double light_edges[2][3] = {{0.893, 0.252, 0.373}, {0, 0.829, -0.560}};
#define LIGHT_DISTANCE 16
#define LIGHT_EDGE 0.45

algsurf_status algsurf_scene_create(const algsurf_surface *surface, algsurf_scene **scene) {
    static const double eye[3] = {4, 3, 2.5}, look_at[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    if (!surface || !scene) return ALGSURF_E_ARGUMENT;
    algsurf_scene *made = calloc(1, sizeof *made);
    if (!made) return ALGSURF_E_NO_MEMORY;
    made->given = surface;
    made->surface = algsurf_i_surface_solved(surface);
    made->extent.kind = ALGSURF_EXTENT_ALL;
    (void)algsurf_camera_pinhole(eye, look_at, up, 30, &made->camera);
    made->material = default_material;
    made->light_count = -1;
    for (int i = 0; i < 3; i++) made->background[i] = 1;
    made->quality = ALGSURF_QUALITY_STANDARD;
    made->antialias = 1;
    made->intersect.size = sizeof made->intersect;
    made->coherence = ALGSURF_COHERENCE_NEIGHBOURS;
    *scene = made;
    return ALGSURF_OK;
}

void algsurf_scene_free(algsurf_scene *scene) { free(scene); }

ALGSURF_I_ENTRY(algsurf_status, scene_set_extent, (algsurf_scene * scene, const algsurf_extent *extent),
                (scene, extent)) {
    static const algsurf_extent all_of_space = {.kind = ALGSURF_EXTENT_ALL};
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_extent_check(extent);
    if (status == ALGSURF_OK) scene->extent = extent ? *extent : all_of_space;
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_camera, (algsurf_scene * scene, const algsurf_camera *camera),
                (scene, camera)) {
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_camera_check(camera);
    if (status == ALGSURF_OK) scene->camera = *camera;
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_material, (algsurf_scene * scene, const algsurf_material *material),
                (scene, material)) {
    algsurf_material known;
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_material_read(material, &known);
    if (status == ALGSURF_OK) scene->material = known;
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_lights,
                (algsurf_scene * scene, const algsurf_light *lights, size_t count), (scene, lights, count)) {
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_lights_check(lights, count);
    if (status != ALGSURF_OK) return status;
    for (size_t l = 0; l < count; l++) scene->lights[l] = lights[l];
    scene->light_count = (int)count;
    return ALGSURF_OK;
}

/* A copy of a colour, black for null. */
static algsurf_status copy_colour(const double colour[3], double copy[3]) {
    algsurf_status status = colour ? algsurf_i_colour_check(colour) : ALGSURF_OK;
    for (int i = 0; i < 3 && status == ALGSURF_OK; i++) copy[i] = colour ? colour[i] : 0;
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_background, (algsurf_scene * scene, const double colour[3]),
                (scene, colour)) {
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = copy_colour(colour, scene->background);
    if (status == ALGSURF_OK) scene->transparent = !colour;
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_thin, (algsurf_scene * scene, const double colour[3]),
                (scene, colour)) {
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = copy_colour(colour, scene->thin_colour);
    if (status == ALGSURF_OK) scene->thin = colour != NULL;
    return status;
}

algsurf_status algsurf_scene_set_quality(algsurf_scene *scene, algsurf_quality quality) {
    if (!scene || (quality != ALGSURF_QUALITY_PREVIEW && quality != ALGSURF_QUALITY_STANDARD &&
                   quality != ALGSURF_QUALITY_FULL))
        return ALGSURF_E_ARGUMENT;
    scene->quality = quality;
    return ALGSURF_OK;
}

algsurf_status algsurf_scene_set_antialias(algsurf_scene *scene, int n) {
    if (!scene || n < 1 || n > 16) return ALGSURF_E_ARGUMENT;
    scene->antialias = n;
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_antialias_threshold, (algsurf_scene * scene, double threshold),
                (scene, threshold)) {
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_number(threshold, threshold >= 0 && threshold <= 1);
    if (status == ALGSURF_OK) scene->antialias_threshold = threshold;
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_intersect_options,
                (algsurf_scene * scene, const algsurf_intersect_options *options), (scene, options)) {
    algsurf_intersect_options o;
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_intersect_read_options(options, &o);
    if (status == ALGSURF_OK && (o.observer || o.side || o.planes || o.plane_count))
        status = ALGSURF_E_ARGUMENT;
    if (status != ALGSURF_OK) return status;
    o.planes = scene->intersect.planes;
    o.plane_count = scene->intersect.plane_count;
    scene->intersect = o;
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, scene_set_clip,
                (algsurf_scene * scene, const algsurf_plane *planes, size_t count), (scene, planes, count)) {
    if (!scene) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_planes_check(planes, count);
    if (status != ALGSURF_OK) return status;
    for (size_t i = 0; i < count; i++) scene->planes[i] = planes[i];
    scene->intersect.planes = scene->planes;
    scene->intersect.plane_count = count;
    return ALGSURF_OK;
}

/* The checks are those of the function that will get it, made on a ray without points.  Only imaginary parts
 * that play a part are taken. */
ALGSURF_I_ENTRY(algsurf_status, scene_set_complex_space,
                (algsurf_scene * scene, const algsurf_complex_space *space), (scene, space)) {
    const algsurf_ray nothing = {{0, 0, 0}, {1, 0, 0}, 1, 0};
    algsurf_hit miss;
    if (!scene) return ALGSURF_E_ARGUMENT;
    if (space) {
        algsurf_status status =
            algsurf_intersect_complex(scene->given, NULL, &nothing, space, NULL, NULL, &miss, NULL);
        if (status != ALGSURF_OK) return status;
        (void)algsurf_options_read(&scene->space, sizeof scene->space, space);
        const int top = algsurf_i_top_imaginary(&scene->space, scene->given->degree);
        for (int k = 0; k <= top; k++) scene->imaginary[k] = scene->space.imaginary[k];
        scene->space.imaginary = scene->imaginary;
        scene->space.imaginary_count = (size_t)(top + 1);
    }
    scene->complex = space != NULL;
    scene->surface = space ? scene->given : algsurf_i_surface_solved(scene->given);
    return ALGSURF_OK;
}

algsurf_status algsurf_scene_set_coherence(algsurf_scene *scene, algsurf_coherence coherence) {
    if (!scene || (coherence != ALGSURF_COHERENCE_NONE && coherence != ALGSURF_COHERENCE_NEIGHBOURS))
        return ALGSURF_E_ARGUMENT;
    scene->coherence = coherence;
    return ALGSURF_OK;
}

/* A ball about what is shown: the extent's own; for all of space the one about the origin that fills the
 * height of the picture. */
static void set_ball(const algsurf_scene *scene, double centre[3], double *radius) {
    const algsurf_extent *extent = &scene->extent;
    const algsurf_camera *camera = &scene->camera;
    for (int i = 0; i < 3; i++) centre[i] = extent->kind == ALGSURF_EXTENT_ALL ? 0 : extent->centre[i];
    if (extent->kind == ALGSURF_EXTENT_SPHERE)
        *radius = extent->size[0];
    else if (extent->kind == ALGSURF_EXTENT_BOX)
        *radius = algsurf_length(extent->size);
    else if (algsurf_i_is_orthographic(camera))
        *radius = camera->half_height;
    else
        *radius = algsurf_length(camera->eye) * camera->half_height;
    if (!(*radius > 0) || !isfinite(*radius)) *radius = 1; /* an eye at the origin */
}

/* Component i of a vector in camera axes. */
static double in_space(const algsurf_camera *camera, const double v[3], int i) {
    return v[0] * camera->right[i] + v[1] * camera->up[i] - v[2] * camera->forward[i];
}

static void default_light(const algsurf_camera *camera, const double centre[3], double radius,
                          algsurf_light *light) {
    double far = LIGHT_DISTANCE * radius, wide = LIGHT_EDGE * far;
    *light = (algsurf_light){.kind = ALGSURF_LIGHT_AREA};
    for (int i = 0; i < 3; i++) {
        light->position[i] = centre[i] + far * in_space(camera, light_place, i);
        light->edge_u[i] = wide * in_space(camera, light_edges[0], i);
        light->edge_v[i] = wide * in_space(camera, light_edges[1], i);
        light->colour[i] = 1;
    }
}

void algsurf_i_scene_lighting(const algsurf_scene *scene, algsurf_light lights[ALGSURF_MAX_LIGHTS],
                              algsurf_lighting *lighting) {
    *lighting = (algsurf_lighting){.size = sizeof *lighting,
                                   .material = &scene->material,
                                   .lights = lights,
                                   .light_count = scene->light_count < 0 ? 1 : (size_t)scene->light_count,
                                   .bounded = scene->extent.kind != ALGSURF_EXTENT_ALL};
    for (int i = 0; i < 3; i++) {
        lighting->up[i] = scene->camera.up[i];
        lighting->forward[i] = scene->camera.forward[i];
    }
    set_ball(scene, lighting->centre, &lighting->radius);
    for (int l = 0; l < scene->light_count; l++) lights[l] = scene->lights[l];
    if (scene->light_count < 0) default_light(&scene->camera, lighting->centre, lighting->radius, lights);
}

ALGSURF_I_ENTRY(algsurf_status, scene_get_lighting,
                (const algsurf_scene *scene, algsurf_light lights[ALGSURF_MAX_LIGHTS],
                 algsurf_lighting *lighting),
                (scene, lights, lighting)) {
    algsurf_lighting ours;
    if (!scene || !lights || !lighting) return ALGSURF_E_ARGUMENT;
    if (!algsurf_options_fit(lighting, sizeof ours)) return ALGSURF_E_SIZE;
    algsurf_i_scene_lighting(scene, lights, &ours);
    algsurf_options_write(lighting, &ours, sizeof ours);
    return ALGSURF_OK;
}
