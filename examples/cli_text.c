/* cli_text.c - see cli_text.h. */
#include "cli.h"

#include <stdlib.h>
#include <string.h>

static const char REPLACEMENT[] = "\xef\xbf\xbd"; /* U+FFFD */

/* The number of bytes of a UTF-8 character whose first byte is c; 0 if none begins so. */
static size_t bytes_of(unsigned char c) {
    return c < 0x80 ? 1 : c < 0xc2 ? 0 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : c < 0xf5 ? 4 : 0;
}

/* Controls, and the characters that turn the direction of a line or break it. */
static int is_control(unsigned long c) {
    return c < ' ' || (c >= 0x7f && c < 0xa0) || (c >= 0x2028 && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
}

typedef struct character {
    size_t bytes; /* 0 at the end of the text */
    int shown;    /* as it is */
} character;

static character character_at(const char *text) {
    const unsigned char *at = (const unsigned char *)text;
    static const unsigned long least[5] = {0, 0, 0x80, 0x800, 0x10000};
    size_t n = bytes_of(at[0]);
    if (at[0] == '\0') return (character){0, 0};
    if (n == 0) return (character){1, 0};
    unsigned long code = n == 1 ? at[0] : at[0] & (0x7fu >> n);
    for (size_t i = 1; i < n; i++) {
        if ((at[i] & 0xc0) != 0x80) return (character){i, 0};
        code = code << 6 | (at[i] & 0x3f);
    }
    int is_code = code >= least[n] && code <= 0x10ffff && !(code >= 0xd800 && code <= 0xdfff);
    return (character){n, is_code && !is_control(code)};
}

cli_quoted cli_quote(const char *text) {
    cli_quoted quoted;
    size_t n = 0;
    for (character c; (c = character_at(text)).bytes > 0; text += c.bytes) {
        const char *from = c.shown ? text : REPLACEMENT;
        size_t bytes = c.shown ? c.bytes : strlen(REPLACEMENT);
        if (n + bytes + sizeof "..." > sizeof quoted.text) break;
        memcpy(quoted.text + n, from, bytes);
        n += bytes;
    }
    strcpy(quoted.text + n, *text ? "..." : "");
    return quoted;
}

size_t cli_column(const char *text, size_t offset) {
    size_t column = 1;
    const char *end = text + offset;
    for (character c; text < end && (c = character_at(text)).bytes > 0; text += c.bytes) column++;
    return column;
}

/* Characters of the text, `count` at most; blanks for tabs and ends of lines. */
static const char *print_some(FILE *file, const char *text, size_t count) {
    for (character c; count > 0 && (c = character_at(text)).bytes > 0; count--, text += c.bytes) {
        if (c.shown)
            fwrite(text, 1, c.bytes, file);
        else
            fputs(*text >= '\t' && *text <= '\r' ? " " : REPLACEMENT, file);
    }
    return text;
}

void cli_point_at(FILE *file, const char *text, size_t offset, size_t length) {
    enum { WIDEST = 72, BEFORE = 48 }; /* columns, and those before the mark in a longer text */
    size_t first = cli_column(text, offset), end = cli_column(text, offset + length), cut = 0;
    if (end <= first) end = first + 1;
    if (first > WIDEST) {
        for (; cut < first - BEFORE; cut++) text += character_at(text).bytes;
    }
    if (end > cut + WIDEST + 1) end = cut + WIDEST + 1;
    fputs(cut > 0 ? "  ..." : "  ", file);
    text = print_some(file, text, WIDEST);
    fprintf(file, "%s\n%*s", *text ? "..." : "", (int)(first - cut - 1) + (cut > 0 ? 5 : 2), "");
    for (; first < end; first++) fputc('^', file);
    fputc('\n', file);
}

char *cli_copy(const char *text, size_t length) {
    char *copy = malloc(length + 1);
    if (!copy) cli_no_memory();
    memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}
