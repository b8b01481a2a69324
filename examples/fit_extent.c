/* fit_extent.c - see fit_extent.h.
 *
 * The unit of a polynomial is the length in which its terms of the highest degree are as large as others of
 * lower degree: r = max over k < n of (A_k / A_n)^(1/(n-k)), A_k the largest coefficient of degree k.
 * Everything that is special about a surface, as a rule, is within a few units of the origin.  Where a proof
 * finds all of it within 32 units, and not next to the end, it is bounded as far as eyes can tell, and the
 * extent is a ball about the box of that proof, of high degree the box itself.  The unit of a flat surface is
 * its thickness, so boxes 32 and 1024 times as large are tried, too; a point is shown in a ball of its unit.
 * Else the extent is a ball that shows the singular points, if these are bounded, and 3.5 units in any case;
 * if nothing is in it, twice as much, and so on.  Singular points that lie on a bounded part of it show that
 * part alone.
 *
 * The constants are matters of taste: they were chosen by looking at the pictures of some 200 famous
 * surfaces, of which tests/cli_famous keeps 50.
 */
#include "fit_extent.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double FAR = 32, USUAL = 3.5; /* in units of the polynomial */
static const int FARTHER = 2;              /* larger boxes, each FAR times as large, */
static const int FLAT_DEGREE = 12;         /* for surfaces up to this degree: it takes time */
static const double FLAT = 0.01;           /* of a box's longest edge */
static const int BOX_DEGREE = 13;          /* from it on rays outside the proved box are dear */
static const double NEARLY = 0.95;         /* of the way to the end: what gets there may go on */
static const double ROOM = 1.35;           /* about singular points, in half edges of their box, */
static const double ALONE = 3;             /* and as far as nothing else may be beside what holds them */
static const double SMALL = 0.01;          /* of a unit: it may be a point */
enum { LATTICE = 8 };                      /* rays a side: do they meet it? */
static const double PRECISION = 1.0 / 16;  /* of a box that a proof finds: a sixteenth of its edges */
static const double LEAST_UNIT = 1e-140, MOST_UNIT = 1e140; /* squares are in range */

void fit_demand(algsurf_status *failed, algsurf_status status) {
    if (*failed == ALGSURF_OK) *failed = status;
}

static double unit_of(const algsurf_surface *surface, algsurf_status *failed) {
    double largest[ALGSURF_MAX_DEGREE + 1] = {0}, unit = 0;
    size_t count = algsurf_surface_term_count(surface);
    int n = algsurf_surface_degree(surface);
    algsurf_term *terms = malloc((count + 1) * sizeof *terms);
    if (!terms) {
        fit_demand(failed, ALGSURF_E_NO_MEMORY);
        return 1;
    }
    fit_demand(failed, algsurf_surface_terms(surface, terms));
    for (size_t i = 0; i < count; i++) {
        double *of_degree = &largest[terms[i].i + terms[i].j + terms[i].k];
        *of_degree = fmax(*of_degree, fabs(terms[i].a));
    }
    for (int k = 0; k < n; k++)
        if (largest[k] > 0) unit = fmax(unit, exp((log(largest[k]) - log(largest[n])) / (n - k)));
    free(terms);
    return unit > LEAST_UNIT && unit < MOST_UNIT ? unit : 1;
}

fit_box fit_enclose(const algsurf_surface *surface, const algsurf_extent *extent, algsurf_part part,
                    algsurf_status *failed) {
    fit_box found = {.empty = 1};
    fit_demand(failed,
               algsurf_surface_enclose(surface, extent, part, PRECISION, found.lo, found.hi, &found.empty));
    return found;
}

static fit_box enclose(const algsurf_surface *surface, double half, algsurf_part part,
                       algsurf_status *failed) {
    const algsurf_extent all = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {half, half, half}};
    return fit_enclose(surface, &all, part, failed);
}

/* Is all of it within half the size of a box about the origin? */
static int ends_within(const fit_box *b, double half) {
    for (int i = 0; i < 3; i++)
        if (b->lo[i] < -NEARLY * half || b->hi[i] > NEARLY * half) return 0;
    return !b->empty;
}

double fit_as_told(double x) {
    char text[32];
    snprintf(text, sizeof text, "%.15g", x + 0.0); /* no -0 */
    return strtod(text, NULL);
}

double fit_rounded_up(double x) {
    double step = pow(10, floor(log10(x)) - 1);
    return step > 0 ? fit_as_told(ceil(x / step - 1e-9) * step) : x;
}

double fit_rounded_place(double x, double radius) {
    double step = pow(10, floor(log10(radius)) - 2);
    return step > 0 ? fit_as_told(round(x / step) * step) : x;
}

/* A ball about the box, the corners at that part of its radius or nearer. */
static algsurf_extent ball_about(const fit_box *b) {
    algsurf_extent ball = {.kind = ALGSURF_EXTENT_SPHERE};
    double half[3], square = 0;
    for (int i = 0; i < 3; i++) half[i] = 0.5 * (b->hi[i] - b->lo[i]);
    double radius = sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
    for (int i = 0; i < 3; i++) {
        ball.centre[i] = fit_rounded_place(0.5 * (b->lo[i] + b->hi[i]), radius);
        double far = fmax(b->hi[i] - ball.centre[i], ball.centre[i] - b->lo[i]);
        square += far * far;
    }
    ball.size[0] = fit_rounded_up(sqrt(square));
    return ball;
}

