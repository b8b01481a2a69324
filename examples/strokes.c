/* strokes.c - see strokes.h.
 *
 * A pixel whose centre is at distance d from a line of width w is covered to max(0, min(1, (w + 1) / 2 - d)):
 * the share of a pixel's square under a straight edge, for edges along rows and columns.  Along a line in a
 * pinhole's picture 1 / depth is linear, in a parallel projection depth is.
 */
#include "strokes.h"

#include <math.h>
#include <stddef.h>

static double least(double a, double b) { return a < b ? a : b; }
static double most(double a, double b) { return a > b ? a : b; }
static double within(double x, double lo, double hi) { return most(lo, least(x, hi)); }

/* ---- lines ---- */

static int is_hidden(const strokes *s, size_t index, double x, double y, double depth) {
    if (!s->t) return 0;
    double a = s->pixel * (x - 0.5 * s->width), b = s->pixel * (y - 0.5 * s->height);
    return depth * sqrt(1 + a * a + b * b) > s->t[index] + s->nearer;
}

/* Of the pixel in that column and row. */
static void cover(const strokes *s, const stroke_point *a, const stroke_point *b, double width, int column,
                  int row) {
    double x = column + 0.5, y = row + 0.5, dx = b->x - a->x, dy = b->y - a->y, square = dx * dx + dy * dy;
    double along = square > 0 ? within(((x - a->x) * dx + (y - a->y) * dy) / square, 0, 1) : 0;
    double ex = x - (a->x + along * dx), ey = y - (a->y + along * dy);
    double share = (width + 1) / 2 - sqrt(ex * ex + ey * ey);
    size_t index = (size_t)(row - s->row_begin) * (size_t)s->width + (size_t)column;
    uint8_t covered = (uint8_t)(255 * within(share, 0, 1) + 0.5);
    if (covered <= s->cover[index]) return;
    double depth = s->pixel > 0 ? 1 / ((1 - along) / a->depth + along / b->depth)
                                : (1 - along) * a->depth + along * b->depth;
    if (!is_hidden(s, index, x, y, depth)) s->cover[index] = covered;
}

/* First and last column that a line may cover in a row; none: the last is before the first. */
static void columns_of(const strokes *s, const stroke_point *a, const stroke_point *b, double reach, int row,
                       int *first, int *last) {
    double dx = b->x - a->x, dy = b->y - a->y, y = row + 0.5 - a->y;
    double lo = least(a->x, b->x) - reach, hi = most(a->x, b->x) + reach;
    if (fabs(dy) > 1e-9 * fabs(dx)) { /* within reach of the endless line */
        double x = a->x + y * dx / dy, aside = reach * sqrt(dx * dx + dy * dy) / fabs(dy);
        lo = most(lo, x - aside);
        hi = least(hi, x + aside);
    }
    *first = (int)within(floor(lo), 0, s->width);
    *last = (int)within(ceil(hi), -1, s->width - 1);
}

void strokes_line(const strokes *s, stroke_point a, stroke_point b, double width) {
    double reach = (width + 1) / 2;
    int begin = (int)within(floor(least(a.y, b.y) - reach), s->row_begin, s->row_end);
    int end = (int)within(ceil(most(a.y, b.y) + reach), s->row_begin, s->row_end);
    for (int row = begin; row < end; row++) {
        int first, last;
        columns_of(s, &a, &b, reach, row, &first, &last);
        for (int column = first; column <= last; column++) cover(s, &a, &b, width, column, row);
    }
}

/* ---- letters ---- */

enum { CAPITAL = 6, BASE = 2, GAP = 2 }; /* heights and a gap in units of the glyphs */

/* Broken lines of points "xy", with a blank between two of them; y upwards, the base line at 2. */
typedef struct glyph {
    char letter;
    int width;
    const char *lines;
} glyph;

static const glyph font[] = {{'0', 4, "123243473818070312"},
                             {'1', 2, "062822"},
                             {'2', 4, "0718384746450242"},
                             {'3', 4, "07183847463515 354443321203"},
                             {'4', 4, "32380444"},
                             {'5', 4, "480805354443321203"},
                             {'6', 4, "473818070312324344351504"},
                             {'7', 4, "084812"},
                             {'8', 4, "15354647381807061504031232434435"},
                             {'9', 4, "031232434738180706153546"},
                             {'-', 4, "0545"},
                             {'.', 1, "0212130302"},
                             {'e', 4, "04444536160503123243"},
                             {'x', 4, "0246 0642"},
                             {'y', 4, "0622 4610"},
                             {'z', 4, "06460242"}};

static const glyph *glyph_of(char letter) {
    static const glyph gap = {' ', 2, ""};
    for (size_t i = 0; i < sizeof font / sizeof *font; i++)
        if (font[i].letter == letter) return &font[i];
    return &gap;
}

double strokes_text_width(double height, const char *text) {
    double width = 0;
    for (const char *c = text; *c; c++) width += glyph_of(*c)->width + (c > text ? GAP : 0);
    return width * height / CAPITAL;
}

/* left: the glyph's left end on the base line. */
static void draw_glyph(const strokes *s, const glyph *g, stroke_point left, double unit) {
    stroke_point before = left;
    int is_line = 0;
    for (const char *at = g->lines; *at; at++) {
        if (*at == ' ') {
            is_line = 0;
            continue;
        }
        stroke_point point = {left.x + (*at - '0') * unit, left.y - (at[1] - '0' - BASE) * unit, left.depth};
        if (is_line) strokes_line(s, before, point, most(1.1, 0.8 * unit));
        is_line = 1;
        before = point;
        at++;
    }
}

void strokes_text(const strokes *s, stroke_point middle, double height, const char *text) {
    double unit = height / CAPITAL;
    stroke_point left = {middle.x - strokes_text_width(height, text) / 2, middle.y + height / 2,
                         middle.depth};
    for (; *text; text++) {
        const glyph *g = glyph_of(*text);
        draw_glyph(s, g, left, unit);
        left.x += (g->width + GAP) * unit;
    }
}

/* ---- colour ---- */

void strokes_paint(const strokes *s, const uint8_t bare[3], const uint8_t over[3], uint8_t *pixels,
                   int bytes) {
    size_t count = (size_t)s->width * (size_t)(s->row_end - s->row_begin);
    for (size_t i = 0; i < count; i++, pixels += bytes) {
        if (s->cover[i] == 0) continue;
        double share = s->cover[i] / 255.0, opaque = bytes == 4 ? pixels[3] / 255.0 : 1;
        double below = (1 - share) * opaque, alpha = share + below;
        for (int k = 0; k < 3; k++) {
            double ink = (1 - opaque) * bare[k] + opaque * over[k];
            pixels[k] = (uint8_t)((share * ink + below * pixels[k]) / alpha + 0.5);
        }
        if (bytes == 4) pixels[3] = (uint8_t)(255 * alpha + 0.5);
    }
}
