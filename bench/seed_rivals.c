/* seed_rivals.c - see seed.h.
 *
 * False position: the zero of the chord takes the place of the end with its sign.
 * Illinois: the same, but an end that stays a second time counts with half its value (Dowell, Jarratt, A
 * modified regula falsi method for computing the root of an equation, BIT 11, 1971).
 * Chandrupatla: inverse quadratic interpolation where it is safe, by one test for all, else halving (A new
 * hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without using
 * derivatives, Advances in Engineering Software 28, 1997).
 * ITP: the zero of the chord, truncated towards the middle and projected to where halving could have been by
 * then (Oliveira, Takahashi, An enhancement of the bisection method average performance preserving minmax
 * optimality, ACM TOMS 47, 2021), with the constants its authors recommend: k1 = 0.2/(b-a), k2 = 2, n0 = 1.
 *
 * All stop as the library's methods do: at a zero, or when half the bracket is at most the tolerance plus
 * rounding.  They evaluate by Horner's rule in place; the library does so through a pointer, and also guards
 * the floating-point environment.
 */
#include "seed.h"

#include <float.h>
#include <math.h>

double seed_value(const double *c, int degree, double x, double *slope) {
    double y = c[degree], dy = 0;
    for (int i = degree - 1; i >= 0; i--) {
        if (slope) dy = dy * x + y;
        y = y * x + c[i];
    }
    if (slope) *slope = dy;
    return y;
}

typedef struct bracket {
    const double *c;
    int degree;
    double tolerance;
    int most;
    double a, b, fa, fb; /* b is the newest point, or one of two */
    int evaluations, iterations;
} bracket;

static double value(bracket *s, double x) {
    s->evaluations++;
    return seed_value(s->c, s->degree, x, NULL);
}

static bracket start(const double *c, int degree, double lo, double hi,
                     const algsurf_refine_options *options) {
    bracket s = {.c = c, .degree = degree, .a = lo, .b = hi};
    s.tolerance = 0.5 * options->absolute_tolerance;
    s.most = options->max_iterations ? options->max_iterations : 1000;
    s.fa = value(&s, lo);
    s.fb = value(&s, hi);
    return s;
}

static double better(const bracket *s) { return fabs(s->fa) < fabs(s->fb) ? s->a : s->b; }

/* Half the width that is narrow enough. */
static double wanted(const bracket *s) { return s->tolerance + 0x1p-51 * fmax(fabs(better(s)), DBL_MIN); }

static int done(const bracket *s) { return s->fa == 0 || s->fb == 0 || 0.5 * fabs(s->b - s->a) <= wanted(s); }

static int running(const bracket *s) { return !done(s) && s->iterations < s->most; }

static algsurf_status finish(const bracket *s, algsurf_refined_root *r) {
    int first = fabs(s->fa) < fabs(s->fb);
    *r = (algsurf_refined_root){.root = better(s),
                                .lo = fmin(s->a, s->b),
                                .hi = fmax(s->a, s->b),
                                .residual = first ? s->fa : s->fb,
                                .evaluations = s->evaluations,
                                .iterations = s->iterations,
                                .converged = done(s)};
    return r->converged ? ALGSURF_OK : ALGSURF_NOT_CONVERGED;
}

/* The zero of the chord from (b, fb) to (a, fa). */
static double chord(const bracket *s, double fa) { return s->b - s->fb * ((s->b - s->a) / (s->fb - fa)); }

algsurf_status seed_false_position(const double *c, int degree, double lo, double hi, double tolerance,
                                   double small, int most, algsurf_refined_root *result) {
    const algsurf_refine_options options = {
        .size = sizeof options, .absolute_tolerance = 2 * tolerance, .max_iterations = most};
    bracket s = start(c, degree, lo, hi, &options);
    while (running(&s) && fabs(s.fa) > small && fabs(s.fb) > small) {
        double x = chord(&s, s.fa), y = value(&s, x);
        s.iterations++;
        if ((y < 0) != (s.fb < 0)) s.a = s.b, s.fa = s.fb;
        s.b = x, s.fb = y;
    }
    return finish(&s, result);
}

