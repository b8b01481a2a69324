/* image.h - pictures as files: PNG, BMP, PPM.
 *
 * A picture is width x height pixels of three bytes, red green blue, row by row from the top.
 */
#ifndef IMAGE_H
#define IMAGE_H
#include <stdint.h>
#include <stdio.h>

typedef enum image_format { IMAGE_PNG, IMAGE_BMP, IMAGE_PPM } image_format;

/* The format by a file name's ending, .png .bmp .ppm in any case; 0 for another ending. */
int image_format_of(const char *path, image_format *format);

/* Writes a picture.  Returns null, or what went wrong ("out of memory", "too large for a BMP file");
 * a write error is left to the caller to see, in ferror(file). */
const char *image_write(FILE *file, image_format format, int width, int height, const uint8_t *pixels);

/* The same for pixels of four bytes, the last one alpha, as a PNG. */
const char *image_write_alpha(FILE *file, int width, int height, const uint8_t *pixels);

/* A PPM with a line of comment, null for none. */
void image_write_ppm(FILE *file, const char *comment, int width, int height, const uint8_t *pixels);

#endif
