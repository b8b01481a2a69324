/* zerofind_plot.c - see zerofind_plot.h.
 *
 * Three charts, one below the other: the whole chord; the bracket of the first root with the iterates in it;
 * distances from the root by number.  Values that are all of a size stand on a linear axis, others on a
 * symmetric logarithmic one whose linear middle ends below the lowest hump between roots.
 */
#include "zerofind_plot.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "plot.h"

/* Numbers of the series, hence their colours and marks, the same in all charts. */
enum { CURVE, ITERATES, OTHERS, ROOT, ZERO, BRACKET, ENDS, UNDECIDED, SERIES };

enum {
    EVENLY = 900,                       /* samples, more than the pixels of a chart's width */
    NEAR = 40,                          /* samples on each side of a root, at halved distances */
    MOST_HITS = ALGSURF_MAX_DEGREE + 1, /* zerofind_solve.h */
    MOST_SAMPLES = EVENLY + 1 + 2 * NEAR * MOST_HITS
};

/* Largest over lowest values that a linear axis still shows well: a hump 1/40 of its height is 4 pixels. */
static const double LINEAR_RANGE = 40;
static const double LEAST_GAP = 1e-3; /* of the width: roots closer than that show no hump between them */
static const double CLOSE_UP = 1e-3; /* of half the chord: what is shown about an undecided place, at least */
static const double NOISE = 100;     /* times the noise: values at the ends of what is shown, at least */
static const double MARGIN = 0.04;   /* of the width, on both sides */

typedef struct chart {
    double s_lo, s_hi; /* what it shows */
    double anchor;     /* what it subtracts from t */
    char label[160], title[200];
    double s[MOST_SAMPLES], t[MOST_SAMPLES], p[MOST_SAMPLES];
    size_t samples;
    double other_t[MOST_HITS], bands[2 * MOST_HITS];
    double point_t[ZEROFIND_MOST_POINTS], point_p[ZEROFIND_MOST_POINTS];
    double root_t, bracket[2], ends[2], line[2];
    plot_series series[SERIES];
} chart;

static const double zeros[MOST_HITS];

static double t_in(const chart *c, const chord *on, double s) {
    return fma(on->half, s, on->middle - c->anchor);
}

/* ---- the curve ---- */

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double value_at(const chord *on, double s) {
    double value = 0, bound;
    (void)algsurf_poly_value_compensated(on->c, NULL, on->degree, s, &value, &bound);
    return value;
}

static void sample(chart *c, const zerofind *z) {
    const chord *on = &z->chord;
    double lo = fmax(-1, c->s_lo), hi = fmin(1, c->s_hi), width = hi - lo;
    for (int i = 0; i <= EVENLY; i++) c->s[c->samples++] = lo + width * i / EVENLY;
    for (int k = 0; k < z->count; k++) {
        double root = chord_s(on, z->hits[k].t), step = 0.5 * width;
        for (int i = 0; i < NEAR; i++, step *= 0.5)
            for (int side = -1; side <= 1; side += 2)
                if (root + side * step > lo && root + side * step < hi)
                    c->s[c->samples++] = root + side * step;
    }
    qsort(c->s, c->samples, sizeof *c->s, by_value);
    for (size_t i = 0; i < c->samples; i++) {
        c->t[i] = t_in(c, on, c->s[i]);
        c->p[i] = value_at(on, c->s[i]);
    }
}

/* ---- axes ---- */

/* Numbers that agree in their first digits are shown as differences from those. */
static void choose_t_axis(chart *c, const zerofind *z, const char *label) {
    double from = chord_t(&z->chord, c->s_lo), to = chord_t(&z->chord, c->s_hi), width = to - from;
    double size = fmax(fabs(from), fabs(to));
    snprintf(c->label, sizeof c->label, "%s", label);
    if (!(width < LEAST_GAP * size)) return;
    char text[64];
    double middle = from + 0.5 * width;
    int decimals = (int)fmax(0, ceil(-log10(fmax(width, DBL_EPSILON * size))));
    int plain = size < 1e15 && decimals <= 15;
    snprintf(text, sizeof text, plain ? "%.*f" : "%.*g", plain ? decimals : 15, middle);
    c->anchor = strtod(text, NULL);
    snprintf(c->label, sizeof c->label, "t \xe2\x88\x92 %s%s", text, label + 1);
}

