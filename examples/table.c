/* table.c - see table.h. */
#include "table.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

void table_head(const table *t) {
    if (!t->json) printf("#%s\n", t->columns);
}

void table_add(table *t, const char *format, ...) {
    enum { MOST = 512 };
    va_list values;
    if (t->capacity - t->length < MOST) {
        t->capacity = 2 * t->capacity + MOST;
        t->row = realloc(t->row, t->capacity);
        if (!t->row) cli_no_memory();
    }
    va_start(values, format);
    int length = vsnprintf(t->row + t->length, MOST, format, values);
    va_end(values);
    t->length += length < MOST ? (size_t)length : MOST - 1;
}

/* JSON's numbers: no plus, no digits left out, nothing hexadecimal. */
static int is_number(const char *text, size_t length) {
    static const char digits[] = "0123456789";
    const char *end = text + length, *at = text + (length > 0 && *text == '-');
    size_t whole = strspn(at, digits);
    if (whole == 0 || (whole > 1 && *at == '0')) return 0;
    at += whole;
    if (at < end && *at == '.') {
        size_t fraction = strspn(at + 1, digits);
        if (fraction == 0) return 0;
        at += 1 + fraction;
    }
    if (at < end && (*at == 'e' || *at == 'E')) {
        at += 1 + (at[1] == '+' || at[1] == '-');
        size_t exponent = strspn(at, digits);
        if (exponent == 0) return 0;
        at += exponent;
    }
    return at == end;
}

static void print_string(FILE *file, const char *text, size_t length) {
    fputc('"', file);
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)text[i];
        if (c < ' ')
            fprintf(file, "\\u%04x", c);
        else if (c == '"' || c == '\\')
            fprintf(file, "\\%c", c);
        else
            fputc(c, file);
    }
    fputc('"', file);
}

void table_member(FILE *file, const char *key, size_t key_length, const char *value, size_t length,
                  int is_text) {
    print_string(file, key, key_length);
    fputs(": ", file);
    if (!is_text && length == 1 && *value == '-')
        fputs("null", file);
    else if (!is_text && is_number(value, length))
        fwrite(value, 1, length, file);
    else
        print_string(file, value, length);
}

/* One row, without its newline. */
static void print_object(const table *t, const char *row) {
    const char *column = t->columns;
    fputc('{', stdout);
    for (;;) {
        size_t name = strcspn(column, "\t"), length = strcspn(row, "\t");
        table_member(stdout, column, name, row, length, 0);
        column += name;
        row += length;
        if (!*column || !*row) break;
        fputs(", ", stdout);
        column++;
        row++;
    }
    fputs("}\n", stdout);
}

void table_print(const table *t, char *rows) {
    if (!t->json) {
        fputs(rows, stdout);
        return;
    }
    for (char *end; (end = strchr(rows, '\n')); rows = end + 1) {
        *end = '\0';
        print_object(t, rows);
    }
}

void table_end(table *t) {
    table_add(t, "\n");
    table_print(t, t->row);
    t->length = 0;
}
