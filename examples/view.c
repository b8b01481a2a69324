/* view.c - see view.h.
 *
 * The default eye stands at a distance that brings the ball about the extent into the field of view:
 * distance = radius / sin(fov/2), and farther in proportion for a picture that is higher than wide.
 * --fov then magnifies, and does not move the eye.
 */
#include "view.h"

#include <math.h>
#include <string.h>

/* ---- options ---- */

static const double PI = 3.14159265358979323846;

enum { WIDTH = 1024, HEIGHT = 768 }; /* unless --size says otherwise */
enum { LARGEST = 65535 };            /* width, height: algsurf_render_options */

void view_set_size(const cli_option *option, const char *value, void *field) {
    view_options *options = field;
    char text[16];
    size_t cut = strcspn(value, "xX");
    if (value[cut] && cut < sizeof text) {
        memcpy(text, value, cut);
        text[cut] = '\0';
        if (cli_whole(text, 1, LARGEST, &options->width) &&
            cli_whole(value + cut + 1, 1, LARGEST, &options->height))
            return;
    }
    cli_fail(CLI_BAD_INPUT, "%s: expected WxH, as 800x600, each from 1 to %d, got '%s'", option->name,
             LARGEST, cli_quote(value).text);
}

void view_set_fov(const cli_option *option, const char *value, void *field) {
    double fov;
    if (!cli_numbers(value, ',', 1, &fov) || !(fov > 0 && fov < 180))
        cli_fail(CLI_BAD_INPUT, "%s: expected degrees above 0 and below 180, got '%s'", option->name,
                 cli_quote(value).text);
    *(double *)field = fov;
}

void view_set_orthographic(const cli_option *option, const char *value, void *field) {
    double height;
    if (!cli_numbers(value, ',', 1, &height) || !(height > 0))
        cli_fail(CLI_BAD_INPUT, "%s: expected a number above 0, got '%s'", option->name,
                 cli_quote(value).text);
    *(double *)field = height;
}

void view_set_zoom(const cli_option *option, const char *value, void *field) {
    double zoom;
    if (!cli_numbers(value, ',', 1, &zoom) || !(zoom >= 1e-6 && zoom <= 1e6))
        cli_fail(CLI_BAD_INPUT, "%s: expected a number above 0, up to a million, got '%s'", option->name,
                 cli_quote(value).text);
    *(double *)field = zoom;
}

void view_set_turn(const cli_option *option, const char *value, void *field) {
    double angle[2];
    if (!cli_numbers(value, ',', 2, angle) || !(fabs(angle[0]) <= 3600 && fabs(angle[1]) <= 180))
        cli_fail(CLI_BAD_INPUT, "%s: expected degrees AZ,EL, EL from -180 to 180, got '%s'", option->name,
                 cli_quote(value).text);
    memcpy(field, angle, sizeof angle);
}

void view_check(view_options *options) {
    if (options->width == 0) {
        options->width = WIDTH;
        options->height = HEIGHT;
    }
    if (options->fov > 0 && options->orthographic > 0)
        cli_fail(CLI_BAD_INPUT, "--orthographic: has no field of view; leave --fov out");
}

/* A camera asked for by any option is no longer the file's. */
void view_follow(view_options *options, const jsurf_file *file) {
    double distance = file->perspective ? 1 / sin(file->fov / 2 * PI / 180) : 2; /* in radii */
    int own_extent = options->extent.given || options->centre.given;
    int own_camera =
        options->eye.given || options->look_at.given || options->fov > 0 || options->orthographic > 0;
    if (!own_extent) {
        options->extent.given = 1;
        options->extent.extent = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {file->radius, 0, 0}};
        options->centre = (cli_vector){{0, 0, 0}, 1};
    }
    if (own_extent || own_camera) return;
    for (int i = 0; i < 3; i++) options->eye.x[i] = distance * file->radius * file->back[i];
    options->eye.given = 1;
    options->look_at = (cli_vector){{0, 0, 0}, 1};
    if (!options->up.given) {
        memcpy(options->up.x, file->up, sizeof file->up);
        options->up.given = 1;
    }
    if (file->perspective)
        options->fov = file->fov;
    else
        options->orthographic = file->height * file->radius;
}

/* ---- view and camera ---- */

static const double DEFAULT_EXTENT = 3, DEFAULT_FOV = 25;
static const double MARGIN = 1.04; /* of the distance, so that the extent does not touch the frame */
static const double DEFAULT_DIRECTION[3] = {0.55, -0.72, 0.43}; /* from the centre to the eye */

static double length(const double v[3]) { return hypot(hypot(v[0], v[1]), v[2]); }

static double extent_radius(const algsurf_extent *extent) {
    return extent->kind == ALGSURF_EXTENT_SPHERE ? extent->size[0] : length(extent->size);
}

static algsurf_extent choose_extent(const view_options *options, const catalogue_entry *entry) {
    algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {DEFAULT_EXTENT, 0, 0}};
    if (entry) extent = entry->extent;
    if (options->extent.given) {
        extent.kind = options->extent.extent.kind;
        memcpy(extent.size, options->extent.extent.size, sizeof extent.size);
    }
    if (options->centre.given) memcpy(extent.centre, options->centre.x, sizeof extent.centre);
    return extent;
}

/* The catalogue's camera, when nothing moves or resizes what it was made for. */
static void stand_as_catalogued(view *v, const catalogue_entry *entry) {
    memcpy(v->look_at, entry->look_at, sizeof v->look_at);
    memcpy(v->eye, entry->eye, sizeof v->eye);
}

