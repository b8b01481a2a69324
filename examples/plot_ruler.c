/* plot_ruler.c - see plot_ruler.h.
 *
 * Places are proportional to the value, to its logarithm, or (symmetric logarithm) to v/L for |v| <= L and
 * to sign(v) (1 + log10 |v/L|) beyond: the linear middle is as wide as a decade on each side of 0.
 * Linear ticks are 1, 2 or 5 times a power of ten apart; logarithmic ones are powers of ten, with the
 * multiples between them where there is room.
 */
#include "plot_ruler.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "ticks.h"

static const double MARGIN = 0.04; /* of the axis, free on both sides of the data */
static const double LEAST = 1e-12; /* of the largest value: smaller ones get no decades of a symmetric axis */

int plot_scale_shows(plot_scale scale, double value) {
    return isfinite(value) && (scale != PLOT_LOG || value > 0);
}

/* ---- the range ---- */

/* To the place's unit and back: without ends. */
static double forward(const plot_ruler *r, double v) {
    if (r->scale == PLOT_LOG) return log10(v);
    if (r->scale == PLOT_LINEAR) return v;
    double size = fabs(v) / r->linear;
    return copysign(size <= 1 ? size : 1 + log10(size), v);
}

static double backward(const plot_ruler *r, double place) {
    if (r->scale == PLOT_LOG) return pow(10, place);
    if (r->scale == PLOT_LINEAR) return place;
    double size = fabs(place);
    return copysign(r->linear * (size <= 1 ? size : pow(10, size - 1)), place);
}

static double power_below(double value) { return pow(10, floor(log10(value) + 1e-9)); }

/* A linear middle that ends where the smallest values are. */
static double choose_linear(const double *values, size_t count) {
    double least = INFINITY, largest = 0;
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i]) || values[i] == 0) continue;
        least = fmin(least, fabs(values[i]));
        largest = fmax(largest, fabs(values[i]));
    }
    return largest > 0 ? power_below(fmax(least, largest * LEAST)) : 1;
}

/* A single value, or none at all, in the middle of something. */
static void widen(plot_ruler *r) {
    if (r->lo < r->hi) return;
    if (r->lo > r->hi) r->lo = r->hi = 1;
    if (r->scale == PLOT_LOG) {
        r->lo /= 3;
        r->hi *= 3;
    } else {
        double half = r->lo != 0 ? 0.5 * fabs(r->lo) : 1;
        r->lo -= half;
        r->hi += half;
    }
}

static void add_margins(plot_ruler *r, int with_zero) {
    double lo = forward(r, r->lo), hi = forward(r, r->hi), margin = MARGIN * (hi - lo);
    int bottom = r->scale != PLOT_LOG && (r->lo == 0 || (with_zero && r->lo >= 0));
    double least = r->lo;
    if (!bottom) r->lo = backward(r, lo - margin);
    if (r->scale == PLOT_LOG && with_zero) r->lo = power_below(least * 0.999);
    r->hi = fmin(backward(r, hi + margin), DBL_MAX);
    r->lo = r->scale == PLOT_LOG ? fmax(r->lo, DBL_MIN) : fmax(r->lo, -DBL_MAX);
}

plot_ruler plot_ruler_make(const plot_axis *axis, const double *values, size_t count, int with_zero) {
    plot_ruler r = {axis->scale, axis->lo, axis->hi, axis->linear};
    if (r.scale == PLOT_SYMLOG && !(r.linear > 0)) r.linear = choose_linear(values, count);
    if (axis->lo < axis->hi && plot_scale_shows(r.scale, axis->lo) && isfinite(axis->hi)) return r;
    r.lo = INFINITY, r.hi = -INFINITY;
    if (with_zero && r.scale != PLOT_LOG) r.lo = r.hi = 0;
    for (size_t i = 0; i < count; i++) {
        if (!plot_scale_shows(r.scale, values[i])) continue;
        r.lo = fmin(r.lo, values[i]);
        r.hi = fmax(r.hi, values[i]);
    }
    widen(&r);
    add_margins(&r, with_zero);
    return r;
}

double plot_ruler_at(const plot_ruler *r, double value) {
    if (!plot_scale_shows(r->scale, value)) return NAN;
    double lo = forward(r, r->lo), hi = forward(r, r->hi);
    return fmax(-1000, fmin(1000, (forward(r, value) - lo) / (hi - lo)));
}

/* ---- ticks ---- */

double plot_text_width(const char *text) {
    double width = 0;
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if ((c & 0xc0) != 0x80)
            width += c == ' ' || c == '.' || c == ',' || c == 'i' || c == 'l' ? 0.32 : 0.6;
    }
    return width;
}

#define MINUS "\xe2\x88\x92"
#define TIMES "\xc2\xb7"

/* The digits of a number, with a true minus sign. */
static void put_number(char *text, size_t size, double value, int decimals) {
    snprintf(text, size, "%s%.*f", value < 0 ? MINUS : "", decimals, fabs(value));
}