/* The largest value between each two neighbouring roots (and ends), the least of these. */
static double lowest_hump(const chart *c, const zerofind *z, double largest) {
    double lowest = largest, from = c->s[0];
    size_t i = 0;
    for (int k = 0; k <= z->count; k++) {
        double to = k < z->count ? chord_s(&z->chord, z->hits[k].t) : c->s[c->samples - 1], hump = 0;
        for (; i < c->samples && c->s[i] <= to; i++) hump = fmax(hump, fabs(c->p[i]));
        if (to - from > LEAST_GAP * (c->s_hi - c->s_lo) && hump > 0) lowest = fmin(lowest, hump);
        from = fmax(from, to);
    }
    return lowest;
}

static double median_size(const chart *c) {
    static double sizes[MOST_SAMPLES];
    for (size_t i = 0; i < c->samples; i++) sizes[i] = fabs(c->p[i]);
    qsort(sizes, c->samples, sizeof *sizes, by_value);
    return sizes[c->samples / 2];
}

static plot_axis value_axis(const chart *c, const zerofind *z) {
    plot_axis axis = {.label = "P*(t)"};
    double largest = 0;
    for (size_t i = 0; i < c->samples; i++) largest = fmax(largest, fabs(c->p[i]));
    double low = fmin(lowest_hump(c, z, largest), median_size(c));
    if (!(largest > LINEAR_RANGE * low)) return axis;
    axis.label = "P*(t), symmetric logarithm";
    axis.scale = PLOT_SYMLOG;
    axis.linear = fmax(pow(10, floor(log10(fmax(low, DBL_MIN) / 3))), DBL_MIN);
    return axis;
}

static plot_axis t_axis(const chart *c, const chord *on) {
    double margin = MARGIN * (c->s_hi - c->s_lo);
    return (plot_axis){
        .label = c->label, .lo = t_in(c, on, c->s_lo - margin), .hi = t_in(c, on, c->s_hi + margin)};
}

/* ---- a chart of P*(t) ---- */

static plot_series series(const char *name, plot_mark mark, const double *x, const double *y, size_t count) {
    return (plot_series){count > 0 ? name : NULL, mark, x, y, count};
}

static int is_shown(const chart *c, double s) { return c->s_lo <= s && s <= c->s_hi; }

/* The ends of the chord, as far as they can be seen. */
static void add_ends(chart *c, const chord *on) {
    size_t count = 0;
    for (int s = -1; s <= 1; s += 2)
        if (is_shown(c, s)) c->ends[count++] = t_in(c, on, s);
    c->series[ENDS] = series("ends of the chord", PLOT_RULES, c->ends, NULL, count);
}

static void add_hits(chart *c, const zerofind *z) {
    const chord *on = &z->chord;
    size_t others = 0, open = 0;
    int first_is_hit = z->count > 0 && z->hits[0].state == ALGSURF_STATE_HIT;
    for (int k = 0; k < z->count; k++) {
        const algsurf_hit *hit = &z->hits[k];
        if (hit->state != ALGSURF_STATE_HIT) {
            c->bands[open++] = t_in(c, on, chord_s(on, hit->t_lo));
            c->bands[open++] = t_in(c, on, chord_s(on, hit->t_hi));
        } else if (k > 0 && is_shown(c, chord_s(on, hit->t))) {
            c->other_t[others++] = t_in(c, on, chord_s(on, hit->t));
        }
    }
    if (first_is_hit) {
        c->root_t = z->hits[0].t - c->anchor;
        c->bracket[0] = t_in(c, on, chord_s(on, z->bracket ? z->bracket->t_lo : z->hits[0].t_lo));
        c->bracket[1] = t_in(c, on, chord_s(on, z->bracket ? z->bracket->t_hi : z->hits[0].t_hi));
    }
    c->series[OTHERS] = series("other roots", PLOT_POINTS, c->other_t, zeros, others);
    c->series[ROOT] = series("first root", PLOT_POINTS, &c->root_t, zeros, (size_t)first_is_hit);
    c->series[BRACKET] = series("isolating bracket", PLOT_BANDS, c->bracket, NULL, first_is_hit ? 2 : 0);
    c->series[UNDECIDED] = series("undecided", PLOT_BANDS, c->bands, NULL, open);
}

