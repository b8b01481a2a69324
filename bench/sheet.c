/* sheet.c - see sheet.h. */
#include "sheet.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "results.h"

void sheet_add(sheet *s, const char *format, ...) {
    enum { MOST = 1024 };
    va_list values;
    if (s->room - s->length < MOST) {
        s->room = 2 * s->room + MOST;
        s->rows = realloc(s->rows, s->room);
        if (!s->rows) cli_no_memory();
    }
    va_start(values, format);
    int length = vsnprintf(s->rows + s->length, MOST - 1, format, values);
    va_end(values);
    if (length >= MOST - 1) cli_fail(CLI_BROKEN, "a row is too long");
    s->length += (size_t)length;
    strcpy(s->rows + s->length++, "\n");
}

typedef enum form { TEXT, TSV, CSV } form;

static const char *head_of(const sheet_column *c, form f) { return f == CSV && c->name ? c->name : c->title; }

static void put_cell(FILE *to, const sheet_column *c, form f, int first, const char *cell, size_t length) {
    static const char *const between[] = {"  ", "\t", ","};
    int is_nan =
        (length == 3 && memcmp(cell, "nan", 3) == 0) || (length == 4 && memcmp(cell, "-nan", 4) == 0);
    if (is_nan || (f == TEXT && length == 0)) cell = "-", length = 1;
    if (f == CSV && memchr(cell, ',', length)) cli_fail(CLI_BROKEN, "a comma in the cell %s", cell);
    fprintf(to, "%s%*.*s", first ? "" : between[f], f == TEXT ? c->width : 0, (int)length, cell);
}

static void put(const sheet *s, size_t begin, form f, FILE *to) {
    static const char *const before[] = {"\n", "#", ""};
    int first = 1;
    fputs(before[f], to);
    for (const sheet_column *c = s->columns; c < s->columns + s->count; c++)
        if (*head_of(c, f)) put_cell(to, c, f, first, head_of(c, f), strlen(head_of(c, f))), first = 0;
    fputc('\n', to);
    for (const char *cell = s->rows + begin, *end = s->rows + s->length; cell < end;) {
        first = 1;
        for (const sheet_column *c = s->columns; c < s->columns + s->count; c++) {
            size_t length = strcspn(cell, "\t\n");
            if (*head_of(c, f)) put_cell(to, c, f, first, cell, length), first = 0;
            cell += length + 1;
        }
        fputc('\n', to);
    }
}

void sheet_print(sheet *s, int tsv) {
    put(s, s->printed, tsv ? TSV : TEXT, stdout);
    s->printed = s->length;
}

void sheet_write(const sheet *s, const char *folder, const char *name) {
    if (!folder) return;
    FILE *file = results_open(folder, name, "wb");
    put(s, 0, CSV, file);
    results_finish(file, folder, name);
}
