/* rays/faces.c - the faces of a ball or a box, and planes, along a ray, without rounding.
 *
 * All doubles that are added are brought to their lowest common bit 2^-shift; then everything is integers:
 * l(u) = (o - c) + 2^e d u, and R^2 - sum l_i^2 of a ball.  Of what is flat, normals have a lowest bit of
 * their own, and so have the points o + 2^e d u; offsets have the bits of products. */
#include "../base/arithmetic.h"
#include "faces.h"

/* Doubles that are added up: bits from the lowest of all to the highest, 0 if there are none but zeros. */
typedef struct range {
    int low, top, empty;
} range;

static void include(range *all, double x, int e) {
    int low, top;
    if (x == 0) return;
    algsurf_limb odd = algsurf_z_odd_part(x, &low);
    low += e, top = low + algsurf_z_bits((algsurf_limb[2]){odd, 0}, 2);
    if (all->empty || low < all->low) all->low = low;
    if (all->empty || top > all->top) all->top = top;
    all->empty = 0;
}

/* Compact, and what it does not need then is given back; it is the last that was taken. */
static void settle(algsurf_memory *m, algsurf_zpoly *p) {
    algsurf_memory_mark kept = algsurf_memory_here(m);
    algsurf_zpoly_compact(p);
    kept.at = p->c + (size_t)(p->degree + 1) * (size_t)p->width;
    algsurf_memory_release(m, kept);
}

/* face -= or += (a + b u)^2, the magnitudes of a and b in room for 2 w limbs. */
static void add_square(algsurf_zpoly *face, const algsurf_limb *a, const algsurf_limb *b, int w, int negate,
                       algsurf_limb *room) {
    algsurf_z_factor fa = algsurf_z_factor_of(a, w, room), fb = algsurf_z_factor_of(b, w, room + w);
    int width = face->width;
    algsurf_z_add_times(algsurf_zpoly_at(face, 0), width, a, w, &fa, negate);
    algsurf_z_add_times(algsurf_zpoly_at(face, 1), width, a, w, &fb, negate);
    algsurf_z_add_times(algsurf_zpoly_at(face, 1), width, b, w, &fa, negate);
    algsurf_z_add_times(algsurf_zpoly_at(face, 2), width, b, w, &fb, negate);
}

static int ball(algsurf_memory *m, const algsurf_extent *x, const double origin[3], const double direction[3],
                int e, algsurf_zpoly *face) {
    range all = {0, 0, 1};
    algsurf_memory_mark before = algsurf_memory_here(m);
    for (int i = 0; i < 3; i++)
        include(&all, origin[i], 0), include(&all, x->centre[i], 0), include(&all, direction[i], e);
    include(&all, x->size[0], 0);
    /* |l's coefficients| < 2^bits; four squares with 2 a b: below 2^(2 bits + 3) */
    int bits = all.top - all.low + 1, w = algsurf_z_width(bits), shift = -all.low;
    if (!algsurf_zpoly_new(m, 2, algsurf_z_width(2 * bits + 3), face)) return 0;
    algsurf_memory_mark work = algsurf_memory_here(m);
    algsurf_limb *a = algsurf_memory_take(m, 4 * (size_t)w);
    if (!a) {
        algsurf_memory_release(m, before);
        return 0;
    }
    algsurf_limb *b = a + w;
    for (int i = 0; i <= 3; i++) { /* the last: R */
        algsurf_z_zero(a, 2 * w);
        algsurf_z_add_double(a, w, i < 3 ? origin[i] : x->size[0], shift);
        if (i < 3) {
            algsurf_z_add_double(a, w, -x->centre[i], shift);
            algsurf_z_add_double(b, w, direction[i], shift + e);
        }
        add_square(face, a, b, w, i < 3, a + 2 * w);
    }
    algsurf_memory_release(m, work);
    settle(m, face);
    return 1;
}

/* An integer of w limbs, x 2^shift. */
static const algsurf_limb *integer_of(double x, int shift, int w, algsurf_limb *room) {
    algsurf_z_zero(room, w);
    algsurf_z_add_double(room, w, x, shift);
    return room;
}

