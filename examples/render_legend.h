/* render_legend.h - the colours of a heat map, and the strip below it that explains them. */
#ifndef RENDER_LEGEND_H
#define RENDER_LEGEND_H
#include <stddef.h>
#include <stdint.h>

enum { LEGEND_WIDTH = 400, LEGEND_HEIGHT = 128 }; /* pixels; the strip may be wider */

typedef struct legend_colour {
    uint8_t rgb[3];
} legend_colour;

typedef struct render_legend {
    int top;          /* the highest cost */
    size_t left_open; /* pixels */
} render_legend;

extern const legend_colour legend_empty, legend_sheet, legend_no_chord, legend_left_open;

/* On a logarithmic scale from 1 to top. */
legend_colour legend_cost(double cost, int top);

/* Draws the strip over LEGEND_HEIGHT white rows of a picture `width` wide, from row y on. */
void render_draw_legend(const render_legend *legend, uint8_t *pixels, int width, int y);

#endif