static void add_iterates(chart *c, const zerofind *z) {
    for (int k = 0; k < z->point_count; k++) {
        c->point_t[k] = z->points[k].t - c->anchor;
        c->point_p[k] = z->points[k].value;
    }
    c->series[ITERATES] =
        series("evaluations, in their order", PLOT_NUMBERED, c->point_t, c->point_p, (size_t)z->point_count);
}

/* What s_lo .. s_hi shows; close: with the iterates. */
static plot make_chart(chart *c, const zerofind *z, const char *t_label, int close) {
    const chord *on = &z->chord;
    choose_t_axis(c, z, t_label);
    sample(c, z);
    plot_axis x = t_axis(c, on), y = value_axis(c, z);
    c->line[0] = x.lo;
    c->line[1] = x.hi;
    c->series[CURVE] = series("P*(t)", PLOT_LINE, c->t, c->p, c->samples);
    c->series[ZERO] = series(NULL, PLOT_LINE, c->line, zeros, 2);
    add_ends(c, on);
    add_hits(c, z);
    if (close) add_iterates(c, z);
    return (plot){.title = c->title, .x = x, .y = y, .series = c->series, .count = SERIES, .height = 360};
}

/* ---- convergence ---- */

typedef struct convergence {
    double k[ZEROFIND_MOST_POINTS], distance[ZEROFIND_MOST_POINTS], width[ZEROFIND_MOST_POINTS];
    plot_series series[SERIES];
} convergence;

static plot make_convergence(convergence *v, const zerofind *z) {
    enum { FEW = 60 }; /* more of them make a line */
    size_t count = (size_t)z->point_count;
    for (size_t i = 0; i < count; i++) {
        const zerofind_point *p = &z->points[i];
        v->k[i] = (double)i;
        v->distance[i] = fabs(p->t - z->hits[0].t);
        v->width[i] = p->t_hi - p->t_lo;
    }
    v->series[ITERATES] =
        series("|t \xe2\x88\x92 first root|", count > FEW ? PLOT_LINE : PLOT_BOTH, v->k, v->distance, count);
    v->series[CURVE] = series("width of the bracket", PLOT_STEPS, v->k, v->width, count);
    return (plot){
        .title = "Convergence",
        .subtitle = "What is exactly 0 is left out.",
        .x = {.label = "number of the evaluation", .lo = 0, .hi = fmax(10, 1.04 * (double)(count - 1))},
        .y = {.label = "in units of t", .scale = PLOT_LOG},
        .series = v->series,
        .count = SERIES,
        .height = 300};
}

/* ---- words ---- */

static const char *method_name(int method) {
    switch (method) {
    case ALGSURF_METHOD_BRENT:
        return "Brent's method";
    case ALGSURF_METHOD_BISECTION:
        return "bisection";
    case ALGSURF_METHOD_REGULA_FALSI:
        return "regula falsi";
    default:
        return "the library's own steps";
    }
}

static void describe_root(const zerofind *z, int digits, char *text, size_t size) {
    const algsurf_hit *first = z->hits;
    if (first->multiplicity == 0)
        snprintf(text, size, "The ray lies in the surface.");
    else if (z->bracket)
        snprintf(text, size,
                 "First root: t = %.15g, multiplicity %d, isolated in %.*g to %.*g by %s: verified.",
                 first->t, first->multiplicity, digits, z->bracket->t_lo, digits, z->bracket->t_hi,
                 z->bracket->engine == ALGSURF_ENGINE_INTEGERS ? "integers" : "doubles");
    else
        snprintf(text, size, "First root: t = %.15g, multiplicity %d: verified.", first->t,
                 first->multiplicity);
}

