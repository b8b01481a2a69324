/* accuracy_ways.c - see accuracy_ways.h. */
#include "accuracy_ways.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "measure.h"
#include "must.h"

/* How many units of view_noise the residual at t may have: rounding of the coefficients, of P's value and of
 * the position. */
static const double FEW = 4;

typedef struct answer {
    int state;
    int has_interval; /* lo, hi are known */
    double t, lo, hi;
} answer;

struct ways {
    const view *view;
    algsurf_scene *scene;
    double *origin[3], *direction[3]; /* the rays once more, for packets */
    answer *answer;                   /* of each ray */
    double *t, *lo, *hi, *position[3], *normal[3], *error;
    unsigned char *state;
    double *picture_hits;
    uint8_t *pixels, *settled_pixels;
};

const char *way_name(way w) {
    static const char *const names[] = {"single", "packet", "picture"};
    return names[w];
}

const char *method_name(int method) {
    static const char *const names[] = {"default", "brent", "bisection", "regula-falsi"};
    return names[method];
}

const char *tier_name(int tier) {
    static const char *const names[] = {"certified", "bounded"};
    return names[tier];
}

static double *numbers(const view *v) { return must_allocate(v->count, sizeof(double)); }

ways *ways_open(const view *v) {
    ways *w = must_allocate(1, sizeof *w);
    size_t pixels = (size_t)v->width * (size_t)v->height;
    w->view = v;
    for (int k = 0; k < 3; k++) {
        w->origin[k] = numbers(v);
        w->direction[k] = numbers(v);
        w->position[k] = numbers(v);
        w->normal[k] = numbers(v);
        for (size_t i = 0; i < v->count; i++) {
            w->origin[k][i] = v->ray[i].origin[k];
            w->direction[k][i] = v->ray[i].direction[k];
        }
    }
    w->t = numbers(v);
    w->lo = numbers(v);
    w->hi = numbers(v);
    w->error = numbers(v);
    w->answer = must_allocate(v->count, sizeof *w->answer);
    w->state = must_allocate(v->count, 1);
    w->picture_hits = must_allocate(pixels, sizeof(double));
    w->pixels = must_allocate(pixels, 3);
    w->settled_pixels = must_allocate(pixels, 3);
    must(algsurf_scene_create(v->surface, &w->scene), w->view->entry->name);
    must(algsurf_scene_set_extent(w->scene, &v->entry->extent), w->view->entry->name);
    must(algsurf_scene_set_camera(w->scene, &v->camera), w->view->entry->name);
    return w;
}

void ways_close(ways *w) {
    algsurf_scene_free(w->scene);
    for (int k = 0; k < 3; k++) {
        free(w->origin[k]);
        free(w->direction[k]);
        free(w->position[k]);
        free(w->normal[k]);
    }
    free(w->t);
    free(w->lo);
    free(w->hi);
    free(w->error);
    free(w->answer);
    free(w->state);
    free(w->picture_hits);
    free(w->pixels);
    free(w->settled_pixels);
    free(w);
}

/* ---- answers ---- */

static algsurf_intersect_options options_of(const setting *s) {
    return (algsurf_intersect_options){.size = sizeof(algsurf_intersect_options),
                                       .tier = s->tier,
                                       .method = s->method,
                                       .absolute_tolerance = s->tolerance};
}

static double run_singly(ways *w, const setting *s) {
    const view *v = w->view;
    const algsurf_intersect_options options = options_of(s);
    algsurf_status worst = ALGSURF_OK;
    double begun = measure_cpu();
    for (size_t i = 0; i < v->count; i++) {
        algsurf_hit hit;
        algsurf_status status =
            algsurf_intersect_first(v->surface, &v->entry->extent, &v->ray[i], &options, &hit);
        if (status != ALGSURF_OK) worst = status;
        w->answer[i] = (answer){hit.state, 1, hit.t, hit.t_lo, hit.t_hi};
    }
    double seconds = measure_cpu() - begun;
    must(worst, w->view->entry->name);
    return seconds / (double)v->count;
}

static double run_together(ways *w, const setting *s) {
    const view *v = w->view;
    const algsurf_intersect_options options = options_of(s);
    algsurf_ray_packet rays = {.size = sizeof rays, .count = v->count};
    algsurf_hit_packet hits = {
        .size = sizeof hits, .state = w->state, .t = w->t, .t_lo = w->lo, .t_hi = w->hi};
    for (int k = 0; k < 3; k++) {
        rays.origin[k] = w->origin[k];
        rays.direction[k] = w->direction[k];
        hits.position[k] = w->position[k];
        hits.normal[k] = w->normal[k];
    }
    double begun = measure_cpu();
    algsurf_status status = algsurf_intersect_packet(v->surface, &v->entry->extent, &rays, &options, &hits);
    double seconds = measure_cpu() - begun;
    must(status, w->view->entry->name);
    for (size_t i = 0; i < v->count; i++)
        w->answer[i] = (answer){w->state[i], 1, w->t[i], w->lo[i], w->hi[i]};
    return seconds / (double)v->count;
}

/* Draws into the buffers of the picture; seconds spent on where the rays meet the surface: that share, by the
 * clock on the wall, of the CPU time. */
