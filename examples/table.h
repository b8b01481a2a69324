/* table.h - tables on standard output: TSV, or JSON, an object a row, a row a line.
 *
 * A row is written as TSV; as JSON, fields that are numbers are numbers, "-" is null, and all others are
 * strings: also inf, which JSON does not have as a number.
 */
#ifndef TABLE_H
#define TABLE_H
#include <stddef.h>
#include <stdio.h>

#include "cli.h"

typedef struct table {
    const char *columns; /* their names, tabs between them */
    int json;
    char *row; /* the row in the making; to be freed */
    size_t length, capacity;
} table;

/* Prints the names of the columns behind a '#'; nothing in JSON. */
void table_head(const table *t);

/* Adds to the row what printf would print: fields, tabs between them. */
void table_add(table *t, const char *format, ...) CLI_FORMAT(2, 3);

/* Prints the row and begins the next one. */
void table_end(table *t);

/* Prints rows, each ended by a newline; the text is no longer needed. */
void table_print(const table *t, char *rows);

/* A member of a JSON object, "key": value; is_text: a string even if it looks like a number. */
void table_member(FILE *file, const char *key, size_t key_length, const char *value, size_t length,
                  int is_text);

#endif