/* The points X with n.X <= a + b. */
static int flat(algsurf_memory *m, const double normal[3], double a, double b, const double origin[3],
                const double direction[3], int e, algsurf_zpoly *face) {
    range normals = {0, 0, 1}, points = {0, 0, 1}, offset = {0, 0, 1};
    algsurf_memory_mark before = algsurf_memory_here(m);
    for (int i = 0; i < 3; i++) {
        if (normal[i] == 0) continue;
        include(&normals, normal[i], 0), include(&points, origin[i], 0), include(&points, direction[i], e);
    }
    include(&offset, a, 0), include(&offset, b, 0);
    if (!offset.empty && offset.low - normals.low < points.low) points.low = offset.low - normals.low;
    int low = normals.low + points.low, top = normals.top + points.top;
    if (!offset.empty && offset.top > top) top = offset.top;
    /* four summands: a product of each axis, and one offset; or of one axis, and two */
    int wn = algsurf_z_width(normals.top - normals.low), wp = algsurf_z_width(points.top - points.low);
    if (!algsurf_zpoly_new(m, 1, algsurf_z_width(top - low + 2), face)) return 0;
    algsurf_memory_mark work = algsurf_memory_here(m);
    algsurf_limb *n = algsurf_memory_take(m, 2 * (size_t)wn + (size_t)wp);
    if (!n) {
        algsurf_memory_release(m, before);
        return 0;
    }
    algsurf_limb *x = n + 2 * wn, *c0 = algsurf_zpoly_at(face, 0), *c1 = algsurf_zpoly_at(face, 1);
    algsurf_z_add_double(c0, face->width, a, -low);
    algsurf_z_add_double(c0, face->width, b, -low);
    for (int i = 0; i < 3; i++) {
        if (normal[i] == 0) continue;
        const algsurf_limb *factor = integer_of(normal[i], -normals.low, wn, n);
        const algsurf_z_factor f = algsurf_z_factor_of(factor, wn, n + wn);
        algsurf_z_add_times(c0, face->width, integer_of(origin[i], -points.low, wp, x), wp, &f, 1);
        algsurf_z_add_times(c1, face->width, integer_of(direction[i], e - points.low, wp, x), wp, &f, 1);
    }
    algsurf_memory_release(m, work);
    settle(m, face);
    return 1;
}

/* +-(X_i - c_i) <= h. */
static int box(algsurf_memory *m, const algsurf_extent *x, const double origin[3], const double direction[3],
               int e, algsurf_zpoly face[6]) {
    for (int f = 0; f < 6; f++) {
        int i = f / 2;
        double sign = f % 2 ? -1 : 1, normal[3] = {0, 0, 0};
        normal[i] = sign;
        if (!flat(m, normal, x->size[i], sign * x->centre[i], origin, direction, e, &face[f])) return 0;
    }
    return 1;
}

static int faces_of_extent(algsurf_memory *m, const algsurf_extent *extent, const double origin[3],
                           const double direction[3], int e, algsurf_zpoly face[ALGSURF_MOST_FACES],
                           int *count) {
    *count = 0;
    if (!extent || extent->kind == ALGSURF_EXTENT_ALL) return 1;
    *count = extent->kind == ALGSURF_EXTENT_SPHERE ? 1 : 6;
    return extent->kind == ALGSURF_EXTENT_SPHERE ? ball(m, extent, origin, direction, e, face)
                                                 : box(m, extent, origin, direction, e, face);
}

int algsurf_i_faces(algsurf_memory *m, const algsurf_i_region *region, const double origin[3],
                    const double direction[3], int e, algsurf_zpoly face[ALGSURF_MOST_FACES], int *count) {
    algsurf_memory_mark before = algsurf_memory_here(m);
    int done = faces_of_extent(m, region->extent, origin, direction, e, face, count);
    for (size_t i = 0; done && i < region->plane_count; i++)
        done = flat(m, region->planes[i].normal, region->planes[i].offset, 0, origin, direction, e,
                    &face[(*count)++]);
    if (!done) {
        algsurf_memory_release(m, before);
        *count = 0;
    }
    return done;
}
