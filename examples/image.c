/* image.c - see image.h; PNG has its own file. */
#define _POSIX_C_SOURCE 200809L
#include "image.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "png.h"

int image_format_of(const char *path, image_format *format) {
    static const char *const endings[] = {".png", ".bmp", ".ppm"};
    const char *ending = strrchr(path, '.');
    for (int i = 0; ending && i < 3; i++) {
        if (strcasecmp(ending, endings[i]) != 0) continue;
        *format = (image_format)i;
        return 1;
    }
    return 0;
}

void image_write_ppm(FILE *file, const char *comment, int width, int height, const uint8_t *pixels) {
    fputs("P6\n", file);
    if (comment) fprintf(file, "# %s\n", comment);
    fprintf(file, "%d %d\n255\n", width, height);
    fwrite(pixels, 3 * (size_t)width, (size_t)height, file);
}

static void put_little_endian(uint8_t *at, uint32_t value) {
    for (int i = 0; i < 4; i++) at[i] = (uint8_t)(value >> 8 * i);
}

/* 24 bits a pixel, blue green red, from the bottom row up, rows padded to multiples of 4 bytes. */
static const char *write_bmp(FILE *file, int width, int height, const uint8_t *pixels) {
    enum { HEADER = 54, PIXELS_PER_METRE = 3780 }; /* 96 dots an inch */
    size_t length = (3 * (size_t)width + 3) / 4 * 4;
    if (length * (size_t)height > UINT32_MAX - HEADER) return "too large for a BMP file";
    uint32_t size = (uint32_t)(length * (size_t)height);
    uint8_t header[HEADER] = {'B', 'M', [10] = HEADER, [14] = 40, [26] = 1, [28] = 24};
    put_little_endian(header + 2, HEADER + size);
    put_little_endian(header + 18, (uint32_t)width);
    put_little_endian(header + 22, (uint32_t)height);
    put_little_endian(header + 34, size);
    put_little_endian(header + 38, PIXELS_PER_METRE);
    put_little_endian(header + 42, PIXELS_PER_METRE);
    uint8_t *row = calloc(length, 1);
    if (!row) return "out of memory";
    fwrite(header, 1, HEADER, file);
    for (int y = height - 1; y >= 0; y--) {
        const uint8_t *from = pixels + 3 * (size_t)width * (size_t)y;
        for (size_t i = 0; i < 3 * (size_t)width; i++) row[i] = from[i - i % 3 + 2 - i % 3];
        fwrite(row, 1, length, file);
    }
    free(row);
    return NULL;
}

const char *image_write_alpha(FILE *file, int width, int height, const uint8_t *pixels) {
    return png_write(file, width, height, 4, pixels);
}

const char *image_write(FILE *file, image_format format, int width, int height, const uint8_t *pixels) {
    switch (format) {
    case IMAGE_PNG:
        return png_write(file, width, height, 3, pixels);
    case IMAGE_BMP:
        return write_bmp(file, width, height, pixels);
    case IMAGE_PPM:
        image_write_ppm(file, NULL, width, height, pixels);
        return NULL;
    }
    return "unknown format";
}
