/* allroots.c - all complex roots with proof: scaling, the order of the steps, solvers.
 *
 * For what the lanes leave open (lanes.c), and all else: propose in double, tighten with doubled residuals,
 * prove by discs; what then is still crowded is iterated in double-double and proved again.  Roots of a real
 * polynomial that look real are put on the axis, and of the others one of each pair is tightened and
 * mirrored: it is the proof that decides whether that was right.  Clusters of an exact real polynomial are
 * then asked for multiple roots (multiple.c). */
#include "../base/arithmetic.h"
#include "algsurf/allroots.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "impl.h"
#include "../base/fpenv.h"
#include "../base/options.h"

struct algsurf_complex_solver {
    int max_degree;
    algsurf_i_roots p;
    algsurf_complex_root *boxes;
};

/* Slices of a block of ALGSURF_ROOTS_DOUBLES * (m+1) doubles and ALGSURF_ROOTS_INTS * (m+1) ints. */
static void lay_out(algsurf_i_roots *p, int m, double *d, int *k) {
    double **part[] = {&p->cr, &p->ci, &p->size, &p->radius, &p->lr, &p->li,       &p->ls,
                       &p->le, &p->x,  &p->y,    &p->xl,     &p->yl, &p->residual, &p->disc};
    int **ints[] = {&p->exponent, &p->group, &p->done, &p->shift};
    for (int i = 0; i < ALGSURF_ROOTS_DOUBLES; i++) *part[i] = d + i * (m + 1);
    for (int i = 0; i < ALGSURF_ROOTS_INTS; i++) *ints[i] = k + i * (m + 1);
}

static int vanishes(const algsurf_complex *c, const double *r, int k) {
    return c[k].re == 0 && c[k].im == 0 && (!r || r[k] == 0);
}

static double magnitude(algsurf_complex z) { return fmax(fabs(z.re), fabs(z.im)); }

static algsurf_status read_input(const algsurf_complex *c, const double *r, int degree, int real_radii,
                                 algsurf_i_input *in) {
    if (!c || degree < 0) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k <= degree; k++) {
        if (!isfinite(c[k].re) || !isfinite(c[k].im) || (r && !isfinite(r[k]))) return ALGSURF_E_NOT_FINITE;
        if (r && r[k] < 0) return ALGSURF_E_ARGUMENT;
    }
    *in = (algsurf_i_input){c, r, 0, degree, real_radii, 0};
    while (in->high >= 0 && vanishes(c, r, in->high)) in->high--;
    if (in->high < 0) return ALGSURF_E_ZERO;
    while (vanishes(c, r, in->low)) in->low++;
    return ALGSURF_OK;
}

/* The larger of coefficient low + k and its radius. */
static double extent(const algsurf_i_input *in, int k) {
    return fmax(magnitude(in->c[in->low + k]), in->r ? in->r[in->low + k] : 0);
}

/* The extreme slopes of Newton's polygon, which are about the exponents of the least and the largest root:
 * each is attained from one end of the polygon. */
static void outermost(const algsurf_i_input *in, double *least, double *largest) {
    int n = in->high - in->low, first = ilogb(extent(in, 0)), last = ilogb(extent(in, n));
    *least = HUGE_VAL, *largest = -HUGE_VAL;
    for (int k = 0; k <= n; k++) {
        if (!(extent(in, k) > 0)) continue;
        int e = ilogb(extent(in, k));
        if (k > 0) *least = fmin(*least, (double)(first - e) / k);
        if (k < n) *largest = fmax(*largest, (double)(e - last) / (n - k));
    }
}

/* The first and the last coefficient balance.  Where an extreme root would then come near the limits of
 * double, the extreme roots do; and when their exponents are too far apart for that, the largest gets the
 * largest start value there is (below 2^1010): a small root out of reach is one box about 0, a large one
 * spoils them all. */
int algsurf_i_roots_unit(const algsurf_i_input *in) {
    int n = in->high - in->low;
    if (n == 0) return 0;
    double unit = (double)(ilogb(extent(in, 0)) - ilogb(extent(in, n))) / n, least,
           largest; /* neither is 0 */
    outermost(in, &least, &largest);
    return (int)lround(unit - least < 900 && largest - unit < 900
                           ? unit
                           : fmax(0.5 * least + 0.5 * largest, largest - 1010));
}

/* The unit of the variable.  Narrow, if no coefficient then falls 2^500 below the largest, whose exponent is
 * returned. */
