/* fit_extent.c - see fit_extent.h.
 *
 * The unit of a polynomial is the length in which its terms of the highest degree are as large as others of
 * lower degree: r = max over k < n of (A_k / A_n)^(1/(n-k)), A_k the largest coefficient of degree k.
 * Everything that is special about a surface, as a rule, is within a few units of the origin.  Where a proof
 * finds all of it within 32 units, and not next to the end, it is bounded as far as eyes can tell, and the
 * extent is a ball about the box of that proof.  The unit of a flat surface is its thickness, so boxes 32 and
 * 1024 times as large are tried, too.  Else the extent is a ball that shows the singular points, if these are
 * bounded, and 3.5 units in any case; if nothing is in it, twice as much, and so on.
 *
 * The constants are matters of taste: they were chosen by looking at the pictures of some 200 famous
 * surfaces, of which tests/cli_famous keeps 50.
 */
#include "fit_extent.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double FAR = 32, USUAL = 3.5; /* in units of the polynomial */
static const int FARTHER = 2;              /* larger boxes, each FAR times as large */
static const double NEARLY = 0.95;         /* of the way to the end: what gets there may go on */
static const double ROOM = 1.35;           /* about singular points, in half edges of their box */
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
    return fit_as_told(ceil(x / step - 1e-9) * step);
}

double fit_rounded_place(double x, double radius) {
    double step = pow(10, floor(log10(radius)) - 2);
    return fit_as_told(round(x / step) * step);
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

double fit_half_edge(const fit_box *b, double middle[3]) {
    double half = 0;
    for (int i = 0; i < 3; i++) {
        half = fmax(half, 0.5 * (b->hi[i] - b->lo[i]));
        middle[i] = 0.5 * (b->lo[i] + b->hi[i]);
    }
    return half;
}

static int is_nothing_in(const algsurf_surface *surface, const algsurf_extent *extent,
                         algsurf_status *failed) {
    fit_box b = {.empty = 0};
    fit_demand(failed, algsurf_surface_enclose(surface, extent, ALGSURF_PART_ALL, 1, b.lo, b.hi, &b.empty));
    return b.empty;
}

static algsurf_extent unbounded_extent(const algsurf_surface *surface, double unit, algsurf_status *failed) {
    algsurf_extent ball = {.kind = ALGSURF_EXTENT_SPHERE};
    double radius = USUAL * unit, middle[3];
    const fit_box singular = enclose(surface, FAR * unit, ALGSURF_PART_SINGULAR, failed);
    if (ends_within(&singular, FAR * unit)) {
        double half = fit_half_edge(&singular, middle);
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
    for (int k = 0; k < FARTHER && !ends_within(&all, half); k++) {
        half *= FAR;
        all = enclose(surface, half, ALGSURF_PART_ALL, failed);
    }
    *bounded = all.empty || ends_within(&all, half);
    if (all.empty)
        return (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {fit_rounded_up(FAR * unit), 0, 0}};
    if (!*bounded) return unbounded_extent(surface, unit, failed);
    double middle[3], point = fit_half_edge(&all, middle);
    for (int i = 0; i < 3 && point < FIT_POINT * unit; i++) {
        all.lo[i] = middle[i] - unit;
        all.hi[i] = middle[i] + unit;
    }
    return ball_about(&all);
}