static void stand_off_extent(view *v, const catalogue_entry *entry) {
    double direction[3];
    for (int i = 0; i < 3; i++)
        direction[i] = entry ? entry->eye[i] - entry->look_at[i] : DEFAULT_DIRECTION[i];
    double fov = entry ? entry->fov : DEFAULT_FOV;
    double distance = MARGIN * extent_radius(&v->extent) / sin(fov / 2 * PI / 180);
    for (int i = 0; i < 3; i++) {
        v->look_at[i] = v->extent.centre[i];
        v->eye[i] = v->look_at[i] + distance * direction[i] / length(direction);
    }
}

static void step_back(view *v, const view_options *options) {
    if (options->width >= options->height) return;
    double times = (double)options->height / options->width;
    for (int i = 0; i < 3; i++) v->eye[i] = v->look_at[i] + times * (v->eye[i] - v->look_at[i]);
}

/* z, or y for a camera that looks along z. */
static void choose_up(view *v) {
    double d[3] = {v->look_at[0] - v->eye[0], v->look_at[1] - v->eye[1], v->look_at[2] - v->eye[2]};
    int along_z = hypot(d[0], d[1]) <= 1e-6 * fabs(d[2]);
    v->up[0] = 0;
    v->up[1] = along_z;
    v->up[2] = !along_z;
}

/* Rodrigues' formula: v turned by an angle about an axis. */
static void turn(double v[3], const double axis[3], double angle) {
    double a[3], size = length(axis), c = cos(angle), s = sin(angle);
    for (int i = 0; i < 3; i++) a[i] = axis[i] / size;
    double cross[3] = {a[1] * v[2] - a[2] * v[1], a[2] * v[0] - a[0] * v[2], a[0] * v[1] - a[1] * v[0]};
    double along = a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
    for (int i = 0; i < 3; i++) v[i] = c * v[i] + s * cross[i] + (1 - c) * along * a[i];
}

/* Eye and upward direction turned about an axis through the point looked at. */
static void turn_eye(view *v, const double axis[3], double angle) {
    for (int i = 0; i < 3; i++) v->eye[i] -= v->look_at[i];
    turn(v->eye, axis, angle);
    turn(v->up, axis, angle);
    for (int i = 0; i < 3; i++) v->eye[i] += v->look_at[i];
}

/* To the right about the upward axis, then upwards about the axis that points to the right. */
static void turn_view(view *v, const double degrees[2]) {
    double d[3], right[3];
    if (degrees[0] != 0) turn_eye(v, v->axis, degrees[0] * PI / 180);
    for (int i = 0; i < 3; i++) d[i] = v->look_at[i] - v->eye[i];
    for (int i = 0; i < 3; i++)
        right[i] = d[(i + 1) % 3] * v->up[(i + 2) % 3] - d[(i + 2) % 3] * v->up[(i + 1) % 3];
    if (degrees[1] != 0 && length(right) > 0) turn_eye(v, right, -degrees[1] * PI / 180);
}

void view_zoom(view *v, double times) {
    if (!(times > 0)) return;
    v->fov = atan(tan(v->fov / 2 * PI / 180) / times) * 2 * 180 / PI;
    v->orthographic /= times;
}

view view_make(const view_options *options, const catalogue_entry *entry) {
    view v = {.extent = choose_extent(options, entry)};
    if (entry && !options->extent.given && !options->centre.given)
        stand_as_catalogued(&v, entry);
    else
        stand_off_extent(&v, entry);
    step_back(&v, options);
    if (options->eye.given) memcpy(v.eye, options->eye.x, sizeof v.eye);
    if (options->look_at.given) memcpy(v.look_at, options->look_at.x, sizeof v.look_at);
    if (options->up.given)
        memcpy(v.up, options->up.x, sizeof v.up);
    else if (entry && !options->eye.given && !options->look_at.given)
        memcpy(v.up, entry->up, sizeof v.up);
    else
        choose_up(&v);
    v.fov = options->fov > 0 ? options->fov : entry ? entry->fov : DEFAULT_FOV;
    v.orthographic = options->orthographic;
    memcpy(v.axis, v.up, sizeof v.axis);
    turn_view(&v, options->turn);
    view_zoom(&v, options->zoom);
    return v;
}

algsurf_status view_make_camera(const view *v, int picture, int pictures, algsurf_camera *camera) {
    view seen = *v;
    if (picture > 0) turn_eye(&seen, v->axis, 2 * PI * picture / pictures);
    return v->orthographic > 0
               ? algsurf_camera_orthographic(seen.eye, v->look_at, seen.up, v->orthographic, camera)
               : algsurf_camera_pinhole(seen.eye, v->look_at, seen.up, v->fov, camera);
}

algsurf_camera view_camera(const view *v, int picture, int pictures) {
    algsurf_camera camera;
    algsurf_status status = view_make_camera(v, picture, pictures, &camera);
    if (status == ALGSURF_E_ARGUMENT)
        cli_fail(CLI_BAD_INPUT, "--eye, --look-at, --up: the eye must not be the point looked at, nor up "
                                "point along the view");
    if (status != ALGSURF_OK)
        cli_fail(CLI_BAD_INPUT, "--eye, --look-at, --up: %s", algsurf_status_text(status));
    return camera;
}

algsurf_material view_material(const algsurf_scene *scene, const catalogue_entry *entry) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    if (algsurf_scene_get_lighting(scene, lights, &lighting) != ALGSURF_OK)
        cli_fail(CLI_BROKEN, "a scene without lighting");
    algsurf_material material = *lighting.material;
    if (entry) {
        memcpy(material.outside, entry->outside, sizeof material.outside);
        memcpy(material.inside, entry->inside, sizeof material.inside);
    }
    return material;
}