static int choose_unit(algsurf_i_roots *p, const algsurf_i_input *in, int *common) {
    int n = p->n, least = 0x7fffffff, unit = algsurf_i_roots_unit(in);
    *common = -0x7fffffff;
    for (int k = 0; k <= n; k++) {
        double m = extent(in, k);
        if (!(m > 0)) continue;
        int e = ilogb(m) + k * unit;
        *common = e > *common ? e : *common;
        least = e < least ? e : least;
    }
    p->narrow = *common - least < 500;
    return unit;
}

static int scale(algsurf_i_roots *p, const algsurf_i_input *in) {
    int common, n = p->n = in->high - in->low, unit = choose_unit(p, in, &common);
    p->real = 1;
    for (int k = 0; k <= n; k++) {
        algsurf_complex c = in->c[in->low + k];
        double r = in->r ? in->r[in->low + k] : 0, m = extent(in, k);
        int whole = k * unit - common, own = p->narrow ? whole : m > 0 ? -ilogb(m) : 0;
        p->shift[k] = whole - own;
        p->cr[k] = ldexp(c.re, own);
        p->ci[k] = ldexp(c.im, own);
        p->size[k] = sqrt(p->cr[k] * p->cr[k] + p->ci[k] * p->ci[k]) * (1 + 4 * ALGSURF_U);
        /* A part far below the other one may lose bits. */
        p->radius[k] =
            ldexp(r, own) + (ldexp(p->cr[k], -own) != c.re || ldexp(p->ci[k], -own) != c.im) * 0x1p-1070;
        if (c.im != 0 || (r > 0 && !in->real_radii)) p->real = 0;
    }
    return unit;
}

/* Roots of a real polynomial: those close to the axis onto it, the others paired.  mate[i] >= 0: root i is
 * to be the conjugate of that one.  Uses group as mate. */
static void guess_symmetry(algsurf_i_roots *p) {
    int *mate = p->group;
    for (int i = 0; i < p->n; i++) {
        mate[i] = -1;
        if (p->real && fabs(p->y[i]) < 0x1p-26 * fabs(p->x[i])) p->y[i] = 0;
    }
    for (int i = 0; p->real && i < p->n; i++) {
        if (!(p->y[i] < 0)) continue;
        double best = 0x1p-20 * (fabs(p->x[i]) + fabs(p->y[i]));
        for (int j = 0; j < p->n; j++) {
            double d = fabs(p->x[i] - p->x[j]) + fabs(p->y[i] + p->y[j]);
            if (p->y[j] > 0 && d < best) {
                best = d;
                mate[i] = j;
            }
        }
    }
}

static void tighten_all(algsurf_i_roots *p) {
    int *mate = p->group;
    for (int i = 0; i < p->n; i++) {
        p->xl[i] = p->yl[i] = 0;
        p->residual[i] = mate[i] < 0 ? HUGE_VAL : 0;
        p->exponent[i] = 0;
    }
    algsurf_i_roots_tighten(p);
    for (int i = 0; i < p->n; i++) {
        int j = mate[i];
        if (j < 0) continue;
        p->x[i] = p->x[j];
        p->xl[i] = p->xl[j];
        p->y[i] = -p->y[j];
        p->yl[i] = -p->yl[j];
        p->residual[i] = p->residual[j];
        p->exponent[i] = p->exponent[j];
    }
}

/* The larger part of an ulp of the smaller part of root i. */
static double fine(const algsurf_i_roots *p, int i) {
    double least = p->y[i] == 0 ? fabs(p->x[i]) : fmin(fabs(p->x[i]), fabs(p->y[i]));
    return 0x1p-54 * least;
}

/* Isolated roots whose discs would make their boxes wider than an ulp get another step; returns how many. */
static int tighten_wide(algsurf_i_roots *p) {
    int again = 0;
    for (int i = 0; i < p->n; i++) {
        if (!p->done[i] || p->disc[i] <= 0.25 * fine(p, i)) continue;
        again++;
        p->residual[i] = HUGE_VAL;
        p->xl[i] = p->yl[i] = 0;
    }
    if (again) algsurf_i_roots_tighten(p);
    return again;
}

/* What still is wide then is ill conditioned: a step in double-double. */
static int sharpen_wide(algsurf_i_roots *p) {
    int again = 0;
    for (int i = 0; i < p->n; i++) {
        if (!p->done[i] || p->disc[i] <= fine(p, i)) continue;
        again++;
        algsurf_i_roots_sharpen(p, i);
    }
    return again;
}

