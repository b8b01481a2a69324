/* packet_template.h - rays in any order, LANES at once: the chord inside the extent, the polynomial along it,
 * its first root (along_template.h), the point there. */
#ifndef ALGSURF_RAYS_PACKET_TEMPLATE_H
#define ALGSURF_RAYS_PACKET_TEMPLATE_H
#include "along_template.h"
#include "far_template.h"
#include "hits_template.h"

/* The lanes `which`, to the places of their rays in an array, which may be null. */
INLINE void store_lanes(double *array, lanes a, const places *w, unsigned which) {
    if (!array) return;
    if (!w->listed && which == (1u << LANES) - 1) {
        store(array + w->ray[0], a);
    } else {
        for (int l = 0; l < LANES; l++)
            if (which >> l & 1) array[w->ray[l]] = a[l];
    }
}

/* What is found of the lanes `which`.  The last coefficient has P's sign at the end of a chord that was
 * opened.
 */
INLINE void store_found(const packet *k, mask opened, const lanes_hit *hit, const algsurf_hit_packet *to,
                        const places *w, unsigned which, int n, int any) {
    const unsigned found = bits(k->hit), undecided = bits(k->undecided), searched = bits(opened);
    const unsigned below =
        bits(((negative(k->at.side) & k->hit) | (negative((words)k->b[n]) & ~k->hit)) & opened);
    const lanes none = all_lanes(HUGE_VAL), zero = all_lanes(0);
    for (int l = 0; l < LANES; l++) {
        const size_t i = w->ray[l];
        const int hit_here = found >> l & 1;
        if (!(which >> l & 1)) continue;
        to->state[i] =
            (unsigned char)(ALGSURF_LANE_HIT * hit_here + ALGSURF_LANE_UNDECIDED * (int)(undecided >> l & 1));
        if (to->side) to->side[i] = (signed char)((int)(searched >> l & 1) - 2 * (int)(below >> l & 1));
        if (to->multiplicity) to->multiplicity[i] = hit_here;
    }
    if (any) return;
    store_lanes(to->t, choose(k->hit, hit->t, none), w, which);
    store_lanes(to->t_lo, choose(k->hit, hit->t_lo, none), w, which);
    store_lanes(to->t_hi, choose(k->hit, hit->t_hi, none), w, which);
    for (int i = 0; i < 3; i++) {
        store_lanes(to->position[i], choose(k->hit, hit->position[i], zero), w, which);
        store_lanes(to->normal[i], choose(k->hit, hit->normal[i], zero), w, which);
    }
}

/* Answers the lanes `given`, but those that it returns. */
INLINE mask solve_lanes(const algsurf_i_rays_job *job, const places *w, ray_lanes *r, far_rays *f, mask given,
                        const algsurf_hit_packet *hits, int n) {
    packet k;
    chord_line line;
    algsurf_i_watch watch;
    lanes_hit hit = {.t = all_lanes(0)};
    mask going = no_lane(), opened = search(job, r, &watch, &line, &k, n);
    if (any(f->far & opened)) going = next_pieces(job, r, f, &line, &k, opened, n, !job->surface->nodes);
    if (!job->any && any(k.hit)) {
        lanes v;
        refine(&k, n, ROOT_ERROR, &v);
        find_hits(job, r, line.t_c, line.h, 2 * v - 1, hits->t_lo || hits->t_hi,
                  hits->normal[0] || hits->normal[1] || hits->normal[2], &k, &hit);
    }
    store_found(&k, opened, &hit, hits, w, bits(given & ~going), n, job->any);
    return going;
}

APART void solve_rays(const algsurf_i_rays_job *job, const algsurf_hit_packet *hits) {
    const size_t count = job->rays->count;
    const int n = job->surface->node_degree;
    if (n < 1 || n > MOST_DEGREE) __builtin_unreachable();
    double scale = ldexp(1, -job->surface->unit);
    waiting list = {.count = 0};
    places w;
    for (size_t next = 0; next < count || list.count > 0;) {
        far_rays f;
        set_places(&w, next, count - next);
        if (list.count >= LANES || next == count)
            take(&list, job, &w);
        else
            next += (size_t)w.count;
        ray_lanes r;
        load_rays(job, &w, scale, &r);
        if (!any(r.open | r.undecided)) continue;
        mask given = r.open | r.undecided;
        clip_rays(job, &w, &r, scale);
        begin_far(job, &w, &r, &f);
        if (w.listed) resume(&list, &w, &r, &f);
        mask going = solve_lanes(job, &w, &r, &f, given, hits, n);
        if (any(going)) put(&list, &w, &f, bits(going));
    }
}

const algsurf_i_rays_kernel KERNEL(algsurf_i_rays) = {.solve = solve_rays};

#endif
