/* rays/faces.c - the faces of a ball or a box, and planes, along a ray, without rounding.
 *
 * What is flat is a surface of degree 1 (surface/exact_form.h).  Of a ball all doubles are brought to their
 * lowest common bit 2^-shift; then everything is integers: l(u) = (o - c) + 2^e d u, and R^2 - sum l_i^2. */
#include "../base/arithmetic.h"
#include "faces.h"

#include "../surface/exact_form.h"
#include "../surface/impl.h"

/* Doubles that are added up: bits from the lowest of all to the highest, 0 if there are none but zeros. */
typedef struct range {
    int low, top, empty;
} range;

static void include(range *all, double x, int e) {
    int low, top;
    if (x == 0) return;
    algsurf_limb odd = algsurf_z_odd_part(x, &low);
    low += e, top = low + algsurf_limb_bits(odd);
    if (all->empty || low < all->low) all->low = low;
    if (all->empty || top > all->top) all->top = top;
    all->empty = 0;
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
    for (int i = 0; i < 3; i++)
        include(&all, origin[i], 0), include(&all, x->centre[i], 0), include(&all, direction[i], e);
    include(&all, x->size[0], 0);
    /* |l's coefficients| < 2^bits; four squares with 2 a b: below 2^(2 bits + 3) */
    int bits = all.top - all.low + 1, w = algsurf_z_width(bits), shift = -all.low;
    if (!algsurf_zpoly_new(m, 2, algsurf_z_width(2 * bits + 3), face)) return 0;
    algsurf_memory_mark work = algsurf_memory_here(m);
    algsurf_limb *a = algsurf_memory_take(m, 4 * (size_t)w);
    if (!a) return 0;
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
    algsurf_zpoly_compact(face);
    work.at = face->c + (size_t)(face->degree + 1) * (size_t)face->width; /* what it needs of its room */
    algsurf_memory_release(m, work);
    return 1;
}

/* The points X with n.X <= a + b: the surface a + b - n.X, where it is not negative. */
static int flat(algsurf_memory *m, const double normal[3], double a, double b, const double origin[3],
                const double direction[3], int e, algsurf_zpoly *face) {
    const algsurf_term all[] = {
        {0, 0, 1, -normal[2]}, {0, 1, 0, -normal[1]}, {1, 0, 0, -normal[0]}, {0, 0, 0, a}, {0, 0, 0, b}};
    algsurf_term terms[5];
    algsurf_surface plane = {.degree = 1, .terms = terms};
    for (int i = 0; i < 5; i++)
        if (all[i].a != 0) terms[plane.term_count++] = all[i];
    return algsurf_i_exact_form(m, &plane, origin, direction, e, face, NULL);
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

int algsurf_i_faces(algsurf_memory *m, const algsurf_i_region *region, const double origin[3],
                    const double direction[3], int e, algsurf_zpoly face[ALGSURF_MOST_FACES], int *count) {
    const algsurf_memory_mark before = algsurf_memory_here(m);
    const algsurf_extent *extent = region->extent;
    const int kind = extent ? extent->kind : ALGSURF_EXTENT_ALL;
    int done = 1;
    *count = kind == ALGSURF_EXTENT_SPHERE ? 1 : kind == ALGSURF_EXTENT_BOX ? 6 : 0;
    if (kind == ALGSURF_EXTENT_SPHERE) done = ball(m, extent, origin, direction, e, face);
    if (kind == ALGSURF_EXTENT_BOX) done = box(m, extent, origin, direction, e, face);
    for (size_t i = 0; done && i < region->plane_count; i++)
        done = flat(m, region->planes[i].normal, region->planes[i].offset, 0, origin, direction, e,
                    &face[(*count)++]);
    if (!done) {
        algsurf_memory_release(m, before);
        *count = 0;
    }
    return done;
}
