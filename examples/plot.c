/* plot.c - see plot.h: where the parts of a chart go, and the document around them.
 *
 * From the top: title, subtitle, legend, frame, numbers, label of the x axis.  The legend stands outside of
 * the frame, where it hides nothing.  Colours: Okabe and Ito, Color universal design, 2008, without their
 * yellow, which is hard to see on a light panel.
 */
#include "plot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot_draw.h"
#include "portable.h"

enum { WIDTH = 800, HEIGHT = 480, LEGEND_ROW = 20, SUBTITLE_ROW = 16 };

static const double EDGE = 16; /* between the panel's border and what is on it */

static double widest(const plot_tick *ticks, int count) {
    double width = 0;
    for (int i = 0; i < count; i++) width = fmax(width, ticks[i].width);
    return width;
}

/* ---- the words above the frame ---- */

/* Lines of at most that width, cut at blanks.  Returns y below the last. */
static double put_wrapped(FILE *out, const char *text, double width, double y) {
    while (*text) {
        size_t length = 0;
        for (size_t end = 1;; end++) {
            if (text[end] != ' ' && text[end] != '\0') continue;
            char line[512];
            snprintf(line, sizeof line, "%.*s", (int)end, text);
            if (length > 0 && plot_text_width(line) * PLOT_SMALL > width) break;
            length = end;
            if (text[end] == '\0') break;
        }
        fprintf(out, "<text x='%g' y='%g' fill='#555'>", EDGE, y);
        plot_put_text(out, text, length);
        fprintf(out, "</text>\n");
        y += SUBTITLE_ROW;
        text += length + (text[length] == ' ');
    }
    return y;
}

static double put_title(FILE *out, const plot *p, double y) {
    if (p->title && *p->title) {
        y += 18;
        fprintf(out, "<text x='%g' y='%g' font-size='16' font-weight='bold'>", EDGE, y);
        plot_put_text(out, p->title, strlen(p->title));
        fprintf(out, "</text>\n");
        y += 4;
    }
    if (p->subtitle && *p->subtitle) y = put_wrapped(out, p->subtitle, p->width - 2 * EDGE, y + 14) - 10;
    return y;
}

/* Returns y below the legend. */
static double put_legend(FILE *out, const plot *p, double y) {
    double x = EDGE;
    int any = 0;
    for (size_t i = 0; i < p->count; i++) {
        const char *name = p->series[i].name;
        if (!name || !*name) continue;
        double key = plot_key_width(&p->series[i]), width = key + 6 + plot_text_width(name) * PLOT_SMALL + 16;
        if (!any++ || x + width > p->width - EDGE + 16) {
            x = EDGE;
            y += LEGEND_ROW;
        }
        plot_put_key(out, &p->series[i], i, x, y - 4);
        fprintf(out, "<text x='%g' y='%g'>", x + key + 6, y);
        plot_put_text(out, name, strlen(name));
        fprintf(out, "</text>\n");
        x += width;
    }
    return y;
}

/* ---- axes ---- */

static double x_of(const plot_frame *f, double at) { return f->left + at * f->width; }
static double y_of(const plot_frame *f, double at) { return f->top + (1 - at) * f->height; }

/* Faint where there is no number. */
static const char *grid_colour(const plot_tick *t) { return t->text[0] ? "#d5d5d2" : "#ececea"; }

static void put_x_ticks(FILE *out, const plot_frame *f, const plot_tick *ticks, int count) {
    for (int i = 0; i < count; i++)
        fprintf(out, "<path d='M%.2f %.2fv%.2f' stroke='%s'/>\n", x_of(f, ticks[i].at), f->top, f->height,
                grid_colour(&ticks[i]));
    for (int i = 0; i < count; i++)
        if (ticks[i].text[0])
            fprintf(out, "<text x='%.2f' y='%.2f' text-anchor='middle'>%s</text>\n", x_of(f, ticks[i].at),
                    f->top + f->height + 17, ticks[i].text);
}

