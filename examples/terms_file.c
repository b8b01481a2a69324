/* terms_file.c - see terms_file.h.  The time is linear in the size of the file. */
#include "terms_file.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"

enum { MOST_BYTES = 1 << 24 }; /* a surface of the highest degree has 48000 terms, a line each */

typedef struct reader {
    cli_line line;
    size_t bytes;
    algsurf_term *terms;
    size_t count, capacity;
    terms_error *error;
} reader;

static int refuse(reader *r, size_t line, const char *format, ...) CLI_FORMAT(3, 4);
static int refuse(reader *r, size_t line, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r->error->message, sizeof r->error->message, format, arguments);
    va_end(arguments);
    r->error->line = line;
    return -1;
}

static int refuse_for_memory(reader *r) {
    r->error->no_memory = 1;
    return refuse(r, 0, "out of memory");
}

static int parse_exponent(reader *r, const char *text, int *exponent) {
    if (cli_whole(text, 0, ALGSURF_MAX_DEGREE, exponent)) return 0;
    return refuse(r, r->line.number, "expected an exponent from 0 to %d, got '%s'", ALGSURF_MAX_DEGREE,
                  cli_quote(text).text);
}

static int parse_term(reader *r, char **field, algsurf_term *term) {
    int *exponents[3] = {&term->i, &term->j, &term->k};
    for (int axis = 0; axis < 3; axis++)
        if (parse_exponent(r, field[axis], exponents[axis]) != 0) return -1;
    if (term->i + term->j + term->k > ALGSURF_MAX_DEGREE)
        return refuse(r, r->line.number, "degree %d is above the limit of %d", term->i + term->j + term->k,
                      ALGSURF_MAX_DEGREE);
    if (!cli_number(field[3], &term->a))
        return refuse(r, r->line.number, "expected a number, got '%s'", cli_quote(field[3]).text);
    if (!isfinite(term->a))
        return refuse(r, r->line.number, "expected a finite double, got '%s'", cli_quote(field[3]).text);
    return 0;
}

static int keep(reader *r, const algsurf_term *term) {
    if (r->count == r->capacity) {
        size_t capacity = r->capacity ? 2 * r->capacity : 64;
        algsurf_term *terms = realloc(r->terms, capacity * sizeof *terms);
        if (!terms) return refuse_for_memory(r);
        r->terms = terms;
        r->capacity = capacity;
    }
    r->terms[r->count++] = *term;
    return 0;
}

static void skip_byte_order_mark(cli_line *line) {
    if (line->number != 1 || line->length < 3 || memcmp(line->text, "\xef\xbb\xbf", 3) != 0) return;
    line->length -= 3;
    memmove(line->text, line->text + 3, line->length + 1);
}

/* The line that was just read. */
static int take_line(reader *r) {
    char *field[4];
    skip_byte_order_mark(&r->line);
    int fields = cli_split(&r->line, field, 4);
    if (fields < 0) return refuse(r, r->line.number, "a NUL byte: not a text file");
    if (fields == 0) return 0;
    if (fields != 4) return refuse(r, r->line.number, "expected four fields 'i j k a', got %d", fields);
    algsurf_term term;
    return parse_term(r, field, &term) != 0 ? -1 : keep(r, &term);
}

static int read_terms(reader *r, FILE *file) {
    for (;;) {
        cli_line_result got = cli_read_line(file, &r->line);
        if (got == CLI_LINE_NO_MEMORY) return refuse_for_memory(r);
        if (got == CLI_LINE_TOO_LONG) return refuse(r, r->line.number + 1, "the line is too long");
        if (ferror(file)) return refuse(r, 0, "%s", strerror(errno));
        if (got == CLI_LINE_END) return r->count > 0 ? 0 : refuse(r, 0, "no terms");
        r->bytes += r->line.length + 1;
        if (r->bytes > MOST_BYTES) return refuse(r, 0, "more than 16 MiB: no file of terms is that long");
        if (take_line(r) != 0) return -1;
    }
}

int terms_read_surface(FILE *file, algsurf_surface **surface, terms_error *error) {
    reader r = {.error = error};
    *error = (terms_error){0};
    int result = read_terms(&r, file);
    if (result == 0) {
        algsurf_status status = algsurf_surface_from_terms(r.terms, r.count, surface);
        if (status == ALGSURF_E_NO_MEMORY)
            result = refuse_for_memory(&r);
        else if (status != ALGSURF_OK)
            result = refuse(&r, 0, "%s", algsurf_status_text(status));
    }
    free(r.terms);
    free(r.line.text);
    return result;
}