/* The box itself, rounded outward; what is flat gets a little room. */
static algsurf_extent box_about(const fit_box *b) {
    algsurf_extent box = {.kind = ALGSURF_EXTENT_BOX};
    double middle[3], most = fit_half_edge(b, middle);
    for (int i = 0; i < 3; i++) {
        const double half = fmax(0.5 * (b->hi[i] - b->lo[i]), FLAT * most);
        box.centre[i] = fit_rounded_place(middle[i], half);
        box.size[i] = fit_rounded_up(fmax(half, fmax(b->hi[i] - box.centre[i], box.centre[i] - b->lo[i])));
    }
    return box;
}

double fit_half_edge(const fit_box *b, double middle[3]) {
    double half = 0;
    for (int i = 0; i < 3; i++) {
        half = fmax(half, 0.5 * (b->hi[i] - b->lo[i]));
        middle[i] = 0.5 * (b->lo[i] + b->hi[i]);
    }
    return half;
}

/* Is it so small that no ray meets it?  Rays of a lattice, from where an eye usually is.  (Rounded
 * coefficients may have made a point of what is none.) */
static int is_point(const algsurf_surface *surface, const algsurf_extent *ball, algsurf_status *failed) {
    static const double along[3] = {-0.55, 0.71, -0.43},
                        across[2][3] = {{0.79, 0.61, 0}, {-0.26, 0.34, 0.90}};
    if (algsurf_surface_rounding(surface) > 0) return 0;
    for (int i = 0; i < LATTICE * LATTICE && *failed == ALGSURF_OK; i++) {
        const double u = 2.0 * (i % LATTICE) / (LATTICE - 1) - 1, v = 2.0 * (i / LATTICE) / (LATTICE - 1) - 1;
        algsurf_ray ray = {.t_min = -INFINITY, .t_max = INFINITY};
        algsurf_hit hit = {.state = ALGSURF_STATE_MISS};
        for (int k = 0; k < 3; k++) {
            ray.origin[k] = ball->centre[k] + ball->size[0] * (u * across[0][k] + v * across[1][k]);
            ray.direction[k] = along[k];
        }
        fit_demand(failed, algsurf_intersect_first(surface, ball, &ray, NULL, &hit));
        if (hit.state == ALGSURF_STATE_HIT) return 0;
    }
    return 1;
}

static int is_nothing_in(const algsurf_surface *surface, const algsurf_extent *extent,
                         algsurf_status *failed) {
    fit_box b = {.empty = 0};
    fit_demand(failed, algsurf_surface_enclose(surface, extent, ALGSURF_PART_ALL, 1, b.lo, b.hi, &b.empty));
    return b.empty;
}

/* Is all that there is about the singular points a part by itself? */
static int is_apart(const algsurf_surface *surface, const double middle[3], double half, fit_box *part,
                    algsurf_status *failed) {
    const double size = ALONE * half;
    const algsurf_extent about = {ALGSURF_EXTENT_BOX, {middle[0], middle[1], middle[2]}, {size, size, size}};
    *part = fit_enclose(surface, &about, ALGSURF_PART_ALL, failed);
    for (int i = 0; i < 3; i++)
        if (part->lo[i] < middle[i] - NEARLY * size || part->hi[i] > middle[i] + NEARLY * size) return 0;
    return !part->empty;
}

static algsurf_extent unbounded_extent(const algsurf_surface *surface, double unit, algsurf_status *failed) {
    algsurf_extent ball = {.kind = ALGSURF_EXTENT_SPHERE};
    double radius = USUAL * unit, middle[3];
    const fit_box singular = enclose(surface, FAR * unit, ALGSURF_PART_SINGULAR, failed);
    if (ends_within(&singular, FAR * unit)) {
        const double half = fit_half_edge(&singular, middle);
        fit_box part;
        if (half > FIT_POINT * unit && is_apart(surface, middle, half, &part, failed))
            return ball_about(&part);
        radius = fmax(radius, ROOM * half);
        for (int i = 0; i < 3; i++)
            if (fabs(middle[i]) > 0.1 * radius) ball.centre[i] = fit_rounded_place(middle[i], radius);
    }
    ball.size[0] = fit_rounded_up(radius);
    for (int k = 0; k < 8 && is_nothing_in(surface, &ball, failed); k++) ball.size[0] *= 2;
    return ball;
}

algsurf_extent fit_extent(const algsurf_surface *surface, int *bounded, algsurf_status *failed) {
    double unit = unit_of(surface, failed), half = FAR * unit;
    fit_box all = enclose(surface, half, ALGSURF_PART_ALL, failed);
    const int farther = algsurf_surface_degree(surface) <= FLAT_DEGREE ? FARTHER : 0;
    for (int k = 0; k < farther && !ends_within(&all, half); k++) {
        half *= FAR;
        all = enclose(surface, half, ALGSURF_PART_ALL, failed);
    }
    *bounded = all.empty || ends_within(&all, half);
    if (all.empty)
        return (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {fit_rounded_up(FAR * unit), 0, 0}};
    if (!*bounded) return unbounded_extent(surface, unit, failed);
    double middle[3], size = fit_half_edge(&all, middle);
    algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {middle[0], middle[1], middle[2]}, {2 * size, 0, 0}};
    const int alone = size < FIT_POINT * unit || (size < SMALL * unit && is_point(surface, &ball, failed));
    for (int i = 0; i < 3 && alone; i++) {
        all.lo[i] = middle[i] - unit;
        all.hi[i] = middle[i] + unit;
    }
    return alone || algsurf_surface_degree(surface) < BOX_DEGREE ? ball_about(&all) : box_about(&all);
}