static void put_power(plot_tick *t, double mantissa, int decimals, int exponent) {
    char digits[32] = "", power[16];
    if (mantissa == -1)
        snprintf(digits, sizeof digits, MINUS);
    else if (mantissa != 1)
        put_number(digits, sizeof digits, mantissa, decimals);
    put_number(power, sizeof power, exponent, 0);
    const char *dot = fabs(mantissa) == 1 ? "" : TIMES;
    snprintf(t->text, sizeof t->text, "%s%s10<tspan dy='-0.45em' font-size='80%%'>%s</tspan>", digits, dot,
             power);
    t->width = plot_text_width(digits) + plot_text_width(dot) + 1.2 + 0.8 * plot_text_width(power);
}

/* How many decimals a multiple of the step has. */
static int decimals_of(double step) { return (int)fmax(0, ceil(-log10(step) - 1e-9)); }

static int exponent_of(double value) { return (int)floor(log10(fabs(value)) + 1e-9); }

/* A number on an axis whose numbers are multiples of a step and at most `largest`. */
static void put_value(plot_tick *t, double value, double step, double largest) {
    if (largest < 1e5 && step >= 0.999e-4) {
        put_number(t->text, sizeof t->text, value, decimals_of(step));
        t->width = plot_text_width(t->text);
    } else if (value == 0) {
        put_number(t->text, sizeof t->text, 0, 0);
        t->width = 0.6;
    } else {
        double unit = pow(10, exponent_of(value));
        put_power(t, value / unit, decimals_of(step / unit), exponent_of(value));
    }
}

typedef struct tick_list {
    const plot_ruler *ruler;
    plot_tick *ticks;
    int count;
} tick_list;

/* The next tick, without text; null when the value lies outside the axis. */
static plot_tick *add(tick_list *list, double value) {
    double at = plot_ruler_at(list->ruler, value);
    if (list->count >= PLOT_MOST_TICKS || !(at > -1e-9 && at < 1 + 1e-9)) return NULL;
    plot_tick *t = &list->ticks[list->count++];
    *t = (plot_tick){.at = at};
    return t;
}

static void linear_ticks(tick_list *list, int most) {
    const plot_ruler *r = list->ruler;
    double step = ticks_size(ticks_step((r->hi - r->lo) / most)), largest = fmax(fabs(r->lo), fabs(r->hi));
    for (double k = ceil(r->lo / step - 1e-9); k * step <= r->hi + 1e-9 * step; k++) {
        plot_tick *t = add(list, k * step);
        if (!t) break;
        put_value(t, k * step, step, largest);
    }
}

/* How many decades lie between two that get a number. */
static int decade_stride(double decades, int most) {
    static const int strides[] = {1, 2, 3, 5, 10, 20, 50, 100};
    int i = 0;
    while (i < 7 && decades / strides[i] > most) i++;
    return strides[i];
}

/* 1..9 (or -1) times a power of ten; plain: as a decimal number. */
static void put_multiple(plot_tick *t, int multiple, int exponent, int plain) {
    if (plain || exponent == 0) {
        put_number(t->text, sizeof t->text, multiple * pow(10, exponent), exponent < 0 ? -exponent : 0);
        t->width = plot_text_width(t->text);
    } else {
        put_power(t, multiple, 0, exponent);
    }
}

static void log_ticks(tick_list *list, int most) {
    const plot_ruler *r = list->ruler;
    double decades = log10(r->hi / r->lo);
    int stride = decade_stride(decades, most), plain = r->lo > 0.9e-3 && r->hi < 1e5;
    int dense = decades * 9 <= most, some = decades * 3 <= most;
    int finest = stride < 10 ? 1 : stride / 10, first = exponent_of(r->lo);
    for (int k = first - first % finest; k <= exponent_of(r->hi); k += finest)
        for (int m = 1; m < 10; m++) {
            if (m > 1 && stride > 1) break;
            plot_tick *t = add(list, m * pow(10, k));
            int named = m == 1 ? k % stride == 0 : dense || (some && (m == 2 || m == 5));
            if (t && named) put_multiple(t, m, k, plain);
        }
}

static void symlog_ticks(tick_list *list, int most) {
    const plot_ruler *r = list->ruler;
    double largest = fmax(fabs(r->lo), fabs(r->hi));
    int first = (int)ceil(log10(r->linear) - 1e-9);
    int stride = decade_stride(forward(r, r->hi) - forward(r, r->lo), most),
        plain = largest < 1e5 && first > -4;
    plot_tick *zero = add(list, 0);
    if (zero) put_value(zero, 0, 1, 1);
    for (int k = first; k <= exponent_of(largest); k += stride < 10 ? 1 : stride / 10)
        for (int side = -1; side <= 1; side += 2) {
            plot_tick *t = add(list, side * pow(10, k));
            if (t && (k - first) % stride == 0) put_multiple(t, side, k, plain);
        }
}

int plot_ruler_ticks(const plot_ruler *r, int most, plot_tick ticks[PLOT_MOST_TICKS]) {
    tick_list list = {r, ticks, 0};
    if (r->scale == PLOT_LOG && r->hi > 3 * r->lo)
        log_ticks(&list, most);
    else if (r->scale == PLOT_SYMLOG && fmax(fabs(r->lo), fabs(r->hi)) > 2 * r->linear)
        symlog_ticks(&list, most);
    else
        linear_ticks(&list, most);
    return list.count;
}
