/* canvas.c - see canvas.h. */
#include "canvas.h"

#include <stddef.h>
#include <string.h>

enum { GLYPH_WIDTH = 5, GLYPH_HEIGHT = 9 };

const uint8_t canvas_ink[3] = {34, 34, 34};

/* 5 x 9 points: a row each, its leftmost point in bit 4; the last two rows are below the line. */
typedef struct glyph {
    char letter;
    uint8_t rows[GLYPH_HEIGHT];
} glyph;

static const glyph font[] = {{'0', {14, 17, 19, 21, 25, 17, 14}},
                             {'1', {4, 12, 4, 4, 4, 4, 14}},
                             {'2', {14, 17, 1, 2, 4, 8, 31}},
                             {'3', {31, 2, 4, 2, 1, 17, 14}},
                             {'4', {2, 6, 10, 18, 31, 2, 2}},
                             {'5', {31, 16, 30, 1, 1, 17, 14}},
                             {'6', {6, 8, 16, 30, 17, 17, 14}},
                             {'7', {31, 1, 2, 4, 8, 8, 8}},
                             {'8', {14, 17, 17, 14, 17, 17, 14}},
                             {'9', {14, 17, 17, 15, 1, 2, 12}},
                             {'+', {0, 4, 4, 31, 4, 4, 0}},
                             {'-', {0, 0, 0, 31, 0, 0, 0}},
                             {':', {0, 4, 0, 0, 0, 4, 0}},
                             {'a', {0, 0, 14, 1, 15, 17, 15}},
                             {'b', {16, 16, 22, 25, 17, 17, 30}},
                             {'c', {0, 0, 14, 16, 16, 17, 14}},
                             {'d', {1, 1, 13, 19, 17, 17, 15}},
                             {'e', {0, 0, 14, 17, 31, 16, 14}},
                             {'f', {6, 9, 8, 28, 8, 8, 8}},
                             {'g', {0, 0, 15, 17, 17, 17, 15, 1, 14}},
                             {'h', {16, 16, 22, 25, 17, 17, 17}},
                             {'i', {4, 0, 12, 4, 4, 4, 14}},
                             {'j', {2, 0, 6, 2, 2, 2, 2, 18, 12}},
                             {'k', {16, 16, 18, 20, 24, 20, 18}},
                             {'l', {12, 4, 4, 4, 4, 4, 14}},
                             {'m', {0, 0, 26, 21, 21, 17, 17}},
                             {'n', {0, 0, 22, 25, 17, 17, 17}},
                             {'o', {0, 0, 14, 17, 17, 17, 14}},
                             {'p', {0, 0, 30, 17, 17, 17, 30, 16, 16}},
                             {'q', {0, 0, 15, 17, 17, 17, 15, 1, 1}},
                             {'r', {0, 0, 22, 25, 16, 16, 16}},
                             {'s', {0, 0, 14, 16, 14, 1, 30}},
                             {'t', {8, 8, 28, 8, 8, 9, 6}},
                             {'u', {0, 0, 17, 17, 17, 19, 13}},
                             {'v', {0, 0, 17, 17, 17, 10, 4}},
                             {'w', {0, 0, 17, 17, 21, 21, 10}},
                             {'x', {0, 0, 17, 10, 4, 10, 17}},
                             {'y', {0, 0, 17, 17, 17, 17, 15, 1, 14}},
                             {'z', {0, 0, 31, 2, 4, 8, 31}}};

void canvas_fill(const canvas *c, int x, int y, int width, int height, const uint8_t rgb[3]) {
    for (int j = y; j < y + height; j++)
        for (int i = x; i < x + width; i++)
            memcpy(c->pixels + 3 * ((size_t)j * (size_t)c->width + (size_t)i), rgb, 3);
}

static void draw_glyph(const canvas *c, int x, int y, const glyph *g) {
    for (int i = 0; i < GLYPH_WIDTH * GLYPH_HEIGHT; i++)
        if (g->rows[i / GLYPH_WIDTH] >> (GLYPH_WIDTH - 1 - i % GLYPH_WIDTH) & 1)
            canvas_fill(c, x + i % GLYPH_WIDTH * CANVAS_SCALE, y + i / GLYPH_WIDTH * CANVAS_SCALE,
                        CANVAS_SCALE, CANVAS_SCALE, canvas_ink);
}

void canvas_write(const canvas *c, int x, int y, const char *text) {
    for (; *text; text++, x += CANVAS_LETTER_ADVANCE)
        for (size_t g = 0; g < sizeof font / sizeof *font; g++)
            if (font[g].letter == *text) draw_glyph(c, x, y, &font[g]);
}

int canvas_text_width(const char *text) { return (int)strlen(text) * CANVAS_LETTER_ADVANCE - CANVAS_SCALE; }
