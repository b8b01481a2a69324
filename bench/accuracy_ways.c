/* accuracy_ways.c - see accuracy.h. */
#include "accuracy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "must.h"
#include "rays.h"

/* How many units of view_noise the residual at t may have: rounding of the coefficients, of P's value and of
 * the position. */
static const double FEW = 4;

struct ways {
    const view *view;
    algsurf_scene *scene;
    algsurf_ray_packet packet;
    unsigned char *state;                          /* the answer of each ray: an algsurf_hit_state */
    double *t, *lo, *hi, *position[3], *normal[3]; /* where; lo and hi are not of a picture's */
    double *error, *picture_hits;
    uint8_t *pixels, *settled_pixels;
};

const char *const way_names[3] = {"single", "packet", "picture"};
const char *const method_names[4] = {"default", "brent", "bisection", "regula-falsi"};
const char *const tier_names[2] = {"certified", "bounded"};

ways *ways_open(const view *v) {
    ways *w = must_allocate(1, sizeof *w);
    size_t n = v->count, pixels = (size_t)v->width * (size_t)v->height;
    double *room = must_allocate(10 * n, sizeof *room);
    *w = (ways){.view = v, .t = room, .lo = room + n, .hi = room + 2 * n, .error = room + 3 * n};
    for (size_t k = 0; k < 3; k++) {
        w->position[k] = room + (4 + k) * n;
        w->normal[k] = room + (7 + k) * n;
    }
    w->packet = rays_packet(v->ray, n);
    w->packet.t_min = w->packet.t_max = NULL;
    w->state = must_allocate(n, 1);
    w->picture_hits = must_allocate(pixels, sizeof(double));
    w->pixels = must_allocate(pixels, 3);
    w->settled_pixels = must_allocate(pixels, 3);
    w->scene = rays_scene(v->surface, &v->entry->extent, &v->camera);
    return w;
}

void ways_close(ways *w) {
    algsurf_scene_free(w->scene);
    rays_packet_free(&w->packet);
    free(w->t);
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
        w->state[i] = (unsigned char)hit.state;
        w->t[i] = hit.t, w->lo[i] = hit.t_lo, w->hi[i] = hit.t_hi;
    }
    double seconds = measure_cpu() - begun;
    must(worst, w->view->entry->name);
    return seconds / (double)v->count;
}

static double run_together(ways *w, const setting *s) {
    const view *v = w->view;
    const algsurf_intersect_options options = options_of(s);
    algsurf_hit_packet hits = {
        .size = sizeof hits, .state = w->state, .t = w->t, .t_lo = w->lo, .t_hi = w->hi};
    for (int k = 0; k < 3; k++) {
        hits.position[k] = w->position[k];
        hits.normal[k] = w->normal[k];
    }
    double begun = measure_cpu();
    algsurf_status status =
        algsurf_intersect_packet(v->surface, &v->entry->extent, &w->packet, &options, &hits);
    double seconds = measure_cpu() - begun;
    must(status, w->view->entry->name);
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
        w->t[i] = w->picture_hits[v->pixel[i]];
        w->state[i] = isinf(w->t[i]) ? ALGSURF_STATE_MISS : ALGSURF_STATE_HIT;
    }
    return seconds / (double)v->all_rays;
}

double ways_run(ways *w, const setting *s) {
    static double (*const run[])(ways * w, const setting *s) = {run_singly, run_together, run_picture};
    return run[s->way](w, s);
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

/* Null, or how answer i contradicts the truth. */
static const char *breach_of(const ways *w, const setting *s, size_t i) {
    const truth *known = &w->view->truth[i];
    const int state = w->state[i], has_interval = s->way != WAY_PICTURE;
    double error = isinf(known->error) ? 0 : known->error;
    if (state == ALGSURF_STATE_UNDECIDED)
        return known->state == ALGSURF_STATE_HIT && has_interval && known->hi < w->lo[i]
                   ? "an undecided interval that begins behind the root"
                   : NULL;
    if (state == ALGSURF_STATE_MISS)
        return known->state == ALGSURF_STATE_HIT ? "a miss where there is a hit" : NULL;
    if (known->state == ALGSURF_STATE_MISS) return "a hit where there is none";
    if (!has_interval || isinf(known->error)) return NULL;
    if (!(w->t[i] >= w->lo[i] && w->t[i] <= w->hi[i])) return "t outside of its interval";
    return known->t + error >= w->lo[i] && known->t - error <= w->hi[i] ? NULL
                                                                        : "an interval without the root";
}

/* In a picture of the bounded tier rays that doubles leave open are drawn as hits. */
static int is_open(const setting *s, const truth *known) {
    return known->state == ALGSURF_STATE_UNDECIDED ||
           (s->way == WAY_PICTURE && s->tier == ALGSURF_TIER_BOUNDED && known->left_open);
}

static void judge_ray(ways *w, const setting *s, size_t i, verdict *r) {
    const truth *known = &w->view->truth[i];
    const int state = w->state[i];
    const char *breach = breach_of(w, s, i);
    r->undecided += state == ALGSURF_STATE_UNDECIDED;
    if (is_open(s, known)) return;
    int wrong = state != ALGSURF_STATE_UNDECIDED && state != known->state;
    if (state == ALGSURF_STATE_HIT && known->state == ALGSURF_STATE_HIT && !isinf(known->error)) {
        double error = w->error[r->hits++] = fabs((w->t[i] - known->t) - known->rest);
        wrong = !is_near(w->view, s, i, w->t[i], error);
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
        r.usual = measure_quantile(w->error, r.hits, 0.999);
        r.largest = measure_quantile(w->error, r.hits, 1);
    }
    return r;
}
