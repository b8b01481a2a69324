/* seed_figures.c - see seed_figures.h; after figures 5 and 8 of Chuyeshov, Visualization of algebraic
 * surfaces. That paper's polynomials are not known in digits: these are found among the rays of the pictures.
 */
#include "seed_figures.h"

#include <math.h>
#include <string.h>

#include "results.h"

/* ---- the curve ---- */

enum { CURVE = 801 };

typedef struct curve {
    double x[CURVE], y[CURVE];
} curve;

static void trace(curve *to, const double *c, int degree, double lo, double hi) {
    for (int i = 0; i < CURVE; i++) {
        to->x[i] = lo + (hi - lo) * i / (CURVE - 1);
        to->y[i] = seed_value(c, degree, to->x[i], NULL);
    }
}

/* ---- Newton's method ---- */

static void iterate(seed_newton *n, int *settled) {
    double x = 0.5 * (n->ray.lo + n->ray.hi);
    *settled = 0;
    for (n->count = 0; n->count <= SEED_STEPS && !*settled && isfinite(x);) {
        double slope, y = seed_value(n->ray.c, n->degree, x, &slope), next = x - y / slope;
        n->x[n->count++] = x;
        *settled = fabs(next - x) <= 1e-12 * fmax(1, fabs(x));
        x = next;
    }
}

/* How good an example it is: how far it goes astray, and how clear of the bracket's ends the root is. */
static double merit(const seed_newton *n) {
    const seed_ray *ray = &n->ray;
    for (int i = 0; i < n->count; i++)
        if (!(fabs(n->x[i]) <= 1)) return 0;
    if (n->count < 5 || n->count > 12) return 0;
    return fabs(n->x[n->count - 1] - ray->root) * fmin(ray->root - ray->lo, ray->hi - ray->root);
}

void seed_newton_census(const seed_view *view, seed_census *census) {
    double best = 0;
    memset(census, 0, sizeof *census);
    for (const seed_ray *ray = view->rays; ray < view->rays + view->count; ray++) {
        seed_newton n = {.ray = *ray, .degree = view->entry->degree};
        int settled;
        if (!ray->bracketed) continue;
        iterate(&n, &settled);
        census->roots++;
        double allowed = seed_allowed(view, ray, 1e-9), end = n.x[n.count - 1];
        int other = settled && fabs(end - ray->root) > allowed && (end < ray->lo || end > ray->hi);
        census->other += other != 0;
        census->lost += !settled;
        if (!other || merit(&n) <= best) continue;
        best = merit(&n);
        census->example = n;
    }
}

/* From each point on the curve down its tangent, and from there to the curve. */
static size_t tangents(const seed_newton *n, double *x, double *y) {
    size_t count = 0;
    for (int i = 0; i < n->count; i++) {
        x[count] = n->x[i], y[count++] = i > 0 ? 0 : NAN;
        x[count] = n->x[i], y[count++] = seed_value(n->ray.c, n->degree, n->x[i], NULL);
    }
    return count;
}

void seed_plot_newton(const seed_newton *n, const char *surface, const char *folder, const char *name) {
    curve c;
    double x[2 * SEED_STEPS + 2], y[2 * SEED_STEPS + 2], on[SEED_STEPS + 1], zero[2] = {0, 0};
    double lo = n->ray.lo, hi = n->ray.hi, ends[2] = {n->ray.lo, n->ray.hi};
    size_t path = tangents(n, x, y);
    for (int i = 0; i < n->count; i++) {
        on[i] = y[2 * i + 1];
        lo = fmin(lo, n->x[i]);
        hi = fmax(hi, n->x[i]);
    }
    double margin = 0.05 * (hi - lo), axis[2] = {lo - margin, hi + margin};
    trace(&c, n->ray.c, n->degree, axis[0], axis[1]);
    const plot_series series[] = {{"P along the ray", PLOT_LINE, c.x, c.y, CURVE},
                                  {"tangents, start in the middle of the bracket", PLOT_LINE, x, y, path},
                                  {"first root (default method)", PLOT_POINTS, &n->ray.root, zero, 1},
                                  {"Newton's points", PLOT_POINTS, n->x, on, (size_t)n->count},
                                  {NULL, PLOT_LINE, axis, zero, 2},
                                  {"bracket", PLOT_BOTH, ends, zero, 2}};
    char title[160];
    snprintf(title, sizeof title, "Newton's method catches the wrong root (%s)", surface);
    const plot p = {
        .title = title,
        .x = {.label = "along the ray (half chords from its middle)", .lo = axis[0], .hi = axis[1]},
        .y = {.label = "P"},
        .series = series,
        .count = sizeof series / sizeof *series};
    results_plot(&p, 1, folder, name);
}

