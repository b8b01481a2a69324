/* picture.c - pictures as the program render draws them: ../fit.c chooses what of the view is not given. */
#include <math.h>

#include "fit.h"
#include "module.h"

/* What render is told, in doubles; NaN where nothing is said. */
typedef struct look {
    double eye[3], look_at[3], up[3];
    double fov, orthographic, zoom, turn[2];
    double outside[3], inside[3], background[3]; /* sRGB, 0 to 255 */
    double quality, antialias, thin;
} look;

static cli_vector vector_of(const double x[3]) { return (cli_vector){{x[0], x[1], x[2]}, !isnan(x[0])}; }

static view_options view_of(const look *l, const algsurf_extent *extent, int width, int height) {
    view_options v = {.width = width,
                      .height = height,
                      .eye = vector_of(l->eye),
                      .look_at = vector_of(l->look_at),
                      .up = vector_of(l->up),
                      .fov = isnan(l->fov) ? 0 : l->fov,
                      .orthographic = isnan(l->orthographic) ? 0 : l->orthographic,
                      .zoom = l->zoom,
                      .turn = {l->turn[0], l->turn[1]}};
    if (!extent) return v;
    v.extent = (cli_extent){*extent, 1};
    v.centre = vector_of(extent->centre);
    return v;
}

/* In linear light.  0: not given, the colour stays. */
static int colour_from(const double srgb[3], double colour[3]) {
    if (isnan(srgb[0])) return 0;
    const unsigned char bytes[3] = {(unsigned char)srgb[0], (unsigned char)srgb[1], (unsigned char)srgb[2]};
    return algsurf_srgb_decode(bytes, colour) == ALGSURF_OK;
}

/* Keeps the first status that is not OK. */
static void keep(int *failed, int status) { *failed = *failed == ALGSURF_OK ? status : *failed; }

static void set_colours(const look *l, algsurf_scene *scene, int *failed) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    double background[3];
    keep(failed, algsurf_scene_get_lighting(scene, lights, &lighting));
    if (*failed != ALGSURF_OK) return;
    algsurf_material material = *lighting.material;
    if (colour_from(l->outside, material.outside))
        memcpy(material.inside, material.outside, sizeof material.inside);
    (void)colour_from(l->inside, material.inside);
    keep(failed, algsurf_scene_set_material(scene, &material));
    if (colour_from(l->background, background)) keep(failed, algsurf_scene_set_background(scene, background));
    keep(failed, algsurf_scene_set_thin(scene, l->thin != 0 ? material.outside : NULL));
}

static int draw(const taken *t, algsurf_render_options *options, unsigned char *pixels) {
    const look *l = t->buffer[0].buf;
    const view_options asked = view_of(l, t->space, options->width, options->height);
    const algsurf_picture picture = {.size = sizeof picture, .pixels = pixels};
    fit_choice choice;
    view v;
    algsurf_camera camera;
    algsurf_scene *scene = NULL;
    int failed = fit_choose(&v, &asked, t->surface, 0, l->thin != 0, &choice);
    if (failed == ALGSURF_OK) failed = view_make_camera(&v, 0, 1, &camera);
    keep(&failed, algsurf_scene_create(t->surface, &scene));
    if (failed == ALGSURF_OK) {
        keep(&failed, algsurf_scene_set_extent(scene, &v.extent));
        keep(&failed, algsurf_scene_set_camera(scene, &camera));
        keep(&failed, algsurf_scene_set_quality(scene, (algsurf_quality)l->quality));
        keep(&failed, algsurf_scene_set_antialias(scene, (int)l->antialias));
        keep(&failed, algsurf_scene_set_antialias_threshold(scene, VIEW_THRESHOLD));
        set_colours(l, scene, &failed);
    }
    if (failed == ALGSURF_OK) failed = algsurf_render(scene, options, &picture, NULL);
    algsurf_scene_free(scene);
    return failed;
}

/* render(surface, extent, look, width, height, threads, pixels) */
static PyObject *render(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    patience waiting = {NULL, {0, 0}};
    if (!take(args, n, "seriiiw", &t)) return NULL;
    if (!holds(&t, 0, 1, sizeof(look)) || !holds(&t, 1, t.whole[0] * t.whole[1], 3))
        return give_back(&t, NULL);
    algsurf_render_options options = {.size = sizeof options,
                                      .width = (int)t.whole[0],
                                      .height = (int)t.whole[1],
                                      .threads = (int)t.whole[2],
                                      .progress = is_interrupted,
                                      .progress_data = &waiting};
    waiting.thread = PyEval_SaveThread();
    const int status = draw(&t, &options, t.buffer[1].buf);
    PyEval_RestoreThread(waiting.thread);
    give_back(&t, NULL);
    if (PyErr_Occurred()) return NULL; /* Ctrl-C */
    return status == ALGSURF_OK ? refused_at(0, ALGSURF_OK) : refuse(status);
}

PyMethodDef picture_methods[] = {METHOD(render), METHODS_END};
