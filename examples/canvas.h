/* canvas.h - rectangles and letters in a picture of three bytes a pixel. */
#ifndef CANVAS_H
#define CANVAS_H
#include <stdint.h>

typedef struct canvas {
    uint8_t *pixels; /* red green blue, row by row from the top */
    int width;       /* of a row, in pixels */
} canvas;

enum { CANVAS_SCALE = 2 }; /* pixels a point: letters are 5 x 7 points, p and the like 5 x 9, and one apart */
enum { CANVAS_LETTER_ADVANCE = (5 + 1) * CANVAS_SCALE };

extern const uint8_t canvas_ink[3];

/* A rectangle; what is drawn, here and below, must lie inside the picture. */
void canvas_fill(const canvas *c, int x, int y, int width, int height, const uint8_t rgb[3]);

/* A text, in ink, with its upper left corner at (x,y): small letters, digits, and + - : are drawn, any
 * other character leaves a gap. */
void canvas_write(const canvas *c, int x, int y, const char *text);

/* In pixels. */
int canvas_text_width(const char *text);

#endif