static int solve_scaled(algsurf_i_roots *p, const algsurf_complex *start, int unit,
                        algsurf_complex_root *boxes) {
    algsurf_i_roots_start(p);
    for (int i = 0; start && i < p->n; i++) { /* what is no number keeps its own start value */
        if (!isfinite(start[i].re) || !isfinite(start[i].im)) continue;
        p->x[i] = ldexp(start[i].re, -unit);
        p->y[i] = ldexp(start[i].im, -unit);
    }
    algsurf_i_roots_propose(p);
    guess_symmetry(p);
    tighten_all(p);
    int crowded = algsurf_i_roots_group(p);
    if (tighten_wide(p)) crowded = algsurf_i_roots_group(p);
    if (sharpen_wide(p)) crowded = algsurf_i_roots_group(p);
    if (crowded) {
        algsurf_i_roots_retry(p);
        (void)algsurf_i_roots_group(p);
    }
    return algsurf_i_roots_boxes(p, boxes);
}

/* x 2^unit rounded outward; a root beyond the range of double gets an infinite end.  What is rounded to 0
 * from below, or was -0, becomes +0. */
static double unscale(double x, int unit, int side) {
    double y = ldexp(x, unit);
    if (isinf(y) && (y > 0) != (side > 0)) return y > 0 ? DBL_MAX : -DBL_MAX;
    if (!isinf(y) && ldexp(y, -unit) != x) y = nextafter(y, side < 0 ? -HUGE_VAL : HUGE_VAL);
    return y + 0.0;
}

/* A root's value in its box: the high part for a simple root, the middle for a cluster. */
static double value_in(algsurf_interval box, double high, int unit, int multiplicity) {
    double x = multiplicity == 1 ? ldexp(high, unit) : 0.5 * box.lo + 0.5 * box.hi;
    return fmin(fmax(fmin(fmax(x, box.lo), box.hi), -DBL_MAX), DBL_MAX) + 0.0;
}

/* Boxes in the caller's unit, and the exact root 0; returns their number, -1 when there are none to give.
 * Boxes that differ only beyond the range of double become one. */
static int unscale_all(const algsurf_i_roots *p, const algsurf_i_input *in, algsurf_complex_root *e,
                       int count, int unit) {
    for (int i = 0; i < count; i++) {
        algsurf_cinterval *b = &e[i].box;
        b->re = (algsurf_interval){unscale(b->re.lo, unit, -1), unscale(b->re.hi, unit, 1)};
        b->im = (algsurf_interval){unscale(b->im.lo, unit, -1), unscale(b->im.hi, unit, 1)};
        if (!(b->re.lo <= b->re.hi && b->im.lo <= b->im.hi)) return -1;
    }
    if (in->low > 0) e[count++] = (algsurf_complex_root){{{0, 0}, {0, 0}}, {0, 0}, in->low, 1};
    count = algsurf_i_roots_join(e, count, p->real);
    for (int i = 0; i < count; i++) {
        e[i].root.re = value_in(e[i].box.re, e[i].root.re, unit, e[i].multiplicity);
        e[i].root.im = value_in(e[i].box.im, e[i].root.im, unit, e[i].multiplicity);
    }
    return count;
}

static int compare(const void *left, const void *right) {
    const algsurf_complex_root *a = left, *b = right;
    if (a->root.re != b->root.re) return a->root.re < b->root.re ? -1 : 1;
    return (a->root.im > b->root.im) - (a->root.im < b->root.im);
}

void algsurf_i_roots_sort(algsurf_complex_root *roots, int count) {
    qsort(roots, (size_t)count, sizeof *roots, compare);
}

ALGSURF_NOINLINE algsurf_status algsurf_i_roots_solve(algsurf_i_roots *p, const algsurf_i_input *in,
                                                      const algsurf_complex *start,
                                                      algsurf_complex_root *boxes,
                                                      algsurf_complex_root *roots, int *count) {
    int unit = scale(p, in), n = 0;
    if (!(p->size[p->n] * (1 - 8 * ALGSURF_U) > p->radius[p->n])) return ALGSURF_E_RANGE;
    if (p->n > 0) n = solve_scaled(p, start, unit, boxes);
    n = unscale_all(p, in, boxes, n, unit + in->unit);
    if (n < 0) return ALGSURF_E_RANGE;
    algsurf_i_roots_sort(boxes, n);
    for (int i = 0; i < n; i++) roots[i] = boxes[i];
    *count = n;
    return ALGSURF_OK;
}

