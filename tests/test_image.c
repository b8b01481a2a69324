/* test_image.c - picture files: BMP and PPM byte by byte, PNG through zlib and an unfilter of its own.
 *
 * Breaks that were tried and are caught: rows from the top in a BMP, red and blue exchanged, no padding;
 * a length or distance code off by one in the PNG's DEFLATE, a match beyond the window, an overflow in
 * Adler-32 for long data, a last byte not filled, a chunk whose check sum leaves its type out, a filter
 * that takes the wrong neighbour.
 */
#include <zlib.h>

#include "image.h"
#include "unit.h"

/* 3 x 2: red green blue, black white and an odd one. */
static const uint8_t small[18] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 1, 2, 3};

typedef struct bytes {
    uint8_t *at;
    size_t size;
} bytes;

static bytes written_with(int channels, image_format format, int width, int height, const uint8_t *pixels) {
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_null(channels == 4 ? image_write_alpha(file, width, height, pixels)
                              : image_write(file, format, width, height, pixels));
    assert_int_equal(ferror(file), 0);
    bytes b = {NULL, (size_t)ftell(file)};
    b.at = malloc(b.size);
    assert_non_null(b.at);
    rewind(file);
    assert_int_equal(fread(b.at, 1, b.size, file), b.size);
    fclose(file);
    return b;
}

static bytes written(image_format format, int width, int height, const uint8_t *pixels) {
    return written_with(3, format, width, height, pixels);
}

TEST(test_format_of) {
    image_format f = IMAGE_PPM;
    assert_true(image_format_of("a.png", &f) && f == IMAGE_PNG);
    assert_true(image_format_of("a/b.c/d.PnG", &f) && f == IMAGE_PNG);
    assert_true(image_format_of("a.bmp", &f) && f == IMAGE_BMP);
    assert_true(image_format_of(".x.PPM", &f) && f == IMAGE_PPM);
    const char *others[] = {"", "png", "a.jpg", "a.pngx", "a.png/b", "a.", "a.pn"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) assert_false(image_format_of(others[i], &f));
    assert_int_equal(f, IMAGE_PPM);
}

TEST(test_ppm) {
    bytes b = written(IMAGE_PPM, 3, 2, small);
    assert_int_equal(b.size, 11 + 18);
    assert_memory_equal(b.at, "P6\n3 2\n255\n", 11);
    assert_memory_equal(b.at + 11, small, 18);
    free(b.at);
}

TEST(test_bmp) {
    static const uint8_t expected[54 + 24] = {
        'B', 'M', 78,  0,   0,    0,    0,   0, 0,    0,    54, 0, 0, 0, /* file header */
        40,  0,   0,   0,   3,    0,    0,   0, 2,    0,    0,  0, 1, 0,
        24,  0,   0,   0,   0,    0, /* size, planes, bits */
        24,  0,   0,   0,   0xc4, 0x0e, 0,   0, 0xc4, 0x0e, 0,  0, 0, 0,
        0,   0,   0,   0,   0,    0,                               /* bytes, resolution */
        0,   0,   0,   255, 255,  255,  3,   2, 1,    0,    0,  0, /* lower row, padded */
        0,   0,   255, 0,   255,  0,    255, 0, 0,    0,    0,  0};
    bytes b = written(IMAGE_BMP, 3, 2, small);
    assert_int_equal(b.size, sizeof expected);
    assert_memory_equal(b.at, expected, sizeof expected);
    free(b.at);
}

TEST(test_bmp_too_large) {
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_non_null(image_write(file, IMAGE_BMP, 65535, 65535, small)); /* refused before a pixel is read */
    assert_int_equal(ftell(file), 0);
    fclose(file);
}