static double draw(ways *w, const setting *s) {
    const view *v = w->view;
    const algsurf_intersect_options intersect = options_of(s);
    const algsurf_render_options options = {
        .size = sizeof options, .width = v->width, .height = v->height, .threads = 1};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = w->pixels, .t = w->picture_hits};
    algsurf_render_stats stats = {.size = sizeof stats};
    must(algsurf_scene_set_intersect_options(w->scene, &intersect), w->view->entry->name);
    double begun = measure_cpu();
    must(algsurf_render(w->scene, &options, &picture, &stats), w->view->entry->name);
    double seconds = measure_cpu() - begun;
    return seconds * (stats.expand_s + stats.solve_s + stats.point_s) / stats.total_s;
}

static double run_picture(ways *w, const setting *s) {
    const view *v = w->view;
    double seconds = draw(w, s);
    for (size_t i = 0; i < v->count; i++) {
        double t = w->picture_hits[v->pixel[i]];
        w->answer[i] = (answer){.state = isinf(t) ? ALGSURF_STATE_MISS : ALGSURF_STATE_HIT, .t = t};
    }
    return seconds / (double)v->all_rays;
}

double ways_run(ways *w, const setting *s) {
    switch (s->way) {
    case WAY_SINGLE:
        return run_singly(w, s);
    case WAY_PACKET:
        return run_together(w, s);
    case WAY_PICTURE:
        break;
    }
    return run_picture(w, s);
}

int ways_settled(ways *w, const setting *s, const double *tolerances, int count) {
    const size_t size = 3 * (size_t)w->view->width * (size_t)w->view->height;
    setting here = *s;
    int k = count - 1;
    here.tolerance = tolerances[k];
    (void)draw(w, &here);
    memcpy(w->settled_pixels, w->pixels, size);
    while (k > 0) {
        here.tolerance = tolerances[k - 1];
        (void)draw(w, &here);
        if (memcmp(w->pixels, w->settled_pixels, size) != 0) break;
        k--;
    }
    return k;
}

/* ---- the verdict ---- */

/* Is t, a hit's, within what is stated of the root? */
static int is_near(const view *v, const setting *s, size_t i, double t, double error) {
    const truth *known = &v->truth[i];
    const algsurf_ray *chord = &v->chord[i];
    double stated = s->tolerance + 0x1p-52 * fabs(t) + known->error;
    if (s->tolerance > 0) stated += 0x1p-49 * (chord->t_max - chord->t_min);
    if (s->way == WAY_PICTURE) stated += 0x1p-36 * v->entry->extent.size[0];
    if (error <= stated) return 1;
    double nearer = t < known->t ? t + stated : t - stated;
    return nearer >= known->lo && nearer <= known->hi && view_noise(v, i, nearer) <= FEW;
}

/* Null, or how an answer contradicts the truth. */
static const char *breach_of(const answer *a, const truth *known) {
    double error = isinf(known->error) ? 0 : known->error;
    if (a->state == ALGSURF_STATE_UNDECIDED)
        return known->state == ALGSURF_STATE_HIT && a->has_interval && known->hi < a->lo
                   ? "an undecided interval that begins behind the root"
                   : NULL;
    if (a->state == ALGSURF_STATE_MISS)
        return known->state == ALGSURF_STATE_HIT ? "a miss where there is a hit" : NULL;
    if (known->state == ALGSURF_STATE_MISS) return "a hit where there is none";
    if (!a->has_interval || isinf(known->error)) return NULL;
    if (!(a->t >= a->lo && a->t <= a->hi)) return "t outside of its interval";
    return known->t + error >= a->lo && known->t - error <= a->hi ? NULL : "an interval without the root";
}

/* In a picture of the bounded tier rays that doubles leave open are drawn as hits. */
static int is_open(const setting *s, const truth *known) {
    return known->state == ALGSURF_STATE_UNDECIDED ||
           (s->way == WAY_PICTURE && s->tier == ALGSURF_TIER_BOUNDED && known->left_open);
}

static void judge_ray(ways *w, const setting *s, size_t i, verdict *r) {
    const truth *known = &w->view->truth[i];
    const answer *a = &w->answer[i];
    const char *breach = breach_of(a, known);
    r->undecided += a->state == ALGSURF_STATE_UNDECIDED;
    if (is_open(s, known)) return;
    int wrong = a->state != ALGSURF_STATE_UNDECIDED && a->state != known->state;
    if (a->state == ALGSURF_STATE_HIT && known->state == ALGSURF_STATE_HIT && !isinf(known->error)) {
        double error = w->error[r->hits++] = fabs((a->t - known->t) - known->rest);
        wrong = !is_near(w->view, s, i, a->t, error);
        if (wrong && !breach && s->method != ALGSURF_METHOD_REGULA_FALSI)
            breach = "t off by more than is stated";
    }
    if (wrong && r->wrong++ == 0) r->first_wrong = w->view->pixel[i];
    if (!breach || r->breach) return;
    r->breach = breach;
    r->at = w->view->pixel[i];
}

verdict ways_judge(ways *w, const setting *s) {
    verdict r = {0};
    for (size_t i = 0; i < w->view->count; i++) judge_ray(w, s, i, &r);
    if (r.hits > 0) {
        measure_sort(w->error, r.hits);
        r.usual = measure_quantile(w->error, r.hits, 0.999);
        r.largest = w->error[r.hits - 1];
    }
    return r;
}
