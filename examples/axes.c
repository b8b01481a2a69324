/* axes.c - see axes.h.
 *
 * A side of the box faces away from the eye if its plane does not part the two; an edge is drawn if one of
 * its two sides faces away, and belongs to the outline if the other does not.  What is shown lies inside the
 * outline, so that numbers outside of it hide nothing.
 */
#include "axes_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST_LETTER = 7, LETTERS = 40 };

static const char *const axis_names[] = {"x", "y", "z"};

double axes_letter(double width, double height) { return fmax(LEAST_LETTER, fmin(width, height) / LETTERS); }

/* ---- the box ---- */

/* Does the lower (side 0) or upper side across an axis face away from the eye? */
static int faces_away(const axes_drawing *d, int axis, int side) {
    const algsurf_camera *c = &d->scene->camera;
    if (d->s.pixel > 0) return side ? c->eye[axis] <= d->hi[axis] : c->eye[axis] >= d->lo[axis];
    return side ? c->forward[axis] >= -1e-9 : c->forward[axis] <= 1e-9;
}

static axes_edge edge_of(const axes_drawing *d, int axis, int j, int k) {
    int axis_j = (axis + 1) % 3, axis_k = (axis + 2) % 3;
    axes_edge e = {.axis = axis};
    e.from[axis] = d->lo[axis];
    e.to[axis] = d->hi[axis];
    e.from[axis_j] = e.to[axis_j] = j ? d->hi[axis_j] : d->lo[axis_j];
    e.from[axis_k] = e.to[axis_k] = k ? d->hi[axis_k] : d->lo[axis_k];
    return e;
}

/* Across an edge in the picture, away from the box's middle. */
static void outward(const axes_drawing *d, const axes_edge *e, double direction[2]) {
    double middle[3];
    for (int i = 0; i < 3; i++) middle[i] = 0.5 * (d->lo[i] + d->hi[i]);
    stroke_point a = axes_seen(d, e->from), b = axes_seen(d, e->to), m = axes_seen(d, middle);
    double x = a.y - b.y, y = b.x - a.x, length = hypot(x, y);
    if (x * (a.x + b.x - 2 * m.x) + y * (a.y + b.y - 2 * m.y) < 0) length = -length;
    direction[0] = length != 0 ? x / length : 0;
    direction[1] = length != 0 ? y / length : 1;
}

/* All of it is before the eye. */
static int is_before(const axes_drawing *d, const axes_edge *e) {
    axes_edge cut = *e;
    return axes_clip(d, &cut) && cut.from[cut.axis] == e->from[e->axis] && cut.to[cut.axis] == e->to[e->axis];
}

/* Numbers stand at the lowest edge of the outline, else at the one on the left. */
static void number_box(axes_drawing *d, int axis) {
    double best = -INFINITY, direction[2] = {0, 1};
    axes_edge chosen = {.axis = axis};
    for (int i = 0; i < 4; i++) {
        axes_edge e = edge_of(d, axis, i & 1, i >> 1);
        double out[2];
        if (faces_away(d, (axis + 1) % 3, i & 1) == faces_away(d, (axis + 2) % 3, i >> 1) ||
            !is_before(d, &e))
            continue;
        outward(d, &e, out);
        if (out[1] - 0.5 * out[0] <= best) continue;
        best = out[1] - 0.5 * out[0];
        chosen = e;
        memcpy(direction, out, sizeof out);
    }
    if (isinf(best)) return;
    double reach = axes_put_ticks(d, &chosen, direction, 0);
    if (reach == 0) return;
    axes_edge half = chosen;
    half.from[axis] = 0.5 * (chosen.from[axis] + chosen.to[axis]);
    axes_write(d, axes_seen(d, half.from), direction, reach + AXES_GAP * d->letter, axis_names[axis]);
}

static void draw_box(axes_drawing *d) {
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < 4; i++)
            if (faces_away(d, (axis + 1) % 3, i & 1) || faces_away(d, (axis + 2) % 3, i >> 1))
                axes_draw_edge(d, edge_of(d, axis, i & 1, i >> 1));
        number_box(d, axis);
    }
}

/* ---- the axes ---- */

/* An axis in the picture. */
typedef struct seen_axis {
    axes_edge e;
    stroke_point from, to;
    double along[2], across[2]; /* numbers stand across it: below, or on the left */
} seen_axis;

