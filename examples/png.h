/* png.h - the PNG writer behind image.h. */
#ifndef PNG_H
#define PNG_H
#include <stdint.h>
#include <stdio.h>

/* Writes width x height pixels of red, green, blue (channels 3), or those and alpha (4), 8 bits each, as a
 * PNG.  Returns null or "out of memory"; write errors are left in ferror(file). */
const char *png_write(FILE *file, int width, int height, int channels, const uint8_t *pixels);

/* The same in steps, for animations, too: a writer; null when out of memory. */
typedef struct png_writer png_writer;
png_writer *png_begin(FILE *file, int width, int height, int channels);
/* So many pictures follow, 1 to 255 of them each second, again and again. */
void png_animate(png_writer *png, int frames, int a_second);
/* The next picture; 0 when out of memory. */
int png_frame(png_writer *png, const uint8_t *pixels);
void png_end(png_writer *png);

#endif
