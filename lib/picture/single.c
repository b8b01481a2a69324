/* single.c - which pictures of the fast tier are drawn in floats.
 *
 * All of single precision is u = 2^-24.  A place across the view, |u| < 4 and usually below 1, is known to
 * 2^-24 of it, which must be little of a pixel.  Coefficients are sums of the surface's terms: they grow with
 * the degree, and with the distance of what is shown from the origin of the equation, while what is left of
 * them at a root does not.  Values must stay in the range of a float, on the way to normals, too. */
#include "../base/arithmetic.h"
#include "../base/eft.h"
#include "impl.h"

#include <math.h>

#define LEAST_PIXEL 0x1p-14 /* in the view's unit, some radius of the extent: 1/256 of a pixel is lost */
#define FARTHEST 16         /* centre of the extent, in the same unit */
#define LEAST_VALUE 0x1p-50 /* of the surface's terms, added up in size, and of lengths */
#define MOST_VALUE 0x1p50

static int in_range(double value) { return value > LEAST_VALUE && value < MOST_VALUE; }

int algsurf_i_single_suits(const algsurf_i_picture *picture) {
    const algsurf_scene *scene = picture->scene;
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_view *view = &p->frame.view;
    int n = scene->surface->degree;
    if (scene->intersect.tier != ALGSURF_TIER_FAST || scene->complex || n > ALGSURF_MAX_BEAM_DEGREE) return 0;
    for (int i = 0; i < 3; i++)
        if (fabs(view->centre[i]) > FARTHEST * view->size) return 0;
    double values = p->frame.value_error / (16 * (n + 1) * ALGSURF_U + scene->surface->error);
    return fabs(p->per_slope) * p->pixel >= LEAST_PIXEL && in_range(values) && in_range(view->size) &&
           in_range(ldexp(view->size, scene->surface->unit));
}
