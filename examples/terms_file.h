/* terms_file.h - a surface from a text file of terms.
 *
 * Each line is "i j k a", the term a x^i y^j z^k: three decimal exponents and a coefficient, decimal
 * or hexadecimal, separated by blanks or tabs.  '#' starts a comment, blank lines are skipped, lines
 * end with LF or CR LF, a byte order mark at the start is skipped.  Terms with the same exponents add up.
 */
#ifndef TERMS_FILE_H
#define TERMS_FILE_H
#include <stddef.h>
#include <stdio.h>

#include "algsurf/surface.h"

typedef struct terms_error {
    size_t line; /* from 1; 0: the file as a whole */
    int no_memory;
    char message[160]; /* one line, printable */
} terms_error;

/* Reads the file to its end and makes the surface, to be freed with algsurf_surface_free.
 * Returns 0; -1 with *error filled and *surface untouched. */
int terms_read_surface(FILE *file, algsurf_surface **surface, terms_error *error);

#endif
