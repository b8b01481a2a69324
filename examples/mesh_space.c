/* mesh_space.c - see mesh_space.h. */
#include "mesh_space.h"

#include <math.h>
#include <stdlib.h>

static const double OFF[3] = {0.2360679775, -0.1547005384, 0.0857864376}; /* sqrt 5, 4/3 sqrt 3, 2 sqrt 2 */
static const double LEAST = 1e-30, MOST = 1e30; /* squares of areas are in range, and floats */

/* That of the power of two above all three. */
static int exponent(const double v[3]) {
    int e;
    (void)frexp(fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2]))), &e);
    return e;
}

algsurf_status mesh_space_begin(mesh_space *space, int cells) {
    const algsurf_extent *extent = &space->extent;
    const int is_box = extent->kind == ALGSURF_EXTENT_BOX;
    double size[3], longest = 0;
    for (int a = 0; a < 3; a++) space->point[a] = NULL;
    if (cells < MESH_LEAST_CELLS || cells > MESH_MOST_CELLS || extent->kind == ALGSURF_EXTENT_ALL ||
        space->plane_count > ALGSURF_MAX_CLIP_PLANES)
        return ALGSURF_E_ARGUMENT;
    for (size_t i = 0; i < space->plane_count; i++) {
        const int e = exponent(space->planes[i].normal);
        space->plane[i].offset = ldexp(space->planes[i].offset, -e);
        for (int a = 0; a < 3; a++) space->plane[i].normal[a] = ldexp(space->planes[i].normal[a], -e);
    }
    for (int a = 0; a < 3; a++) {
        size[a] = extent->size[is_box ? a : 0];
        longest = fmax(longest, size[a]);
    }
    space->h = 2 * longest / (cells - 2);
    for (int a = 0; a < 3; a++) {
        const double far = fabs(extent->centre[a]) + size[a];
        if (!(longest >= LEAST && far <= MOST && far + MESH_MARGIN * space->h > far)) return ALGSURF_E_RANGE;
        const int n = 2 + (int)ceil(2 * size[a] / space->h - 1e-9);
        space->cells[a] = n < MESH_LEAST_CELLS ? MESH_LEAST_CELLS : n;
        space->point[a] = malloc(((size_t)space->cells[a] + 1) * sizeof(double));
        if (!space->point[a]) return ALGSURF_E_NO_MEMORY;
        for (int i = 0; i <= space->cells[a]; i++)
            space->point[a][i] = extent->centre[a] + space->h * (i - 0.5 * space->cells[a] + OFF[a]);
    }
    return ALGSURF_OK;
}

void mesh_space_end(mesh_space *space) {
    for (int a = 0; a < 3; a++) {
        free(space->point[a]);
        space->point[a] = NULL;
    }
}

double mesh_length(const double v[3]) {
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (square > 0x1p-900 && square < INFINITY) return sqrt(square);
    const int e = exponent(v); /* squares were not in range */
    const double w[3] = {ldexp(v[0], -e), ldexp(v[1], -e), ldexp(v[2], -e)};
    return ldexp(sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]), e);
}

/* Divides by the length; 0 where there is none. */
static int unit(double normal[3], double *distance) {
    const double length = mesh_length(normal);
    if (!(length > 0) || !isfinite(length)) return 0;
    for (int a = 0; a < 3; a++) normal[a] /= length;
    *distance /= length;
    return isfinite(*distance);
}

int mesh_space_part(const mesh_space *space, int part, const double x[3], double *distance,
                    double normal[3]) {
    const algsurf_extent *extent = &space->extent;
    if (part == MESH_SURFACE)
        return algsurf_surface_gradient(space->surface, x, distance, normal, NULL, NULL) == ALGSURF_OK &&
               unit(normal, distance);
    if (part >= MESH_PLANE) {
        const algsurf_plane *plane = &space->plane[part - MESH_PLANE];
        *distance = -plane->offset;
        for (int a = 0; a < 3; a++) {
            normal[a] = plane->normal[a];
            *distance += normal[a] * x[a];
        }
        return unit(normal, distance);
    }
    if (extent->kind == ALGSURF_EXTENT_BOX) {
        const int axis = (part - MESH_BOX) / 2, sign = (part - MESH_BOX) % 2 ? 1 : -1;
        for (int a = 0; a < 3; a++) normal[a] = a == axis ? sign : 0;
        *distance = sign * (x[axis] - extent->centre[axis]) - extent->size[axis];
        return 1;
    }
    double square = 0, none = 0;
    for (int a = 0; a < 3; a++) {
        normal[a] = x[a] - extent->centre[a];
        square += normal[a] * normal[a];
    }
    *distance = sqrt(square) - extent->size[0];
    return unit(normal, &none);
}

/* Narrows the span to an interval whose ends are on two parts. */
static void narrow(double span[2], int part[2], double low, int low_part, double high, int high_part) {
    if (low > span[0]) span[0] = low, part[0] = low_part;
    if (high < span[1]) span[1] = high, part[1] = high_part;
}

int mesh_space_span(const mesh_space *space, int axis, const double x[3], double span[2], int part[2]) {
    const algsurf_extent *extent = &space->extent;
    const double centre = extent->centre[axis];
    span[0] = -INFINITY, span[1] = INFINITY;
    part[0] = part[1] = MESH_BALL;
    if (extent->kind == ALGSURF_EXTENT_BOX) {
        for (int a = 0; a < 3; a++)
            if (a != axis && fabs(x[a] - extent->centre[a]) > extent->size[a]) return 0;
        narrow(span, part, centre - extent->size[axis], MESH_BOX + 2 * axis, centre + extent->size[axis],
               MESH_BOX + 2 * axis + 1);
    } else {
        double square = extent->size[0] * extent->size[0];
        for (int a = 0; a < 3; a++)
            if (a != axis) square -= (x[a] - extent->centre[a]) * (x[a] - extent->centre[a]);
        if (!(square > 0)) return 0;
        narrow(span, part, centre - sqrt(square), MESH_BALL, centre + sqrt(square), MESH_BALL);
    }
    for (size_t i = 0; i < space->plane_count; i++) {
        const algsurf_plane *plane = &space->plane[i];
        const double along = plane->normal[axis];
        const int which = MESH_PLANE + (int)i;
        double rest = plane->offset;
        for (int a = 0; a < 3; a++)
            if (a != axis) rest -= plane->normal[a] * x[a];
        if (along > 0) narrow(span, part, -INFINITY, 0, rest / along, which);
        if (along < 0) narrow(span, part, rest / along, which, INFINITY, 0);
        if (along == 0 && rest < 0) return 0;
    }
    return span[0] < span[1];
}