/* Returns 0 where none of it is before the eye and in the box. */
static int see_axis(const axes_drawing *d, int axis, seen_axis *a) {
    axes_edge e = {.axis = axis};
    e.from[axis] = d->lo[axis];
    e.to[axis] = d->hi[axis];
    for (int i = 0; i < 3; i++)
        if (i != axis && !(d->lo[i] <= 0 && d->hi[i] >= 0)) return 0;
    if (!axes_clip(d, &e)) return 0;
    *a = (seen_axis){.e = e, .from = axes_seen(d, e.from), .to = axes_seen(d, e.to)};
    double x = a->to.x - a->from.x, y = a->to.y - a->from.y, length = hypot(x, y);
    a->along[0] = length > 0 ? x / length : 1;
    a->along[1] = length > 0 ? y / length : 0;
    double side = a->along[0] + 0.5 * a->along[1] < 0 ? -1 : 1;
    a->across[0] = -side * a->along[1];
    a->across[1] = side * a->along[0];
    return 1;
}

/* Behind the axis' end, or, where that is outside of the picture, beside the last of it that is in there. */
static void name_axis(axes_drawing *d, const seen_axis *a) {
    double inset = 2 * d->letter, half[2] = {0.5 * d->s.width, 0.5 * d->s.height}, part = 1;
    const double from[2] = {a->from.x - half[0], a->from.y - half[1]};
    const double step[2] = {a->to.x - a->from.x, a->to.y - a->from.y},
                 other[2] = {-a->across[0], -a->across[1]};
    for (int i = 0; i < 2; i++)
        if (fabs(from[i] + step[i]) > half[i] - inset)
            part = fmin(part, (copysign(half[i] - inset, step[i]) - from[i]) / step[i]);
    if (part == 1)
        axes_write(d, a->to, a->along, AXES_GAP * d->letter, axis_names[a->e.axis]);
    else if (part > 0) {
        stroke_point p = {half[0] + from[0] + part * step[0], half[1] + from[1] + part * step[1],
                          a->to.depth};
        axes_write(d, p, other, AXES_GAP * d->letter, axis_names[a->e.axis]);
    }
}

static void draw_axes(axes_drawing *d) {
    seen_axis axes[3];
    int are[3];
    for (int i = 0; i < 3; i++) {
        are[i] = see_axis(d, i, &axes[i]);
        if (!are[i]) continue;
        axes_draw_edge(d, axes[i].e);
        name_axis(d, &axes[i]);
    }
    for (int i = 0; i < 3; i++)
        if (are[i]) axes_put_ticks(d, &axes[i].e, axes[i].across, 1);
}

/* ---- all ---- */

/* Without a background it may be light or dark. */
static void paint(const strokes *s, const uint8_t *background, uint8_t *pixels, int bytes) {
    static const uint8_t dark[3] = {0x38, 0x38, 0x38}, light[3] = {0xc8, 0xc8, 0xc8},
                         any[3] = {0x78, 0x78, 0x78};
    const uint8_t *b = background, *ink = b && 3 * b[0] + 6 * b[1] + b[2] < 10 * 0x70 ? light : dark;
    strokes_paint(s, b ? ink : any, ink, pixels, bytes);
}

int axes_draw(const axes_scene *scene, int row_begin, int row_end, const uint8_t *background, uint8_t *pixels,
              int bytes, const double *t) {
    axes_drawing d = axes_begin(scene);
    const algsurf_camera *c = &scene->camera;
    double middle = -axes_dot(c->eye, c->forward), pixel = c->half_height / (0.5 * scene->height);
    for (int i = 0; i < 3; i++) middle += 0.5 * (d.lo[i] + d.hi[i]) * c->forward[i];
    d.s.row_begin = row_begin;
    d.s.row_end = row_end;
    d.s.t = t;
    d.beyond = pixel * (d.s.pixel > 0 ? fmax(middle, d.size) : 1);
    d.s.cover = calloc((size_t)scene->width * (size_t)(row_end - row_begin), 1);
    if (!d.s.cover) return 0;
    if (scene->what & AXES_BOX) draw_box(&d);
    if (scene->what & AXES_LINES) draw_axes(&d);
    paint(&d.s, background, pixels, bytes);
    free(d.s.cover);
    return 1;
}

double axes_zoom(const axes_scene *scene) {
    axes_drawing d = axes_begin(scene);
    double margin[2] = {(AXES_TICK + AXES_GAP + AXES_NUMBER) * d.letter,
                        (AXES_TICK + AXES_GAP + 1.3) * d.letter};
    double half[2] = {fmax(0.5 * scene->width - margin[0], 1), fmax(0.5 * scene->height - margin[1], 1)},
           zoom = 1;
    for (int i = 0; i < 8; i++) {
        double corner[3];
        for (int k = 0; k < 3; k++) corner[k] = i >> k & 1 ? d.hi[k] : d.lo[k];
        stroke_point p = axes_seen(&d, corner);
        if (d.s.pixel > 0 && !(p.depth > AXES_NEAR * d.size)) return 1;
        zoom = fmin(zoom, half[0] / fabs(p.x - 0.5 * scene->width));
        zoom = fmin(zoom, half[1] / fabs(p.y - 0.5 * scene->height));
    }
    return fmax(0.01, floor(100 * zoom) / 100);
}
