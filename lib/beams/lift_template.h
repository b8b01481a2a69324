/* lift_template.h - points lifted off the surface, so that rays from them do not meet it where they begin. */
#ifndef ALGSURF_LIFT_TEMPLATE_H
#define ALGSURF_LIFT_TEMPLATE_H
#include "../simd/lanes.h"
#include "segments.h"

/* A millionth of what is shown is invisible, and well above the error of a hit's position, which the second
 * term bounds for far eyes and far extents: position and t are rounded to 2^-53, and 2^-48 leaves room for
 * the root's own error. */
static void lift(const algsurf_i_points *points, int first, int count, double height,
                 algsurf_i_starts *starts) {
    for (int i = 0; i < count; i += LANES) {
        lanes position[3], normal[3], direction[3];
        for (int k = 0; k < 3; k++) {
            position[k] = load_some(points->position[k] + first + i, count - i);
            normal[k] = load_some(points->normal[k] + first + i, count - i);
            direction[k] = load_some(points->direction[k] + first + i, count - i);
        }
        lanes t = load_some(points->t + first + i, count - i);
        lanes up = height + 0x1p-48 * (absolute(t) + largest_size(position));
        mask singular = at_most(largest_size(normal), all_lanes(0));
        mask away = less(all_lanes(0), dot(normal, direction));
        for (int k = 0; k < 3; k++) {
            lanes facing = choose(singular, -direction[k], choose(away, -normal[k], normal[k]));
            store(starts->facing[k] + i, facing);
            store(starts->at[k] + i, position[k] + up * facing);
        }
    }
    starts->count = count;
}

#endif
