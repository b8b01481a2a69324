/* plot_draw.c - see plot_draw.h. */
#include "plot_draw.h"

#include <math.h>

#include "plot_label.h"

static const char *const colours[] = {"#0072b2", "#d55e00", "#009e73", "#b0508c",
                                      "#222222", "#e69f00", "#56b4e9", "#8a6d3b"};
static const char *const dashes[] = {"none", "8 4", "2 3", "10 3 2 3", "5 2", "1 2", "12 4 2 4 2 4", "16 4"};
/* In units of the mark's size. */
static const char *const marks[] = {
    "M-1 0a1 1 0 1 0 2 0a1 1 0 1 0 -2 0z",                                     /* disc */
    "M-.88 -.88h1.76v1.76h-1.76z",                                             /* square */
    "M0 -1.2L1.08 .75H-1.08z",                                                 /* triangle */
    "M0 -1.3L1.1 0L0 1.3L-1.1 0z",                                             /* diamond */
    "M0 1.2L1.08 -.75H-1.08z",                                                 /* triangle upside down */
    "M-.4 -1.1h.8v.7h.7v.8h-.7v.7h-.8v-.7h-.7v-.8h.7z",                        /* plus */
    "M-1 -.5L-.5 -1L0 -.5L.5 -1L1 -.5L.5 0L1 .5L.5 1L0 .5L-.5 1L-1 .5L-.5 0z", /* cross */
    "M-1.2 -.5h2.4v1h-2.4z"                                                    /* bar */
};

#define SHADE "0.28"           /* opacity of bands */
enum { KINDS = 8, FEW = 150 }; /* more points than that are drawn small and see-through */

void plot_put_text(FILE *out, const char *text, size_t length) {
    for (const char *at = text; at < text + length; at++) switch (*at) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        default:
            fputc((unsigned char)*at < ' ' ? ' ' : *at, out);
        }
}

int plot_is_line(plot_mark mark) { return mark == PLOT_LINE || mark == PLOT_BOTH || mark == PLOT_STEPS; }

int plot_has_points(plot_mark mark) {
    return mark == PLOT_POINTS || mark == PLOT_BOTH || mark == PLOT_NUMBERED;
}

int plot_has_values(plot_mark mark) { return mark != PLOT_BANDS && mark != PLOT_RULES; }

/* A line without marks has dashes to be told by; one without a name is a guide. */
static void begin_line(FILE *out, const plot_series *s, size_t index) {
    int guide = !s->name && s->mark == PLOT_LINE;
    fprintf(
        out,
        "<path fill='none' stroke='%s' stroke-width='%s' stroke-linejoin='round' stroke-dasharray='%s' d='",
        guide ? "#888" : colours[index % KINDS], guide ? "1" : "1.8",
        guide || plot_has_points(s->mark) ? "none" : dashes[index % KINDS]);
}

static void put_mark(FILE *out, size_t index, double x, double y, double size) {
    fprintf(out, "<path transform='translate(%.2f %.2f) scale(%g)' d='%s'/>\n", x, y, size,
            marks[index % KINDS]);
}

double plot_key_width(const plot_series *s) { return plot_is_line(s->mark) ? 30 : 14; }

static void put_rule(FILE *out, size_t index, double x, double y, double height) {
    fprintf(out, "<path fill='none' stroke='%s' stroke-width='1.8' d='M%.2f %.2fv%.2f'/>\n",
            colours[index % KINDS], x, y, height);
}

void plot_put_key(FILE *out, const plot_series *s, size_t index, double x, double y) {
    double length = plot_key_width(s);
    if (plot_is_line(s->mark)) {
        begin_line(out, s, index);
        fprintf(out, "M%.2f %.2fh%.2f'/>\n", x, y, length);
    }
    fprintf(out, "<g fill='%s'>\n", colours[index % KINDS]);
    if (plot_has_points(s->mark)) put_mark(out, index, x + length / 2, y, 4.5);
    if (s->mark == PLOT_BARS) fprintf(out, "<rect x='%.2f' y='%.2f' width='14' height='11'/>\n", x, y - 6);
    if (s->mark == PLOT_BANDS)
        fprintf(out, "<rect x='%.2f' y='%.2f' width='%.2f' height='14' fill-opacity='" SHADE "'/>\n", x,
                y - 7, length);
    fprintf(out, "</g>\n");
    if (s->mark == PLOT_RULES) put_rule(out, index, x + length / 2, y - 7, 14);
}

/* ---- inside the frame, whose upper left corner is 0,0 ---- */

double plot_x_of(const plot_frame *f, double value) { return f->width * plot_ruler_at(&f->x, value); }
double plot_y_of(const plot_frame *f, double value) { return f->height * (1 - plot_ruler_at(&f->y, value)); }

static void put_line(FILE *out, const plot_series *s, size_t index, const plot_frame *f) {
    int down = 0; /* the pen */
    double before = 0;
    begin_line(out, s, index);
    for (size_t i = 0; i < s->count; i++) {
        double x = plot_x_of(f, s->x[i]), y = plot_y_of(f, s->y[i]);
        if (isnan(x) || isnan(y)) {
            down = 0;
            continue;
        }
        if (down && s->mark == PLOT_STEPS) fprintf(out, "L%.2f %.2f", x, before);
        fprintf(out, "%c%.2f %.2f%s", down ? 'L' : 'M', x, y, i % 8 == 7 ? "\n" : "");
        down = 1;
        before = y;
    }
    fprintf(out, "'/>\n");
}