/* ---- regula falsi ---- */

enum { POINTS = 1000, STEP = 10, SHOWN = POINTS / STEP };

/* The error after so many evaluations, for limits of iterations that grow: the methods need not tell their
 * points.  Returns how many. */
static size_t approach(const seed_ray *ray, int degree, int m, double *evaluations, double *error) {
    size_t count = 0;
    for (int most = 1; most <= POINTS; most += 1 + most / 40) {
        algsurf_refined_root root;
        if (m == SEED_REGULA_FALSI)
            (void)seed_false_position(ray->c, degree, ray->lo, ray->hi, 0, 0, most, &root);
        else
            (void)seed_solve(&seed_methods[m], ray->c, degree, ray->lo, ray->hi, 0, most, &root);
        if (count > 0 && root.evaluations == (int)evaluations[count - 1]) break; /* done */
        evaluations[count] = root.evaluations;
        error[count++] = fmax(fabs(root.root - ray->root), 1e-16);
    }
    return count;
}

static void plot_approach(plot *p, const seed_ray *ray, int degree, double (*x)[POINTS], double (*y)[POINTS],
                          plot_series *series) {
    for (int m = 0; m < SEED_METHODS; m++) {
        size_t count = approach(ray, degree, m, x[m], y[m]);
        series[m] = (plot_series){seed_methods[m].name, PLOT_LINE, x[m], y[m], count};
    }
    *p = (plot){.title = "How fast the methods get there, same bracket",
                .x = {.label = "evaluations of P", .scale = PLOT_LOG},
                .y = {.label = "error (half chords)", .scale = PLOT_LOG},
                .series = series,
                .count = SEED_METHODS};
}

/* Every tenth point of plain false position: the end of the bracket that moves. */
static void creep(const seed_ray *ray, int degree, double *x, double *y) {
    for (int i = 0; i < SHOWN; i++) {
        algsurf_refined_root root;
        (void)seed_false_position(ray->c, degree, ray->lo, ray->hi, 0, 0, STEP * i + 1, &root);
        x[i] = root.lo != ray->lo ? root.lo : root.hi;
        y[i] = seed_value(ray->c, degree, x[i], NULL);
    }
}

void seed_plot_creep(const seed_ray *ray, int degree, const char *surface, const char *folder,
                     const char *name) {
    static double x[SEED_METHODS][POINTS], y[SEED_METHODS][POINTS];
    curve c;
    double points[SHOWN], values[SHOWN], zero[2] = {0, 0}, ends[2] = {ray->lo, ray->hi};
    plot_series approaches[SEED_METHODS];
    char title[160];
    trace(&c, ray->c, degree, ray->lo, ray->hi);
    creep(ray, degree, points, values);
    const plot_series series[] = {
        {"P along the ray", PLOT_LINE, c.x, c.y, CURVE},
        {"every 10th of the first 1000 points of regula falsi", PLOT_POINTS, points, values, SHOWN},
        {"root", PLOT_POINTS, &ray->root, zero, 1},
        {NULL, PLOT_LINE, ends, zero, 2}};
    snprintf(title, sizeof title, "A polynomial that defeats regula falsi (%s)", surface);
    plot column[2] = {{.title = title,
                       .x = {.label = "along the ray, the bracket (half chords from its middle)"},
                       .y = {.label = "P", .scale = PLOT_SYMLOG},
                       .series = series,
                       .count = sizeof series / sizeof *series}};
    plot_approach(&column[1], ray, degree, x, y, approaches);
    results_plot(column, 2, folder, name);
}
