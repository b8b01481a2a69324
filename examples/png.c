/* png.c - a PNG writer that needs nothing but libc.
 *
 * PNG (third edition, which has animations; else ISO/IEC 15948): each row is predicted by one of five
 * filters, the one with the least sum of magnitudes; the residuals are compressed by DEFLATE (RFC 1951) in
 * the zlib format (RFC 1950). DEFLATE comes in its smallest complete form: matches of up to 258 bytes within
 * the last 32 KiB, found by hash chains of limited length, and the fixed Huffman codes, in one single block.
 * Fixed codes suit residuals badly (8 or 9 bits for a small number), matches suit synthetic pictures well.
 */
#include "png.h"

#include <stdlib.h>
#include <string.h>

enum {
    WINDOW = 1 << 15,      /* how far back a match may lie */
    SHORTEST = 3,          /* a match */
    LONGEST = 258,         /* a match */
    CHAIN = 8,             /* candidates looked at for a match */
    ENTERED = 16,          /* positions of a match, for later ones */
    HASH_BITS = 15,        /* of three bytes */
    CHUNK = 1 << 16,       /* bytes of an IDAT chunk */
    ADLER_MODULUS = 65521, /* the largest prime below 2^16 */
    SYMBOLS = 286,
    FILTERS = 5
};

struct png_writer {
    FILE *file;
    int width, height, channels;
    int frames, a_second; /* written; shown each second, 0: no animation */
    uint32_t sequence;    /* of the animation's chunks */
    uint32_t crc_table[256];
    uint8_t chunk[CHUNK]; /* compressed bytes not yet written */
    size_t used;
    uint32_t bits; /* of the last byte, lowest first */
    int bit_count;
    uint16_t code[SYMBOLS]; /* of literals, the end and lengths, lowest bit first, */
    uint8_t code_bits[SYMBOLS];
    uint32_t head[1 << HASH_BITS]; /* one more than the last position with this hash, modulo 2^32; 0: none */
    uint32_t previous[WINDOW];     /* one more than the position before with the same hash */
};

/* ---- chunks ---- */

static void make_crc_table(png_writer *png) {
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t c = i;
        for (int k = 0; k < 8; k++) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
        png->crc_table[i] = c;
    }
}

static uint32_t crc(const png_writer *png, uint32_t c, const uint8_t *data, size_t length) {
    while (length-- > 0) c = png->crc_table[(c ^ *data++) & 0xff] ^ (c >> 8);
    return c;
}

static void put_big_endian(uint8_t *at, uint32_t value) {
    for (int i = 0; i < 4; i++) at[i] = (uint8_t)(value >> (24 - 8 * i));
}

static void write_chunk(png_writer *png, const char *type, const uint8_t *data, size_t length) {
    uint8_t head[8], tail[4];
    put_big_endian(head, (uint32_t)length);
    memcpy(head + 4, type, 4);
    put_big_endian(tail, ~crc(png, crc(png, 0xffffffffu, head + 4, 4), data, length));
    fwrite(head, 1, sizeof head, png->file);
    fwrite(data, 1, length, png->file);
    fwrite(tail, 1, sizeof tail, png->file);
}

/* Frames after the first one have chunks of another name that begin with a number. */
static void write_data(png_writer *png) {
    write_chunk(png, png->frames > 0 ? "fdAT" : "IDAT", png->chunk, png->used);
    png->used = 0;
}

static void put_byte(png_writer *png, uint8_t byte) {
    if (png->used == 0 && png->frames > 0) {
        put_big_endian(png->chunk, png->sequence++);
        png->used = 4;
    }
    png->chunk[png->used++] = byte;
    if (png->used == CHUNK) write_data(png);
}

/* ---- DEFLATE ---- */

/* A number of up to 16 bits, lowest bit first. */
static void put_bits(png_writer *png, unsigned value, int count) {
    png->bits |= (uint32_t)value << png->bit_count;
    for (png->bit_count += count; png->bit_count >= 8; png->bit_count -= 8) {
        put_byte(png, (uint8_t)(png->bits & 0xff));
        png->bits >>= 8;
    }
}

/* A Huffman code, highest bit first, as a number whose lowest bit is first. */
static unsigned reversed(unsigned code, int count) {
    unsigned turned = 0;
    for (int i = 0; i < count; i++) turned |= (code >> i & 1u) << (count - 1 - i);
    return turned;
}

/* RFC 1951, 3.2.6: of a literal byte, the end of the block (256), or a length code. */
static void make_codes(png_writer *png) {
    for (unsigned s = 0; s < SYMBOLS; s++) {
        const int bits = s < 144 ? 8 : s < 256 ? 9 : s < 280 ? 7 : 8;
        const unsigned code = s < 144   ? 0x30 + s
                              : s < 256 ? 0x190 + s - 144
                              : s < 280 ? s - 256
                                        : 0xc0 + s - 280;
        png->code[s] = (uint16_t)reversed(code, bits);
        png->code_bits[s] = (uint8_t)bits;
    }
}