static algsurf_status run(algsurf_i_roots *p, const algsurf_i_input *in, const algsurf_complex *start,
                          algsurf_complex_root *boxes, algsurf_complex_root *roots, int *count) {
    p->iterations = p->retries = 0;
    algsurf_status status = algsurf_i_roots_solve(p, in, start, boxes, roots, count);
    if (status == ALGSURF_OK) algsurf_i_roots_separate(p, in, boxes, roots, count);
    return status;
}

algsurf_status algsurf_i_roots_run(algsurf_i_roots_memory *memory, const algsurf_complex *c, const double *r,
                                   int degree, int real_radii, const algsurf_complex *start,
                                   algsurf_complex_root *roots, int *count) {
    algsurf_i_input in;
    algsurf_status status = read_input(c, r, degree, real_radii, &in);
    if (status != ALGSURF_OK) return status;
    lay_out(&memory->p, ALGSURF_MAX_DEGREE, memory->doubles, memory->ints);
    memory->p.iterations = memory->p.retries = 0;
    return algsurf_i_roots_solve(&memory->p, &in, start, memory->boxes, roots, count);
}

static ALGSURF_NOINLINE algsurf_status run_on_stack(const algsurf_i_input *in, algsurf_complex_root *roots,
                                                    int *count) {
    algsurf_i_roots_memory memory;
    lay_out(&memory.p, ALGSURF_MAX_DEGREE, memory.doubles, memory.ints);
    return run(&memory.p, in, NULL, memory.boxes, roots, count);
}

static algsurf_status run_on_heap(const algsurf_i_input *in, int degree, algsurf_complex_root *roots,
                                  int *count) {
    algsurf_complex_solver *solver;
    algsurf_status status = algsurf_complex_solver_create(degree, &solver);
    if (status != ALGSURF_OK) return status;
    status = run(&solver->p, in, NULL, solver->boxes, roots, count);
    algsurf_complex_solver_free(solver);
    return status;
}

algsurf_status algsurf_i_roots_alone(const algsurf_complex *c, const double *r, int degree, int real_radii,
                                     algsurf_complex_root *roots, int *count) {
    algsurf_i_input in;
    algsurf_status status = read_input(c, r, degree, real_radii, &in);
    if (status != ALGSURF_OK) return status;
    return degree <= ALGSURF_MAX_DEGREE ? run_on_stack(&in, roots, count)
                                        : run_on_heap(&in, degree, roots, count);
}

algsurf_status algsurf_complex_solver_create(int max_degree, algsurf_complex_solver **solver) {
    if (!solver || max_degree < 1) return ALGSURF_E_ARGUMENT;
    if (max_degree > ALGSURF_MAX_POLY_DEGREE) return ALGSURF_E_DEGREE;
    algsurf_complex_solver *s = malloc(sizeof *s);
    size_t m = (size_t)max_degree;
    double *d = malloc(ALGSURF_ROOTS_DOUBLES * (m + 1) * sizeof *d);
    int *k = malloc(ALGSURF_ROOTS_INTS * (m + 1) * sizeof *k);
    algsurf_complex_root *boxes = malloc((m + 1) * sizeof *boxes);
    if (!s || !d || !k || !boxes) {
        free(s);
        free(d);
        free(k);
        free(boxes);
        return ALGSURF_E_NO_MEMORY;
    }
    s->max_degree = max_degree;
    s->boxes = boxes;
    lay_out(&s->p, max_degree, d, k);
    *solver = s;
    return ALGSURF_OK;
}

void algsurf_complex_solver_free(algsurf_complex_solver *solver) {
    if (!solver) return;
    free(solver->p.cr);
    free(solver->p.exponent);
    free(solver->boxes);
    free(solver);
}

algsurf_status algsurf_complex_solver_run(algsurf_complex_solver *solver, const algsurf_complex *c,
                                          const double *r, int degree, const algsurf_complex *start,
                                          algsurf_complex_root *roots, int *count,
                                          algsurf_complex_solver_stats *stats) {
    if (!solver || !roots || !count || (stats && !algsurf_options_fit(stats, sizeof *stats))) return ALGSURF_E_ARGUMENT;
    if (degree > solver->max_degree) return ALGSURF_E_DEGREE;
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_i_input in;
    algsurf_status status = read_input(c, r, degree, 0, &in);
    if (status == ALGSURF_OK) status = run(&solver->p, &in, start, solver->boxes, roots, count);
    algsurf_fpenv_leave(&saved);
    if (status >= ALGSURF_OK && stats) {
        algsurf_complex_solver_stats known = {0, solver->p.iterations, solver->p.retries};
        algsurf_options_write(stats, &known, sizeof known);
    }
    return status;
}
