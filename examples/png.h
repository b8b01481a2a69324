/* png.h - the PNG writer behind image.h. */
#ifndef PNG_H
#define PNG_H
#include <stdint.h>
#include <stdio.h>

/* Writes width x height pixels of red, green, blue (channels 3), or those and alpha (4), 8 bits each, as a
 * PNG.  Returns null or "out of memory"; write errors are left in ferror(file). */
const char *png_write(FILE *file, int width, int height, int channels, const uint8_t *pixels);

#endif
