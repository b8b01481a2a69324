/* sheet.h - a table of results: its rows are told once, and shown to people, as TSV, or as CSV. */
#ifndef SHEET_H
#define SHEET_H
#include "cli.h"

typedef struct sheet_column {
    const char *title; /* for people, and in TSV; "": not there */
    int width;         /* of a cell for people; negative: flush left */
    const char *name;  /* in CSV; null: the title; "": not there */
} sheet_column;

typedef struct sheet {
    const sheet_column *columns;
    size_t count;
    char *rows; /* cells, tabs between them; to be freed */
    size_t length, room, printed;
} sheet;

/* One without rows, of an array of columns. */
#define SHEET(array)                                                                                         \
    { .columns = array, .count = sizeof array / sizeof *array }

/* Adds a row, a cell for each column, tabs between them.  "nan" becomes a dash. */
void sheet_add(sheet *s, const char *format, ...) CLI_FORMAT(2, 3);

/* On standard output a head, and the rows since the last time; an empty cell is a dash for people. */
void sheet_print(sheet *s, int tsv);

/* A head and all rows as a file of CSV, if the folder is not null. */
void sheet_write(const sheet *s, const char *folder, const char *name);

#endif
