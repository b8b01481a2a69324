/* render_legend.c - see render_legend.h.
 *
 * The colours of costs are viridis (van der Walt and Smith, 2015): brighter is more, to every eye, and no
 * red, which is left to what doubles leave open, nor brown, which is left to sheets.
 */
#include "render_legend.h"

#include <math.h>
#include <stdio.h>

#include "canvas.h"

const legend_colour legend_empty = {{222, 234, 244}}, legend_sheet = {{238, 190, 140}},
                    legend_no_chord = {{224, 224, 224}}, legend_left_open = {{230, 0, 60}};

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

/* ---- the strip ---- */

enum { EDGE = 10, LINE = 24, BAR = 14, TICK = 4 };

/* The bar with numbers 1, 2, 5, 10, ... where they do not touch, and the highest cost at its end. */
static void draw_bar(const canvas *c, int y, int top) {
    int width = c->width - 2 * EDGE, free_from = 0;
    char last[16], text[16];
    for (int i = 0; i < width; i++)
        canvas_fill(c, EDGE + i, y, 1, BAR, legend_cost(pow(top, i / (width - 1.0)), top).rgb);
    snprintf(last, sizeof last, "%d", top);
    int last_at = EDGE + width - canvas_text_width(last);
    canvas_write(c, last_at, y + BAR + TICK + 2, last);
    canvas_fill(c, EDGE + width - CANVAS_SCALE, y + BAR, CANVAS_SCALE, TICK, canvas_ink);
    for (int unit = 1; unit <= top / 10 * 10 || unit == 1; unit *= 10) {
        static const int steps[] = {1, 2, 5};
        for (int k = 0; k < 3; k++) {
            double value = (double)steps[k] * unit;
            if (value >= top) return;
            int at = EDGE + (int)((width - 1) * log(value) / log(top));
            snprintf(text, sizeof text, "%.0f", value);
            int from = at - canvas_text_width(text) / 2 > EDGE ? at - canvas_text_width(text) / 2 : EDGE;
            if (from < free_from || from + canvas_text_width(text) + CANVAS_LETTER_ADVANCE > last_at)
                continue;
            canvas_write(c, from, y + BAR + TICK + 2, text);
            canvas_fill(c, at, y + BAR, CANVAS_SCALE, TICK, canvas_ink);
            free_from = from + canvas_text_width(text) + CANVAS_LETTER_ADVANCE;
        }
    }
}

static int draw_swatch(const canvas *c, int x, int y, legend_colour colour, const char *text) {
    canvas_fill(c, x, y, BAR, BAR, colour.rgb);
    canvas_write(c, x + BAR + 6, y, text);
    return x + BAR + 6 + canvas_text_width(text) + 2 * CANVAS_LETTER_ADVANCE;
}

void render_draw_legend(const render_legend *legend, uint8_t *pixels, int width, int y) {
    canvas c = {pixels, width};
    char text[64];
    snprintf(text, sizeof text, "left open by doubles: %zu", legend->left_open);
    y += EDGE;
    canvas_write(&c, EDGE, y, "intervals + evaluations a ray");
    draw_bar(&c, y + LINE, legend->top);
    y += 3 * LINE - 2;
    int x = draw_swatch(&c, EDGE, y, legend_no_chord, "no chord");
    x = draw_swatch(&c, x, y, legend_empty, "empty tile");
    draw_swatch(&c, x, y, legend_sheet, "sheet");
    draw_swatch(&c, EDGE, y + LINE, legend_left_open, text);
}
