/* seed_figures.c - see seed.h; after figures 5 and 8 of Chuyeshov, Visualization of algebraic
 * surfaces. That paper's polynomials are not known in digits: these are found among the rays of the pictures.
 */
#include "seed.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "chart.h"

/* P between two places. */
static void draw_curve(chart *c, const double *p, int degree, double lo, double hi) {
    enum { POINTS = 801 };
    chart_series(c, "P along the ray", PLOT_LINE);
    for (int i = 0; i < POINTS; i++) {
        double x = lo + (hi - lo) * i / (POINTS - 1);
        chart_point(c, x, seed_value(p, degree, x, NULL));
    }
}

/* From one place to another on the axis. */
static void draw_axis(chart *c, const char *name, plot_mark mark, double lo, double hi) {
    chart_series(c, name, mark);
    chart_point(c, lo, 0);
    if (hi > lo) chart_point(c, hi, 0);
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

void seed_plot_newton(const seed_newton *n, const char *surface, const char *folder, const char *name) {
    const seed_ray *ray = &n->ray;
    double lo = ray->lo, hi = ray->hi;
    chart c = {.plot.y.label = "P"};
    for (int i = 0; i < n->count; i++) {
        lo = fmin(lo, n->x[i]);
        hi = fmax(hi, n->x[i]);
    }
    const double margin = 0.05 * (hi - lo), begin = lo - margin, end = hi + margin;
    snprintf(c.title, sizeof c.title, "Newton's method catches the wrong root (%s)", surface);
    c.plot.x = (plot_axis){.label = "along the ray (half chords from its middle)", .lo = begin, .hi = end};
    draw_curve(&c, ray->c, n->degree, begin, end);
    chart_series(&c, "tangents, start in the middle of the bracket", PLOT_LINE);
    for (int i = 0; i < n->count; i++) { /* up to the curve, and down the tangent */
        chart_point(&c, n->x[i], i > 0 ? 0 : NAN);
        chart_point(&c, n->x[i], seed_value(ray->c, n->degree, n->x[i], NULL));
    }
    draw_axis(&c, "first root (default method)", PLOT_POINTS, ray->root, ray->root);
    chart_series(&c, "Newton's points", PLOT_POINTS);
    for (int i = 0; i < n->count; i++) chart_point(&c, n->x[i], seed_value(ray->c, n->degree, n->x[i], NULL));
    draw_axis(&c, NULL, PLOT_LINE, begin, end);
    draw_axis(&c, "bracket", PLOT_BOTH, ray->lo, ray->hi);
    chart_write(&c, 1, folder, name);
}

/* ---- regula falsi ---- */

enum { POINTS = 1000, STEP = 10 };

/* The error after so many evaluations, for limits of iterations that grow: the methods need not tell their
 * points. */
static void draw_approach(chart *c, const seed_ray *ray, int degree, int m) {
    int before = 0;
    chart_series(c, seed_methods[m].name, PLOT_LINE);
    for (int most = 1; most <= POINTS; most += 1 + most / 40) {
        algsurf_refined_root root;
        if (m == SEED_REGULA_FALSI)
            (void)seed_false_position(ray->c, degree, ray->lo, ray->hi, 0, 0, most, &root);
        else
            (void)seed_solve(&seed_methods[m], ray->c, degree, ray->lo, ray->hi, 0, most, &root);
        if (root.evaluations == before) break; /* done */
        before = root.evaluations;
        chart_point(c, before, fmax(fabs(root.root - ray->root), 1e-16));
    }
}

/* Of plain false position: the end of the bracket that moves. */
static void draw_creep(chart *c, const seed_ray *ray, int degree) {
    chart_series(c, "every 10th of the first 1000 points of regula falsi", PLOT_POINTS);
    for (int most = 1; most <= POINTS; most += STEP) {
        algsurf_refined_root root;
        (void)seed_false_position(ray->c, degree, ray->lo, ray->hi, 0, 0, most, &root);
        const double x = root.lo != ray->lo ? root.lo : root.hi;
        chart_point(c, x, seed_value(ray->c, degree, x, NULL));
    }
}

void seed_plot_creep(const seed_ray *ray, int degree, const char *surface, const char *folder,
                     const char *name) {
    chart column[2] = {{.plot = {.x = {.label = "along the ray, the bracket (half chords from its middle)"},
                                 .y = {.label = "P", .scale = PLOT_SYMLOG}}},
                       {.plot = {.title = "How fast the methods get there, same bracket",
                                 .x = {.label = "evaluations of P", .scale = PLOT_LOG},
                                 .y = {.label = "error (half chords)", .scale = PLOT_LOG}}}};
    snprintf(column[0].title, sizeof column[0].title, "A polynomial that defeats regula falsi (%s)", surface);
    draw_curve(&column[0], ray->c, degree, ray->lo, ray->hi);
    draw_creep(&column[0], ray, degree);
    draw_axis(&column[0], "root", PLOT_POINTS, ray->root, ray->root);
    draw_axis(&column[0], NULL, PLOT_LINE, ray->lo, ray->hi);
    for (int m = 0; m < SEED_METHODS; m++) draw_approach(&column[1], ray, degree, m);
    chart_write(column, 2, folder, name);
}
