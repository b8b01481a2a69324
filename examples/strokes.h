/* strokes.h - lines and letters in space over a picture: how much of each pixel they cover, and are not
 * hidden by what the picture shows.  They are drawn in one colour at the end, so that what overlaps is not
 * darker. */
#ifndef STROKES_H
#define STROKES_H
#include <stdint.h>

/* Rows of a picture. */
typedef struct strokes {
    int width, height; /* of the whole picture, in pixels */
    int row_begin, row_end;
    uint8_t *cover;  /* of each pixel of these rows, 0..255; to begin with 0 */
    const double *t; /* how far along its ray the picture shows something; null: nothing is hidden */
    double pixel;    /* pinhole: a pixel's edge at distance 1; parallel projection: 0 */
    double nearer;   /* what is behind the surface by less than this is not hidden */
} strokes;

/* A place in the picture, y downwards, and how deep in space: the distance along the direction of view. */
typedef struct stroke_point {
    double x, y, depth; /* depth > 0 in a pinhole's picture */
} stroke_point;

/* A line so many pixels wide, with round ends. */
void strokes_line(const strokes *s, stroke_point a, stroke_point b, double width);

/* Digits, '-', '.', e, x, y, z with their middle at a point; others leave a gap.  height: of digits. */
void strokes_text(const strokes *s, stroke_point middle, double height, const char *text);

double strokes_text_width(double height, const char *text);

/* Lays a colour over rows of pixels of 3 (red, green, blue) or 4 bytes (and alpha, which grows): `bare` where
 * a pixel is transparent, `over` where it is not, and what is between them. */
void strokes_paint(const strokes *s, const uint8_t bare[3], const uint8_t over[3], uint8_t *pixels,
                   int bytes);

#endif
