/* first_hit.c - the smallest program that uses libalgsurf on surfaces: a sphere and two rays.
 *
 *     cc -O2 -I../include first_hit.c $(find ../lib -name "*.c") -lm -pthread -o first_hit
 */
#include <math.h>
#include <stdio.h>

#include "algsurf/algsurf.h"

static void shoot(const algsurf_surface *surface, const algsurf_ray *ray) {
    algsurf_hit hit;
    algsurf_status status = algsurf_intersect_first(surface, NULL, ray, NULL, &hit);
    if (status < 0) {
        printf("failed: %s\n", algsurf_status_text(status));
    } else if (hit.state == ALGSURF_STATE_HIT) {
        printf("hit at t = %g, point (%g, %g, %g), normal (%g, %g, %g)\n", hit.t, hit.position[0],
               hit.position[1], hit.position[2], hit.normal[0], hit.normal[1], hit.normal[2]);
    } else {
        printf("%s\n", hit.state == ALGSURF_STATE_MISS ? "miss" : "undecided");
    }
}

int main(int argc, char **argv) {
    if (argc > 1) {
        fprintf(stderr, "%s: takes no arguments\n", argv[0]);
        return 2;
    }
    algsurf_surface *sphere;
    if (algsurf_surface_from_equation("x^2 + y^2 + z^2 = 1", NULL, 0, &sphere, NULL) != ALGSURF_OK) return 1;

    /* origin, direction, t_min, t_max */
    algsurf_ray through = {{-3, 0, 0.5}, {1, 0, 0}, 0, INFINITY};
    algsurf_ray past = {{-3, 0, 1.5}, {1, 0, 0}, 0, INFINITY};
    shoot(sphere, &through);
    shoot(sphere, &past);

    algsurf_surface_free(sphere);
    return 0;
}