static void put_symbol(png_writer *png, unsigned symbol) {
    put_bits(png, png->code[symbol], png->code_bits[symbol]);
}

static int log2_floor(size_t n) {
    int e = 0;
    while (n >>= 1) e++;
    return e;
}

/* The codes of RFC 1951, 3.2.5, grow like floating-point numbers: a length minus 3 has two bits of
 * mantissa, a distance minus 1 has one; what the mantissa leaves out follows as extra bits. */
static void put_match(png_writer *png, size_t length, size_t distance) {
    size_t l = length - SHORTEST, d = distance - 1;
    if (length == LONGEST) {
        put_symbol(png, 285);
    } else {
        int extra = l < 8 ? 0 : log2_floor(l) - 2;
        put_symbol(png, 257 + 4 * (unsigned)extra + (unsigned)(l >> extra));
        put_bits(png, (unsigned)(l & ((1u << extra) - 1)), extra);
    }
    int extra = d < 4 ? 0 : log2_floor(d) - 1;
    put_bits(png, reversed(2 * (unsigned)extra + (unsigned)(d >> extra), 5), 5);
    put_bits(png, (unsigned)(d & ((1u << extra) - 1)), extra);
}

static size_t match_length(const uint8_t *a, const uint8_t *b, size_t most) {
    size_t n = 0;
    while (n + 8 <= most && memcmp(a + n, b + n, 8) == 0) n += 8;
    while (n < most && a[n] == b[n]) n++;
    return n;
}

/* Enters a position into the hash chains; returns one more than the one before with its hash. */
static uint32_t enter(png_writer *png, const uint8_t *data, size_t size, size_t at) {
    if (size - at < SHORTEST) return 0;
    uint32_t bytes = (uint32_t)data[at] << 16 | (uint32_t)data[at + 1] << 8 | data[at + 2];
    uint32_t hash = bytes * 2654435761u >> (32 - HASH_BITS); /* 2^32 / golden ratio: Knuth, TAOCP 6.4 */
    const uint32_t before = png->head[hash];
    png->previous[at % WINDOW] = before;
    png->head[hash] = (uint32_t)(at + 1);
    return before;
}

/* The longest match for a position among the first candidates of its chain. */
static size_t find_match(const png_writer *png, const uint8_t *data, size_t size, size_t at,
                         uint32_t candidate, size_t *distance) {
    const size_t most = size - at < LONGEST ? size - at : LONGEST;
    size_t best = 0;
    for (int i = 0; i < CHAIN && candidate > 0; i++) {
        const size_t back = (uint32_t)(at + 1) - candidate, from = at - back;
        if (back == 0 || back >= WINDOW || back > at) break;
        const int may_be_longer = data[from + best] == data[at + best]; /* best < most */
        const size_t length = may_be_longer ? match_length(data + from, data + at, most) : 0;
        if (length > best) {
            best = length;
            *distance = back;
            if (best == most) break;
        }
        candidate = png->previous[from % WINDOW];
    }
    return best;
}

static uint32_t adler32(const uint8_t *data, size_t size) {
    uint32_t a = 1, b = 0;
    while (size > 0) {
        size_t part = size < 5552 ? size : 5552; /* the most additions that b survives in 32 bits */
        size -= part;
        while (part-- > 0) b += a += *data++;
        a %= ADLER_MODULUS;
        b %= ADLER_MODULUS;
    }
    return b << 16 | a;
}

static void write_compressed(png_writer *png, const uint8_t *data, size_t size) {
    memset(png->head, 0, sizeof png->head);
    png->bits = 0;
    png->bit_count = 0;
    uint8_t check[4];
    put_byte(png, 0x78); /* DEFLATE, window of 32 KiB */
    put_byte(png, 0x01); /* no dictionary; makes the two bytes a multiple of 31 */
    put_bits(png, 1, 1); /* the last block */
    put_bits(png, 1, 2); /* fixed codes */
    for (size_t at = 0; at < size;) {
        size_t distance = 0;
        const uint32_t candidate = enter(png, data, size, at);
        const size_t length = find_match(png, data, size, at, candidate, &distance);
        if (length < SHORTEST) {
            put_symbol(png, data[at++]);
            continue;
        }
        put_match(png, length, distance);
        for (size_t i = 1; i < length && i < ENTERED; i++) enter(png, data, size, at + i);
        at += length;
    }
    put_symbol(png, 256);
    put_bits(png, 0, 7); /* fills the last byte */
    put_big_endian(check, adler32(data, size));
    for (int i = 0; i < 4; i++) put_byte(png, check[i]);
    if (png->used > 0) write_data(png);
}

