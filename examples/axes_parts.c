/* axes_parts.c - see axes_parts.h. */
#include "axes_parts.h"

#include <math.h>
#include <string.h>

#include "ticks.h"

enum { MOST_TICKS = 9 };
static const double LINE = 0.09, SPARSE = 3.2; /* letter heights: width of lines, least distance of ticks */
static const double BIAS = 3;                  /* pixels that a line in the surface may lie behind it, */
static const double TICK_BIAS =
    1; /* letter heights for ticks and numbers: the surface may rise beside them */

axes_drawing axes_begin(const axes_scene *scene) {
    axes_drawing d = {.scene = scene,
                      .letter = scene->letter > 0 ? scene->letter : axes_letter(scene->width, scene->height)};
    const algsurf_extent *e = &scene->extent;
    double square = 0;
    for (int i = 0; i < 3; i++) {
        double half = e->kind == ALGSURF_EXTENT_SPHERE ? e->size[0] : e->size[i];
        d.lo[i] = e->centre[i] - half;
        d.hi[i] = e->centre[i] + half;
        square += half * half;
    }
    d.size = sqrt(square);
    d.line = fmax(1, LINE * d.letter);
    d.s = (strokes){.width = scene->width, .height = scene->height};
    if (scene->camera.kind != ALGSURF_CAMERA_ORTHOGRAPHIC)
        d.s.pixel = scene->camera.half_height / (0.5 * scene->height);
    return d;
}

/* ---- from space to the picture ---- */

double axes_dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

stroke_point axes_seen(const axes_drawing *d, const double place[3]) {
    const algsurf_camera *c = &d->scene->camera;
    double from[3], pixel = c->half_height / (0.5 * d->scene->height);
    for (int i = 0; i < 3; i++) from[i] = place[i] - c->eye[i];
    double depth = axes_dot(from, c->forward), unit = d->s.pixel > 0 ? pixel * depth : pixel;
    return (stroke_point){0.5 * d->scene->width + axes_dot(from, c->right) / unit,
                          0.5 * d->scene->height - axes_dot(from, c->up) / unit, depth};
}

int axes_clip(const axes_drawing *d, axes_edge *e) {
    const algsurf_camera *c = &d->scene->camera;
    double least = AXES_NEAR * d->size, from = -least - axes_dot(c->eye, c->forward), to = from;
    from += axes_dot(e->from, c->forward);
    to += axes_dot(e->to, c->forward);
    if (!(from > 0) && !(to > 0)) return 0;
    double *behind = from > 0 ? e->to : e->from,
           at = e->from[e->axis] + (e->to[e->axis] - e->from[e->axis]) * from / (from - to);
    if (!(from > 0) || !(to > 0)) behind[e->axis] = at;
    return 1;
}

void axes_draw_edge(axes_drawing *d, axes_edge e) {
    d->s.nearer = BIAS * d->line * d->beyond;
    if (axes_clip(d, &e)) strokes_line(&d->s, axes_seen(d, e.from), axes_seen(d, e.to), d->line);
}

/* ---- numbers ---- */

static stroke_point moved(stroke_point p, const double direction[2], double by) {
    p.x += by * direction[0];
    p.y += by * direction[1];
    return p;
}

/* In the picture, and not on another text. */
static int is_free(const axes_drawing *d, const axes_text *p) {
    if (p->x < p->across || p->x > d->s.width - p->across) return 0;
    if (p->y < p->down || p->y > d->s.height - p->down) return 0;
    for (int i = 0; i < d->texts; i++) {
        const axes_text *q = &d->taken[i];
        if (fabs(p->x - q->x) < p->across + q->across && fabs(p->y - q->y) < p->down + q->down) return 0;
    }
    return d->texts < AXES_MOST_TEXTS;
}

/* Is there surface before a point?  Its number is drawn whole or not at all, since a part of it would be read
 * as another one; slices of a picture do not hold the pixels that could tell. */
static int is_hidden(const axes_drawing *d, const stroke_point *p) {
    const axes_scene *scene = d->scene;
    algsurf_ray ray;
    algsurf_hit hit;
    if (!d->s.t ||
        algsurf_camera_ray(&scene->camera, scene->width, scene->height, p->x, p->y, &ray) != ALGSURF_OK)
        return 0;
    ray.t_max = p->depth / axes_dot(ray.direction, scene->camera.forward) - TICK_BIAS * d->letter * d->beyond;
    return ray.t_max > 0 &&
           algsurf_intersect_first(scene->surface, &scene->extent, &ray, scene->options, &hit) >= 0 &&
           hit.state == ALGSURF_STATE_HIT;
}

double axes_write(axes_drawing *d, stroke_point p, const double direction[2], double distance,
                  const char *text) {
    double width = strokes_text_width(d->letter, text), height = d->letter;
    double half = (fabs(direction[0]) * width + fabs(direction[1]) * height) / 2;
    stroke_point middle = moved(p, direction, distance + half);
    const axes_text here = {middle.x, middle.y, (width + height / 3) / 2, 2 * height / 3};
    if (!is_free(d, &here)) return distance;
    d->taken[d->texts++] = here;
    if (middle.y + 1.5 * height < d->s.row_begin || middle.y - 1.5 * height > d->s.row_end ||
        is_hidden(d, &p))
        return distance + 2 * half;
    strokes letters = d->s;
    letters.t = NULL;
    strokes_text(&letters, middle, height, text);
    return distance + 2 * half;
}

double axes_put_ticks(axes_drawing *d, const axes_edge *e, const double direction[2], int inner) {
    int axis = e->axis;
    double lo = e->from[axis], hi = e->to[axis], reach = AXES_TICK * d->letter, place[3];
    stroke_point a = axes_seen(d, e->from), b = axes_seen(d, e->to);
    double count = fmin(MOST_TICKS, hypot(b.x - a.x, b.y - a.y) / (SPARSE * d->letter));
    if (!(hi > lo) || count < 1) return 0;
    tick_step step = ticks_step((hi - lo) / count);
    if (floor(hi / ticks_size(step)) <= ceil(lo / ticks_size(step))) /* one number does not tell a size */
        step = ticks_step(0.4 * ticks_size(step));
    double size = ticks_size(step), first = ceil(lo / size - 1e-9), last = floor(hi / size + 1e-9);
    if (!(fabs(first) < 1e9 && fabs(last) < 1e9)) return 0; /* of a small box far from the origin */
    memcpy(place, e->from, sizeof place);
    for (long long k = (long long)first; k <= (long long)last; k++) {
        char text[TICKS_TEXT];
        if (inner && k == 0) continue;
        place[axis] = (double)k * size;
        stroke_point p = axes_seen(d, place);
        d->s.nearer = TICK_BIAS * d->letter * d->beyond;
        strokes_line(&d->s, inner ? moved(p, direction, -AXES_TICK / 2 * d->letter) : p,
                     moved(p, direction, (inner ? AXES_TICK / 2 : AXES_TICK) * d->letter), d->line);
        ticks_text(step, k, text);
        reach = fmax(reach, axes_write(d, p, direction, (AXES_TICK + AXES_GAP) * d->letter, text));
    }
    return reach;
}