static void describe(const zerofind *z, const zerofind_words *words, char *text, size_t size) {
    const chord *on = &z->chord;
    const algsurf_hit *first = z->hits;
    int digits = (int)fmin(17, 8 + fmax(0, log10(fabs(on->middle) / on->half)));
    int length = snprintf(text, size, "%s; the chord is t = %.*g to %.*g. ", words->ray, digits, on->t_in,
                          digits, on->t_out);
    text += length;
    size -= (size_t)length;
    if (z->count == 0)
        snprintf(text, size, "There is no root on it: verified.");
    else if (first->state != ALGSURF_STATE_HIT)
        snprintf(text, size, "Undecided near t = %.15g: %s.", first->t, algsurf_status_text(first->reason));
    else
        describe_root(z, digits, text, size);
}

/* How far values are meaningless: what the errors of the coefficients can change on the chord. */
static double noise_of(const chord *on) {
    double noise = 0;
    for (int k = 0; k <= on->degree; k++) noise += on->r[k];
    return noise;
}

/* How far from a place without iterates the polynomial can be told from noise. */
static double clear_of_noise(const chord *on, double lo, double hi) {
    double noise = noise_of(on), margin = CLOSE_UP;
    while (margin < 0.5 && fabs(value_at(on, lo - margin)) < NOISE * noise &&
           fabs(value_at(on, hi + margin)) < NOISE * noise)
        margin *= 2;
    return margin;
}

/* The part of the chord for the second chart; returns 0 when there is none. */
static int close_up(const zerofind *z, const zerofind_words *words, chart *c) {
    const algsurf_hit *first = z->hits;
    int is_hit = z->count > 0 && first->state == ALGSURF_STATE_HIT;
    if (z->count == 0 || (is_hit && first->multiplicity == 0)) return 0;
    c->s_lo = chord_s(&z->chord, first->t_lo);
    c->s_hi = chord_s(&z->chord, first->t_hi);
    if (is_hit && z->bracket && z->point_count > 0) {
        c->s_lo = chord_s(&z->chord, z->bracket->t_lo);
        c->s_hi = chord_s(&z->chord, z->bracket->t_hi);
        snprintf(c->title, sizeof c->title, "The bracket: %s, %d evaluations", method_name(words->method),
                 z->point_count);
        return 1;
    }
    if (is_hit && !(-1 < c->s_lo && c->s_hi < 1)) return 0;
    double margin = clear_of_noise(&z->chord, c->s_lo, c->s_hi);
    c->s_lo = fmax(-1, c->s_lo - margin);
    c->s_hi = fmin(1, c->s_hi + margin);
    snprintf(c->title, sizeof c->title, "%s, close up", is_hit ? "The first root" : "What is undecided");
    return c->s_lo > -1 || c->s_hi < 1;
}

int zerofind_plot(const zerofind *z, const zerofind_words *words, FILE *out) {
    chart *charts = calloc(2, sizeof *charts), *whole = charts, *close = charts + 1;
    convergence *course = calloc(1, sizeof *course);
    char about[640];
    int failed = -1;
    if (charts && course) {
        plot plots[3];
        size_t count = 0;
        describe(z, words, about, sizeof about);
        snprintf(whole->title, sizeof whole->title, "P*(t) of %s, degree %d", words->surface,
                 z->chord.degree);
        whole->s_lo = -1, whole->s_hi = 1;
        plots[count++] = make_chart(whole, z, words->t_label, 0);
        plots[0].subtitle = about;
        plots[0].height = 400;
        if (close_up(z, words, close)) plots[count++] = make_chart(close, z, words->t_label, 1);
        if (z->point_count > 0) plots[count++] = make_convergence(course, z);
        failed = plot_put_column(plots, count, out);
    }
    free(charts);
    free(course);
    return failed;
}