static void put_y_ticks(FILE *out, const plot_frame *f, const plot_tick *ticks, int count) {
    for (int i = 0; i < count; i++)
        fprintf(out, "<path d='M%.2f %.2fh%.2f' stroke='%s'/>\n", f->left, y_of(f, ticks[i].at), f->width,
                grid_colour(&ticks[i]));
    for (int i = 0; i < count; i++)
        if (ticks[i].text[0])
            fprintf(out, "<text x='%.2f' y='%.2f' text-anchor='end'>%s</text>\n", f->left - 6,
                    y_of(f, ticks[i].at) + 4, ticks[i].text);
}

static size_t name_count(const plot_axis *axis) {
    size_t count = 0;
    while (axis->names && axis->names[count]) count++;
    return count;
}

static double widest_name(const plot_axis *axis) {
    double width = 0;
    for (size_t i = 0; i < name_count(axis); i++)
        width = fmax(width, PLOT_SMALL * plot_text_width(axis->names[i]));
    return width;
}

/* Names that are wider than their places lean. */
static int names_lean(const plot *p, double width) {
    size_t count = name_count(&p->x);
    return count > 0 && widest_name(&p->x) > 0.95 * width / (double)count;
}

static void put_names(FILE *out, const plot *p, const plot_frame *f) {
    int lean = names_lean(p, f->width);
    for (size_t i = 0; i < name_count(&p->x); i++) {
        double at = plot_ruler_at(&f->x, (double)i);
        if (!(at >= 0 && at <= 1)) continue;
        double x = x_of(f, at), y = f->top + f->height + 17;
        if (lean)
            fprintf(out, "<text transform='translate(%.2f %.2f) rotate(-30)' text-anchor='end'>", x + 5,
                    y - 4);
        else
            fprintf(out, "<text x='%.2f' y='%.2f' text-anchor='middle'>", x, y);
        plot_put_text(out, p->x.names[i], strlen(p->x.names[i]));
        fprintf(out, "</text>\n");
    }
}

static void put_labels(FILE *out, const plot *p, const plot_frame *f) {
    if (p->x.label) {
        fprintf(out, "<text x='%.2f' y='%.2f' text-anchor='middle' font-size='13'>", f->left + f->width / 2,
                p->height - EDGE + 4);
        plot_put_text(out, p->x.label, strlen(p->x.label));
        fprintf(out, "</text>\n");
    }
    if (p->y.label) {
        fprintf(out,
                "<text transform='translate(%.2f %.2f) rotate(-90)' text-anchor='middle' font-size='13'>",
                EDGE + 8, f->top + f->height / 2);
        plot_put_text(out, p->y.label, strlen(p->y.label));
        fprintf(out, "</text>\n");
    }
}

/* ---- the chart ---- */

static int has_bars(const plot *p) {
    for (size_t i = 0; i < p->count; i++)
        if (p->series[i].mark == PLOT_BARS) return 1;
    return 0;
}

/* The values of all points that both axes can show: x, then y. */
static size_t gather(const plot *p, double **x, double **y) {
    size_t total = 0, count = 0;
    for (size_t i = 0; i < p->count; i++) total += p->series[i].count;
    *x = malloc((total + 1) * sizeof **x);
    *y = malloc((total + 1) * sizeof **y);
    if (!*x || !*y) return 0;
    for (size_t i = 0; i < p->count; i++)
        for (size_t k = 0; plot_has_values(p->series[i].mark) && k < p->series[i].count; k++) {
            double at = p->series[i].x[k], value = p->series[i].y[k];
            if (!plot_scale_shows(p->x.scale, at) || !plot_scale_shows(p->y.scale, value)) continue;
            (*x)[count] = at;
            (*y)[count++] = value;
        }
    return count;
}

static int make_rulers(const plot *p, plot_frame *f) {
    double *x, *y;
    size_t count = gather(p, &x, &y), names = name_count(&p->x);
    int done = x && y;
    if (done) {
        plot_axis places = p->x;
        if (places.lo >= places.hi && (names > 0 || has_bars(p))) {
            double first = 0, last = names > 0 ? (double)names - 1 : 0;
            for (size_t i = 0; names == 0 && i < count; i++) {
                first = i == 0 ? x[i] : fmin(first, x[i]);
                last = i == 0 ? x[i] : fmax(last, x[i]);
            }
            places.lo = first - 0.5;
            places.hi = last + 0.5;
        }
        f->x = plot_ruler_make(&places, x, count, 0);
        f->y = plot_ruler_make(&p->y, y, count, has_bars(p));
    }
    free(x);
    free(y);
    return done;
}