static algsurf_status illinois(const double *c, int degree, double lo, double hi,
                               const algsurf_refine_options *options, algsurf_refined_root *result) {
    bracket s = start(c, degree, lo, hi, options);
    double weight = 1; /* of the end that stayed */
    while (running(&s)) {
        double x = chord(&s, weight * s.fa), y = value(&s, x);
        s.iterations++;
        weight *= 0.5;
        if ((y < 0) != (s.fb < 0)) s.a = s.b, s.fa = s.fb, weight = 1;
        s.b = x, s.fb = y;
    }
    return finish(&s, result);
}

/* Where, from a (0) to b (1), a parabola in the values through three points is zero; or the middle. */
static double quadratic(const bracket *s, double d, double fd) {
    double xi = (s->a - s->b) / (d - s->b), phi = (s->fa - s->fb) / (fd - s->fb);
    if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)) return 0.5;
    return s->fa / (s->fb - s->fa) * (fd / (s->fb - fd)) +
           (d - s->a) / (s->b - s->a) * (s->fa / (fd - s->fa)) * (s->fb / (fd - s->fb));
}

/* a is the newest point, b the other end; d was an end before. */
static algsurf_status chandrupatla(const double *c, int degree, double lo, double hi,
                                   const algsurf_refine_options *options, algsurf_refined_root *result) {
    bracket s = start(c, degree, lo, hi, options);
    double part = 0.5;
    while (running(&s)) {
        double x = s.a + part * (s.b - s.a), y = value(&s, x), d = s.a, fd = s.fa;
        s.iterations++;
        if ((y < 0) != (s.fa < 0)) d = s.b, fd = s.fb, s.b = s.a, s.fb = s.fa;
        s.a = x, s.fa = y;
        double least = wanted(&s) / fabs(s.b - s.a);
        part = fmin(1 - least, fmax(least, quadratic(&s, d, fd)));
    }
    return finish(&s, result);
}

static algsurf_status itp(const double *c, int degree, double lo, double hi,
                          const algsurf_refine_options *options, algsurf_refined_root *result) {
    bracket s = start(c, degree, lo, hi, options);
    double least = s.tolerance + 0x1p-51 * fmax(fmax(fabs(lo), fabs(hi)), DBL_MIN);
    double k1 = 0.2 / (hi - lo), reach = least * exp2(fmax(0, ceil(log2((hi - lo) / (2 * least)))) + 1);
    while (running(&s)) {
        double width = s.b - s.a, middle = s.a + 0.5 * width, estimate = chord(&s, s.fa);
        double radius = fmax(0, reach - 0.5 * width), side = copysign(1, middle - estimate);
        double step = k1 * width * width;
        double truncated = step <= fabs(middle - estimate) ? estimate + side * step : middle;
        double x = fabs(truncated - middle) <= radius ? truncated : middle - side * radius;
        double y = value(&s, x);
        s.iterations++;
        if ((y < 0) == (s.fa < 0))
            s.a = x, s.fa = y;
        else
            s.b = x, s.fb = y;
        reach *= 0.5;
    }
    return finish(&s, result);
}

static algsurf_status by_library(const double *c, int degree, double lo, double hi,
                                 const algsurf_refine_options *options, algsurf_refined_root *result) {
    return algsurf_refine_poly(c, NULL, degree, lo, hi, options, result);
}

const seed_method seed_methods[SEED_METHODS] = {
    {"bisection", by_library, ALGSURF_METHOD_BISECTION, 1, 0},
    {"regula falsi", by_library, ALGSURF_METHOD_REGULA_FALSI, 1, 1},
    {"Brent", by_library, ALGSURF_METHOD_BRENT, 1, 0},
    {"default", by_library, ALGSURF_METHOD_DEFAULT, 1, 0},
    {"Illinois", illinois, ALGSURF_METHOD_DEFAULT, 0, 0},
    {"Chandrupatla", chandrupatla, ALGSURF_METHOD_DEFAULT, 0, 0},
    {"ITP", itp, ALGSURF_METHOD_DEFAULT, 0, 0}};

algsurf_status seed_solve(const seed_method *method, const double *c, int degree, double lo, double hi,
                          double tolerance, int most, algsurf_refined_root *result) {
    const algsurf_refine_options options = {.size = sizeof options,
                                            .method = method->method,
                                            .max_iterations = most,
                                            .absolute_tolerance = 2 * tolerance};
    return method->solve(c, degree, lo, hi, &options, result);
}
