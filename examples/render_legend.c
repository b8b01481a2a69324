/* render_legend.c - see render_legend.h.
 *
 * The colours of costs are viridis (van der Walt and Smith, 2015): brighter is more, to every eye, and no
 * red, which is left to what is uncertain.
 */
#include "render_legend.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const legend_colour legend_no_chord = {{224, 224, 224}}, legend_uncertain = {{230, 0, 60}};

static const uint8_t viridis[10][3] = {{68, 1, 84},    {72, 40, 120},  {62, 74, 137},  {49, 104, 142},
                                       {38, 130, 142}, {31, 158, 137}, {53, 183, 121}, {109, 205, 89},
                                       {180, 222, 44}, {253, 231, 37}};

legend_colour legend_cost(double cost, int top) {
    legend_colour colour;
    double place = 9 * (top > 1 ? log(fmax(cost, 1)) / log(top) : 0);
    int i = place < 8 ? (int)place : 8;
    for (int k = 0; k < 3; k++)
        colour.rgb[k] = (uint8_t)lround(viridis[i][k] + (place - i) * (viridis[i + 1][k] - viridis[i][k]));
    return colour;
}

/* ---- letters ---- */

enum { GLYPH_WIDTH = 5, GLYPH_HEIGHT = 7, SCALE = 2, ADVANCE = (GLYPH_WIDTH + 1) * SCALE };

/* What the legend needs, 5 x 7 points: a row each, its leftmost point in bit 4. */
typedef struct glyph {
    char letter;
    uint8_t rows[GLYPH_HEIGHT];
} glyph;

static const glyph font[] = {{'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
                             {'2', {14, 17, 1, 2, 4, 8, 31}},     {'3', {31, 2, 4, 2, 1, 17, 14}},
                             {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
                             {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
                             {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
                             {'+', {0, 4, 4, 31, 4, 4, 0}},       {'a', {0, 0, 14, 1, 15, 17, 15}},
                             {'c', {0, 0, 14, 16, 16, 17, 14}},   {'d', {1, 1, 13, 19, 17, 17, 15}},
                             {'e', {0, 0, 14, 17, 31, 16, 14}},   {'h', {16, 16, 22, 25, 17, 17, 17}},
                             {'i', {4, 0, 12, 4, 4, 4, 14}},      {'l', {12, 4, 4, 4, 4, 4, 14}},
                             {'n', {0, 0, 22, 25, 17, 17, 17}},   {'o', {0, 0, 14, 17, 17, 17, 14}},
                             {'r', {0, 0, 22, 25, 16, 16, 16}},   {'s', {0, 0, 14, 16, 14, 1, 30}},
                             {'t', {8, 8, 28, 8, 8, 9, 6}},       {'u', {0, 0, 17, 17, 17, 19, 13}},
                             {'v', {0, 0, 17, 17, 17, 10, 4}},    {'y', {0, 0, 17, 17, 15, 1, 14}},
                             {':', {0, 4, 0, 0, 0, 4, 0}}};

/* ---- drawing ---- */

typedef struct canvas {
    uint8_t *pixels;
    int width;
} canvas;

static const legend_colour ink = {{34, 34, 34}};

static void fill(const canvas *c, int x, int y, int width, int height, legend_colour colour) {
    for (int j = y; j < y + height; j++)
        for (int i = x; i < x + width; i++)
            memcpy(c->pixels + 3 * ((size_t)j * (size_t)c->width + (size_t)i), colour.rgb, 3);
}

static void write_text(const canvas *c, int x, int y, const char *text) {
    for (; *text; text++, x += ADVANCE)
        for (size_t g = 0; g < sizeof font / sizeof *font; g++)
            for (int i = 0; font[g].letter == *text && i < GLYPH_WIDTH * GLYPH_HEIGHT; i++)
                if (font[g].rows[i / GLYPH_WIDTH] >> (GLYPH_WIDTH - 1 - i % GLYPH_WIDTH) & 1)
                    fill(c, x + i % GLYPH_WIDTH * SCALE, y + i / GLYPH_WIDTH * SCALE, SCALE, SCALE, ink);
}

static int text_width(const char *text) { return (int)strlen(text) * ADVANCE - SCALE; }

/* ---- the strip ---- */

enum { EDGE = 10, LINE = 24, BAR = 14, TICK = 4 };

/* The bar with numbers 1, 2, 5, 10, ... where they do not touch, and the highest cost at its end. */
static void draw_bar(const canvas *c, int y, int top) {
    int width = c->width - 2 * EDGE, free_from = 0;
    char last[16], text[16];
    for (int i = 0; i < width; i++)
        fill(c, EDGE + i, y, 1, BAR, legend_cost(pow(top, i / (width - 1.0)), top));
    snprintf(last, sizeof last, "%d", top);
    int last_at = EDGE + width - text_width(last);
    write_text(c, last_at, y + BAR + TICK + 2, last);
    fill(c, EDGE + width - SCALE, y + BAR, SCALE, TICK, ink);
    for (int unit = 1; unit <= top / 10 * 10 || unit == 1; unit *= 10) {
        static const int steps[] = {1, 2, 5};
        for (int k = 0; k < 3; k++) {
            double value = (double)steps[k] * unit;
            if (value >= top) return;
            int at = EDGE + (int)((width - 1) * log(value) / log(top));
            snprintf(text, sizeof text, "%.0f", value);
            int from = at - text_width(text) / 2 > EDGE ? at - text_width(text) / 2 : EDGE;
            if (from < free_from || from + text_width(text) + ADVANCE > last_at) continue;
            write_text(c, from, y + BAR + TICK + 2, text);
            fill(c, at, y + BAR, SCALE, TICK, ink);
            free_from = from + text_width(text) + ADVANCE;
        }
    }
}

static int draw_swatch(const canvas *c, int x, int y, legend_colour colour, const char *text) {
    fill(c, x, y, BAR, BAR, colour);
    write_text(c, x + BAR + 6, y, text);
    return x + BAR + 6 + text_width(text) + 2 * ADVANCE;
}

void render_draw_legend(const render_legend *legend, uint8_t *pixels, int width, int y) {
    canvas c = {pixels, width};
    char text[32];
    snprintf(text, sizeof text, "uncertain: %zu", legend->uncertain);
    y += EDGE;
    write_text(&c, EDGE, y, "intervals + evaluations a ray");
    draw_bar(&c, y + LINE, legend->top);
    int x = draw_swatch(&c, EDGE, y + 3 * LINE - 2, legend_no_chord, "no chord");
    draw_swatch(&c, x, y + 3 * LINE - 2, legend_uncertain, text);
}
