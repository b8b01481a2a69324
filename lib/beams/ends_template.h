/* ends_template.h - where rays from points leave a box or what planes keep, in the view's unit. */
#ifndef ALGSURF_ENDS_TEMPLATE_H
#define ALGSURF_ENDS_TEMPLATE_H
#include "../simd/lanes.h"
#include "segments.h"

#define END_SLACK 0x1p-30 /* of an extent, relative: far more than the rounding of its ends */

/* Parts of a ray: it is inside before `least`, outside from `most` on. */
typedef struct ray_ends {
    lanes least, most;
} ray_ends;

/* x and d in the box's axes, which are the caller's. */
INLINE ray_ends ends_in_box(const double half[3], const lanes x[3], const lanes d[3]) {
    const lanes never = all_lanes(HUGE_VAL);
    ray_ends e = {never, never};
    mask inside = ~no_lane();
    for (int i = 0; i < 3; i++) {
        double wide = half[i] * (1 + END_SLACK), narrow = half[i] * (1 - END_SLACK);
        lanes speed = absolute(d[i]), ahead = choose(less(d[i], all_lanes(0)), -x[i], x[i]);
        mask moves = less(all_lanes(0), speed);
        e.most = smaller(e.most, choose(moves, (wide - ahead) / speed, never));
        e.least = smaller(e.least, choose(moves, (narrow - ahead) / speed, never));
        inside &= less(absolute(x[i]), all_lanes(narrow));
    }
    e.least = choose(inside, e.least, all_lanes(0));
    return e;
}

/* What planes leave of that.  A ray that begins beyond a plane may come back through it: nothing is known to
 * be inside then. */
INLINE ray_ends ends_at_planes(const algsurf_i_shadow_job *job, const lanes x[3], const lanes d[3],
                               ray_ends e) {
    const lanes never = all_lanes(HUGE_VAL);
    for (int i = 0; i < job->plane_count; i++) {
        const algsurf_i_cut_plane *p = job->planes + i;
        const lanes n[3] = {all_lanes(p->normal[0]), all_lanes(p->normal[1]), all_lanes(p->normal[2])};
        double slack = END_SLACK + p->error;
        lanes below = p->offset - dot(n, x), speed = dot(n, d);
        mask moves = less(all_lanes(0), speed);
        e.least = choose(less(all_lanes(slack), below),
                         smaller(e.least, choose(moves, (below - slack) / speed, never)), all_lanes(0));
        e.most = smaller(e.most, choose(moves, (below + slack) / speed, never));
    }
    return e;
}

#endif