/* ---- filters ---- */

/* The nearest of a, b, c to a + b - c: Paeth's predictor. */
static int nearest(int a, int b, int c) {
    const int da = abs(b - c), db = abs(a - c), dc = abs(a + b - 2 * c);
    return ((da <= db) & (da <= dc)) ? a : db <= dc ? b : c;
}

/* What a filter leaves of a row, behind the filter's number, and the sum of its magnitudes modulo 256.
 * `left` zeros stand before each of the rows. */
static inline unsigned filter_row(int filter, const uint8_t *row, const uint8_t *above, size_t length,
                                  size_t left, uint8_t *restrict out) {
    const uint8_t *before = row - left, *above_before = above - left;
    unsigned sum = 0;
    *out++ = (uint8_t)filter;
    for (size_t i = 0; i < length; i++) {
        const int a = before[i], b = above[i], c = above_before[i];
        const int guess = filter == 0   ? 0
                          : filter == 1 ? a
                          : filter == 2 ? b
                          : filter == 3 ? (a + b) / 2
                                        : nearest(a, b, c);
        out[i] = (uint8_t)(row[i] - guess);
        sum += out[i] < 128 ? out[i] : 256u - out[i];
    }
    return sum;
}

/* The row by the filter with the least sum; other: room for a row behind a number. */
static void write_filtered(const uint8_t *row, const uint8_t *above, size_t length, size_t left, uint8_t *out,
                           uint8_t *other) {
    unsigned least = filter_row(0, row, above, length, left, out);
    for (int filter = 1; filter < FILTERS; filter++) {
        const unsigned sum = filter_row(filter, row, above, length, left, other);
        if (sum >= least) continue;
        least = sum;
        memcpy(out, other, length + 1);
    }
}

png_writer *png_begin(FILE *file, int width, int height, int channels) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t header[13] = {
        [8] = 8, [9] = channels == 4 ? 6 : 2}; /* bits a sample, colour with alpha or without */
    png_writer *png = calloc(1, sizeof *png);
    if (!png) return NULL;
    png->file = file;
    png->width = width;
    png->height = height;
    png->channels = channels;
    make_crc_table(png);
    make_codes(png);
    put_big_endian(header, (uint32_t)width);
    put_big_endian(header + 4, (uint32_t)height);
    fwrite(signature, 1, sizeof signature, file);
    write_chunk(png, "IHDR", header, sizeof header);
    return png;
}

void png_animate(png_writer *png, int frames, int a_second) {
    uint8_t control[8] = {0}; /* frames, and how often they are shown: 0, for ever */
    put_big_endian(control, (uint32_t)frames);
    write_chunk(png, "acTL", control, sizeof control);
    png->a_second = a_second;
}

/* Before each picture of an animation: all of it is replaced, and stays for its time. */
static void write_frame_control(png_writer *png) {
    uint8_t control[26] = {[21] = 1}; /* the delay's numerator is 1 */
    put_big_endian(control, png->sequence++);
    put_big_endian(control + 4, (uint32_t)png->width);
    put_big_endian(control + 8, (uint32_t)png->height);
    control[23] = (uint8_t)png->a_second;
    write_chunk(png, "fcTL", control, sizeof control);
}

/* rows: room for three, with zeros before them. */
static void filter_rows(const png_writer *png, const uint8_t *pixels, uint8_t *rows, uint8_t *filtered) {
    const size_t left = (size_t)png->channels, length = left * (size_t)png->width;
    uint8_t *row = rows + left, *above = row + left + length, *other = above + length;
    for (size_t y = 0; y < (size_t)png->height; y++) {
        memcpy(row, pixels + y * length, length);
        write_filtered(row, above, length, left, filtered + y * (length + 1), other);
        uint8_t *next = above;
        above = row, row = next;
    }
}

int png_frame(png_writer *png, const uint8_t *pixels) {
    size_t left = (size_t)png->channels, length = left * (size_t)png->width;
    size_t size = (length + 1) * (size_t)png->height;
    uint8_t *filtered = malloc(size), *rows = calloc(3, left + length);
    if (filtered && rows) {
        filter_rows(png, pixels, rows, filtered);
        if (png->a_second > 0) write_frame_control(png);
        write_compressed(png, filtered, size);
    }
    const int done = filtered && rows;
    free(filtered);
    free(rows);
    if (!done) return 0;
    png->frames++;
    return 1;
}

void png_end(png_writer *png) {
    write_chunk(png, "IEND", png->chunk, 0);
    free(png);
}

const char *png_write(FILE *file, int width, int height, int channels, const uint8_t *pixels) {
    png_writer *png = png_begin(file, width, height, channels);
    if (!png) return "out of memory";
    int written = png_frame(png, pixels);
    png_end(png);
    return written ? NULL : "out of memory";
}