static uint32_t big_endian(const uint8_t *at) {
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

/* Checks all chunks, and joins the IDAT ones. */
static bytes check_chunks(bytes png, int width, int height, int channels) {
    static const uint8_t signature[8] = {137, 80, 78, 71, 13, 10, 26, 10};
    const uint8_t kind[5] = {8, channels == 4 ? 6 : 2, 0, 0, 0};
    bytes data = {malloc(png.size), 0};
    assert_non_null(data.at);
    assert_memory_equal(png.at, signature, 8);
    int chunks = 0, ended = 0;
    for (size_t at = 8; at < png.size; chunks++) {
        assert_true(!ended && png.size - at >= 12);
        const uint8_t *chunk = png.at + at;
        size_t length = big_endian(chunk);
        assert_true(length <= png.size - at - 12);
        assert_int_equal(crc32(0, chunk + 4, (uInt)(4 + length)), big_endian(chunk + 8 + length));
        assert_int_equal(memcmp(chunk + 4, "IHDR", 4) == 0, chunks == 0);
        if (chunks == 0) {
            assert_true(length == 13 && memcmp(chunk + 16, kind, 5) == 0);
            assert_int_equal(big_endian(chunk + 8), width);
            assert_int_equal(big_endian(chunk + 12), height);
        } else if (memcmp(chunk + 4, "IDAT", 4) == 0) {
            memcpy(data.at + data.size, chunk + 8, length);
            data.size += length;
        } else {
            assert_memory_equal(chunk + 4, "IEND", 4);
            assert_int_equal(length, 0);
            ended = 1;
        }
        at += 12 + length;
    }
    assert_true(ended);
    return data;
}

static int paeth(int a, int b, int c) {
    int p = a + b - c, pa = abs(p - a), pb = abs(p - b), pc = abs(p - c);
    if (pa <= pb && pa <= pc) return a;
    return pb <= pc ? b : c;
}

/* Undoes the filters in place (ISO/IEC 15948, 9.2) and counts which were used. */
static void unfilter(uint8_t *rows, int height, size_t length, size_t left, int used[5]) {
    for (int y = 0; y < height; y++) {
        uint8_t *row = rows + (size_t)y * (length + 1) + 1, *above = row - (length + 1);
        assert_true(row[-1] < 5);
        used[row[-1]]++;
        for (size_t i = 0; i < length; i++) {
            int a = i >= left ? row[i - left] : 0, b = y > 0 ? above[i] : 0;
            int c = y > 0 && i >= left ? above[i - left] : 0;
            int add[5] = {0, a, b, (a + b) / 2, paeth(a, b, c)};
            row[i] = (uint8_t)(row[i] + add[row[-1]]);
        }
    }
}

/* Writes a PNG, decodes it, compares.  Returns the file's size. */
static size_t round_trip(int channels, int width, int height, const uint8_t *pixels, int used[5]) {
    size_t left = (size_t)channels, length = left * (size_t)width;
    uLongf size = (uLongf)((length + 1) * (size_t)height), got = size;
    bytes png = written_with(channels, IMAGE_PNG, width, height, pixels);
    bytes data = check_chunks(png, width, height, channels);
    uint8_t *rows = malloc(size);
    assert_non_null(rows);
    assert_int_equal(uncompress(rows, &got, data.at, (uLong)data.size), Z_OK); /* checks Adler-32, too */
    assert_int_equal(got, size);
    unfilter(rows, height, length, left, used);
    for (int y = 0; y < height; y++)
        assert_memory_equal(rows + (size_t)y * (length + 1) + 1, pixels + (size_t)y * length, length);
    free(rows);
    free(data.at);
    free(png.at);
    return png.size;
}

static uint32_t seed = 12345; /* fixed: every run tests the same pictures */
static unsigned random_below(unsigned n) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % n;
}

/* Kinds of content: noise, one colour, a smooth ramp, repeated stripes, rows repeated far above. */
static uint8_t *content(int kind, int channels, int width, int height) {
    size_t size = (size_t)channels * (size_t)width * (size_t)height;
    uint8_t *pixels = malloc(size);
    assert_non_null(pixels);
    uint8_t colour = (uint8_t)random_below(256);
    unsigned period = 1 + random_below(400);
    for (size_t i = 0; i < size; i++) {
        size_t x = i / 3 % (size_t)width, y = i / 3 / (size_t)width;
        if (kind == 0 || (kind >= 3 && i < period))
            pixels[i] = (uint8_t)random_below(256);
        else if (kind == 1)
            pixels[i] = colour;
        else if (kind == 2)
            pixels[i] = (uint8_t)((x * 3 + y * 2) / 7 + i % 3 * 40 + random_below(2));
        else if (kind == 3)
            pixels[i] = pixels[i - period];
        else
            pixels[i] = i > 32768 && random_below(50) ? pixels[i - 32768 + i % 2] : (uint8_t)random_below(9);
    }
    return pixels;
}

TEST(test_png) {
    static const int sizes[][2] = {{1, 1}, {2, 1}, {1, 2}, {3, 2}, {86, 3}, {200, 150}, {1, 700}, {25000, 3}};
    int used[5] = {0};
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++)
        for (int kind = 0; kind < 5; kind++) {
            for (int channels = 3; channels <= 4; channels++) {
                uint8_t *pixels = content(kind, channels, sizes[s][0], sizes[s][1]);
                round_trip(channels, sizes[s][0], sizes[s][1], pixels, used);
                free(pixels);
            }
        }
    for (int filter = 0; filter < 5; filter++) assert_true(used[filter] > 0);
}

TEST(test_png_random_sizes) {
    int used[5] = {0};
    for (int i = 0; i < 300; i++) {
        int width = 1 + (int)random_below(40), height = 1 + (int)random_below(40);
        uint8_t *pixels = content((int)random_below(5), 3, width, height);
        round_trip(3, width, height, pixels, used);
        free(pixels);
    }
}

/* A picture that is mostly background takes few bytes; so does a smooth one, if less so. */
TEST(test_png_compresses) {
    int used[5] = {0};
    uint8_t *flat = content(1, 3, 640, 480);
    assert_true(round_trip(3, 640, 480, flat, used) < 20000);
    free(flat);
}
