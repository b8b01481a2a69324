/* plot_label.c - see plot_label.h.
 *
 * A number stands above its point, or below, beside one of the mark's corners, to the right or to the left:
 * at the first of these places that is inside the frame and touches no number that stands already, no mark,
 * no line and no rule.  Where there is no such place the number is left out.  The first points choose first.
 */
#include "plot_label.h"

#include <math.h>

enum { MOST_LABELS = 100, DIGIT_HEIGHT = 9, MARK = 8, AWAY = 12 /* of numbers above and below */ };

/* The rectangle of a number: its middle, and half its sides. */
typedef struct label {
    double x, y, across, down;
} label;

static int is_inside(const label *l, const plot_frame *f) {
    return l->x - l->across > 0 && l->x + l->across < f->width && l->y - l->down > 0 &&
           l->y + l->down < f->height;
}

static int overlap(const label *a, const label *b) {
    return fabs(a->x - b->x) < a->across + b->across && fabs(a->y - b->y) < a->down + b->down;
}

/* Keeps the part of [*from,*to] where |at + t step| < half. */
static void cut(double at, double step, double half, double *from, double *to) {
    if (step == 0) {
        if (!(fabs(at) < half)) *to = *from - 1;
        return;
    }
    double a = (-half - at) / step, b = (half - at) / step;
    *from = fmax(*from, fmin(a, b));
    *to = fmin(*to, fmax(a, b));
}

/* By a line between two points; not, where one of them cannot be shown. */
static int is_crossed(const label *l, double x0, double y0, double x1, double y1) {
    double from = 0, to = 1;
    if (isnan(x0 + y0 + x1 + y1)) return 0;
    cut(x0 - l->x, x1 - x0, l->across, &from, &to);
    cut(y0 - l->y, y1 - y0, l->down, &from, &to);
    return from < to;
}

static int touches_line(const label *l, const plot_series *s, const plot_frame *f) {
    double x0 = NAN, y0 = NAN;
    for (size_t i = 0; i < s->count; i++) {
        double x = plot_x_of(f, s->x[i]), y = s->mark == PLOT_RULES ? 0 : plot_y_of(f, s->y[i]);
        if (s->mark == PLOT_RULES ? is_crossed(l, x, 0, x, f->height) : is_crossed(l, x0, y0, x, y)) return 1;
        x0 = x, y0 = y;
    }
    return 0;
}

/* own: the number's own point, if it is of this series. */
static int touches_mark(const label *l, const plot_series *s, const plot_frame *f, const double *own) {
    for (size_t i = 0; i < s->count; i++) {
        const label mark = {plot_x_of(f, s->x[i]), plot_y_of(f, s->y[i]), MARK / 2.0, MARK / 2.0};
        if (s->x + i != own && overlap(l, &mark)) return 1;
    }
    return 0;
}

static int is_free(const label *l, const plot *p, const plot_frame *f, const double *own) {
    if (!is_inside(l, f)) return 0;
    for (size_t i = 0; i < p->count; i++) {
        const plot_series *s = &p->series[i];
        if (plot_has_points(s->mark) && touches_mark(l, s, f, own)) return 0;
        if ((plot_is_line(s->mark) || s->mark == PLOT_RULES) && touches_line(l, s, f)) return 0;
    }
    return 1;
}

/* A free place for the number of a point; returns 0 if there is none. */
static int place(label *l, const label *taken, int count, const plot *p, const plot_frame *f,
                 const double *own) {
    static const int sides[][2] = {{0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}};
    const double x = l->x, y = l->y;
    for (size_t side = 0; side < sizeof sides / sizeof *sides; side++) {
        int beside = sides[side][0], above = sides[side][1], others = 0;
        l->x = x + beside * (l->across + MARK / 2.0 + 1);
        l->y = y + above * (beside ? 0.6 : 1) * AWAY;
        for (int i = 0; i < count; i++) others |= overlap(l, taken + i);
        if (!others && is_free(l, p, f, own)) return 1;
    }
    return 0;
}

void plot_put_numbers(FILE *out, const plot *p, size_t index, const plot_frame *f) {
    const plot_series *s = &p->series[index];
    label taken[MOST_LABELS];
    int count = 0;
    for (size_t i = 0; i < s->count && count < MOST_LABELS; i++) {
        char text[24];
        snprintf(text, sizeof text, "%zu", i);
        double across = PLOT_SMALL * plot_text_width(text) / 2 + 1;
        label l = {plot_x_of(f, s->x[i]), plot_y_of(f, s->y[i]), across, DIGIT_HEIGHT / 2.0};
        if (!place(&l, taken, count, p, f, s->x + i)) continue;
        taken[count++] = l;
        fprintf(out, "<text x='%.2f' y='%.2f'>%s</text>\n", l.x, l.y + l.down, text);
    }
}