static int put_plot(FILE *out, const plot *p) {
    plot_frame f;
    plot_tick *ticks = malloc(2 * PLOT_MOST_TICKS * sizeof *ticks);
    if (!ticks || !make_rulers(p, &f)) {
        free(ticks);
        return 0;
    }
    plot_tick *y_ticks = ticks + PLOT_MOST_TICKS;
    f.top = put_legend(out, p, put_title(out, p, EDGE - 4)) + 16;
    double bottom = EDGE + 18 + (p->x.label ? 20 : 0);
    if (names_lean(p, p->width - 100)) bottom += 0.5 * widest_name(&p->x);
    f.height = fmax(40, p->height - f.top - bottom);
    int rows = plot_ruler_ticks(&f.y, (int)fmax(2, f.height / 32), y_ticks);
    f.left = EDGE + (p->y.label ? 20 : 0) + PLOT_SMALL * widest(y_ticks, rows) + 8;
    f.width = p->width - f.left - EDGE - 8;
    fprintf(out, "<rect x='%.2f' y='%.2f' width='%.2f' height='%.2f' fill='#fff'/>\n", f.left, f.top, f.width,
            f.height);
    put_y_ticks(out, &f, y_ticks, rows);
    if (p->x.names)
        put_names(out, p, &f);
    else
        put_x_ticks(out, &f, ticks, plot_ruler_ticks(&f.x, (int)fmax(2, f.width / 62), ticks));
    plot_put_series(out, p, &f);
    fprintf(out, "<rect x='%.2f' y='%.2f' width='%.2f' height='%.2f' fill='none' stroke='#666'/>\n", f.left,
            f.top, f.width, f.height);
    put_labels(out, p, &f);
    free(ticks);
    return 1;
}

/* ---- the document ---- */

static plot sized(const plot *p) {
    plot q = *p;
    if (q.width <= 0) q.width = WIDTH;
    if (q.height <= 0) q.height = HEIGHT;
    return q;
}

static int put_document(FILE *out, const plot *plots, size_t count) {
    int width = 0, height = 0, done = 1;
    for (size_t i = 0; i < count; i++) {
        plot p = sized(&plots[i]);
        if (p.width > width) width = p.width;
        height += p.height;
    }
    fprintf(out,
            "<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' viewBox='0 0 %d %d'\n"
            "font-family='Helvetica, Arial, \"Liberation Sans\", \"DejaVu Sans\", sans-serif' font-size='%d' "
            "fill='#222'>\n"
            "<rect x='0.5' y='0.5' width='%d' height='%d' rx='8' fill='#f8f8f6' stroke='#c8c8c4'/>\n",
            width, height, width, height, PLOT_SMALL, width - 1, height - 1);
    double y = 0;
    for (size_t i = 0; i < count && done; i++) {
        plot p = sized(&plots[i]);
        fprintf(out, "<g transform='translate(0 %g)'>\n", y);
        done = put_plot(out, &p);
        fprintf(out, "</g>\n");
        y += p.height;
    }
    fprintf(out, "</svg>\n");
    return done;
}

int plot_put_column(const plot *plots, size_t count, FILE *out) {
    return put_document(out, plots, count) ? 0 : -1;
}

/* Removes what was begun, but no device that somebody named as the file. */
static void give_up(const char *file) {
    if (portable_kind_of(file) == PORTABLE_FILE) (void)remove(file);
}

int plot_write_column(const plot *plots, size_t count, const char *file) {
    FILE *out = fopen(file, "wb");
    if (!out) return -1;
    int done = put_document(out, plots, count) && !ferror(out);
    if (fclose(out) == 0 && done) return 0;
    give_up(file);
    return -1;
}

int plot_write(const plot *p, const char *file) { return plot_write_column(p, 1, file); }