/* However narrow, a band can be seen. */
static void put_bands(FILE *out, const plot_series *s, size_t index, const plot_frame *f) {
    const double least = 2;
    fprintf(out, "<g fill='%s' fill-opacity='" SHADE "'>\n", colours[index % KINDS]);
    for (size_t i = 0; i + 1 < s->count; i += 2) {
        double from = plot_x_of(f, s->x[i]), width = plot_x_of(f, s->x[i + 1]) - from;
        if (isnan(from) || isnan(width)) continue;
        if (width < least) from -= (least - width) / 2, width = least;
        fprintf(out, "<rect x='%.2f' width='%.2f' height='%.2f'/>\n", from, width, f->height);
    }
    fprintf(out, "</g>\n");
}

static void put_rules(FILE *out, const plot_series *s, size_t index, const plot_frame *f) {
    for (size_t i = 0; i < s->count; i++) {
        double x = plot_x_of(f, s->x[i]);
        if (!isnan(x)) put_rule(out, index, x, 0, f->height);
    }
}

static void put_points(FILE *out, const plot_series *s, size_t index, const plot_frame *f) {
    int few = s->count <= FEW;
    fprintf(out, "<g fill='%s' fill-opacity='%s'>\n", colours[index % KINDS], few ? "1" : "0.6");
    for (size_t i = 0; i < s->count; i++) {
        double x = plot_ruler_at(&f->x, s->x[i]), y = plot_ruler_at(&f->y, s->y[i]);
        if (x >= -1e-9 && x <= 1 + 1e-9 && y >= -1e-9 && y <= 1 + 1e-9)
            put_mark(out, index, x * f->width, (1 - y) * f->height, few ? 4 : 2);
    }
    fprintf(out, "</g>\n");
}

/* Four fifths of the smallest distance between two places, in pixels. */
static double group_width(const plot *p, const plot_frame *f) {
    double least = 1;
    for (size_t i = 0; i < p->count; i++)
        for (size_t k = 1; p->series[i].mark == PLOT_BARS && k < p->series[i].count; k++) {
            double gap = fabs(p->series[i].x[k] - p->series[i].x[k - 1]);
            if (gap > 0 && gap < least) least = gap;
        }
    return 0.8 * least / (f->x.hi - f->x.lo) * f->width;
}

/* Series number `index` is number `place` of `of` that have bars. */
static void put_bars(FILE *out, const plot *p, size_t index, const plot_frame *f, size_t place, size_t of) {
    const plot_series *s = &p->series[index];
    double group = group_width(p, f), width = group / (double)of;
    double base = f->height * (f->y.scale == PLOT_LOG ? 1 : 1 - plot_ruler_at(&f->y, 0));
    fprintf(out, "<g fill='%s' stroke='#fff' stroke-width='%g'>\n", colours[index % KINDS],
            width > 6 ? 1 : 0.2);
    for (size_t i = 0; i < s->count; i++) {
        double x = plot_x_of(f, s->x[i]) - group / 2 + width * (double)place, y = plot_y_of(f, s->y[i]);
        if (isnan(x) || isnan(y)) continue;
        fprintf(out, "<rect x='%.2f' y='%.2f' width='%.2f' height='%.2f'/>\n", x, fmin(y, base), width,
                fabs(y - base));
    }
    fprintf(out, "</g>\n");
}

/* A nested svg element clips what leaves the frame; marks at its edge may stick out. */
void plot_put_series(FILE *out, const plot *p, const plot_frame *f) {
    size_t bars = 0, place = 0;
    for (size_t i = 0; i < p->count; i++) bars += p->series[i].mark == PLOT_BARS;
    fprintf(out, "<svg x='%.2f' y='%.2f' width='%.2f' height='%.2f'>\n", f->left, f->top, f->width,
            f->height);
    for (size_t i = 0; i < p->count; i++) {
        if (p->series[i].mark == PLOT_BANDS) put_bands(out, &p->series[i], i, f);
        if (p->series[i].mark == PLOT_RULES) put_rules(out, &p->series[i], i, f);
    }
    for (size_t i = 0; i < p->count; i++) {
        if (p->series[i].mark == PLOT_BARS) put_bars(out, p, i, f, place++, bars);
        if (plot_is_line(p->series[i].mark)) put_line(out, &p->series[i], i, f);
    }
    fprintf(out, "</svg>\n<g transform='translate(%.2f %.2f)'>\n", f->left, f->top);
    for (size_t i = 0; i < p->count; i++)
        if (plot_has_points(p->series[i].mark)) put_points(out, &p->series[i], i, f);
    for (size_t i = 0; i < p->count; i++)
        if (p->series[i].mark == PLOT_NUMBERED) {
            fprintf(out, "<g fill='%s' text-anchor='middle'>\n", colours[i % KINDS]);
            plot_put_numbers(out, p, i, f);
            fprintf(out, "</g>\n");
        }
    fprintf(out, "</g>\n");
}
