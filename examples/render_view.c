/* render_view.c - see render_view.h.
 *
 * The default eye stands at a distance that brings the ball about the extent into the field of view:
 * distance = radius / sin(fov/2), and farther in proportion for a picture that is higher than wide.
 * --fov then magnifies, and does not move the eye.
 */
#include "render_view.h"

#include <math.h>
#include <string.h>

static const double DEFAULT_EXTENT = 3, DEFAULT_FOV = 30;
static const double MARGIN = 1.04; /* of the distance, so that the extent does not touch the frame */
static const double DEFAULT_DIRECTION[3] = {0.55, -0.72, 0.43}; /* from the centre to the eye */

static const double PI = 3.14159265358979323846;

static double length(const double v[3]) { return hypot(hypot(v[0], v[1]), v[2]); }

static double extent_radius(const algsurf_extent *extent) {
    return extent->kind == ALGSURF_EXTENT_SPHERE ? extent->size[0] : length(extent->size);
}

static algsurf_extent choose_extent(const render_options *options, const catalogue_entry *entry) {
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
static void stand_as_catalogued(render_view *view, const catalogue_entry *entry) {
    memcpy(view->look_at, entry->look_at, sizeof view->look_at);
    memcpy(view->eye, entry->eye, sizeof view->eye);
}

static void stand_off_extent(render_view *view, const catalogue_entry *entry) {
    double direction[3];
    for (int i = 0; i < 3; i++)
        direction[i] = entry ? entry->eye[i] - entry->look_at[i] : DEFAULT_DIRECTION[i];
    double fov = entry ? entry->fov : DEFAULT_FOV;
    double distance = MARGIN * extent_radius(&view->extent) / sin(fov / 2 * PI / 180);
    for (int i = 0; i < 3; i++) {
        view->look_at[i] = view->extent.centre[i];
        view->eye[i] = view->look_at[i] + distance * direction[i] / length(direction);
    }
}

static void step_back(render_view *view, const render_options *options) {
    if (options->width >= options->height) return;
    double times = (double)options->height / options->width;
    for (int i = 0; i < 3; i++) view->eye[i] = view->look_at[i] + times * (view->eye[i] - view->look_at[i]);
}

/* z, or y for a camera that looks along z. */
static void choose_up(render_view *view) {
    double d[3] = {view->look_at[0] - view->eye[0], view->look_at[1] - view->eye[1],
                   view->look_at[2] - view->eye[2]};
    int along_z = hypot(d[0], d[1]) <= 1e-6 * fabs(d[2]);
    view->up[0] = 0;
    view->up[1] = along_z;
    view->up[2] = !along_z;
}

render_view render_make_view(const render_options *options, const catalogue_entry *entry) {
    render_view view = {.extent = choose_extent(options, entry)};
    if (entry && !options->extent.given && !options->centre.given)
        stand_as_catalogued(&view, entry);
    else
        stand_off_extent(&view, entry);
    step_back(&view, options);
    if (options->eye.given) memcpy(view.eye, options->eye.x, sizeof view.eye);
    if (options->look_at.given) memcpy(view.look_at, options->look_at.x, sizeof view.look_at);
    if (options->up.given)
        memcpy(view.up, options->up.x, sizeof view.up);
    else
        choose_up(&view);
    view.fov = options->fov > 0 ? options->fov : entry ? entry->fov : DEFAULT_FOV;
    view.orthographic = options->orthographic;
    return view;
}

/* Rodrigues' formula: v turned by an angle about an axis. */
static void turn(double v[3], const double axis[3], double angle) {
    double a[3], size = length(axis), c = cos(angle), s = sin(angle);
    for (int i = 0; i < 3; i++) a[i] = axis[i] / size;
    double cross[3] = {a[1] * v[2] - a[2] * v[1], a[2] * v[0] - a[0] * v[2], a[0] * v[1] - a[1] * v[0]};
    double along = a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
    for (int i = 0; i < 3; i++) v[i] = c * v[i] + s * cross[i] + (1 - c) * along * a[i];
}

algsurf_camera render_make_camera(const render_view *view, int picture, int pictures) {
    algsurf_camera camera;
    double eye[3];
    memcpy(eye, view->eye, sizeof eye);
    if (picture > 0) {
        for (int i = 0; i < 3; i++) eye[i] -= view->look_at[i];
        turn(eye, view->up, 2 * PI * picture / pictures);
        for (int i = 0; i < 3; i++) eye[i] += view->look_at[i];
    }
    algsurf_status status =
        view->orthographic > 0
            ? algsurf_camera_orthographic(&camera, eye, view->look_at, view->up, view->orthographic)
            : algsurf_camera_pinhole(&camera, eye, view->look_at, view->up, view->fov);
    if (status == ALGSURF_E_ARGUMENT)
        cli_fail(CLI_BAD_INPUT, "--eye, --look-at, --up: the eye must be off the point looked at, and up "
                                "not along the view");
    if (status != ALGSURF_OK)
        cli_fail(CLI_BAD_INPUT, "--eye, --look-at, --up: %s", algsurf_status_text(status));
    return camera;
}
