/* parse.h - from an equation as text to a polynomial. */
#ifndef ALGSURF_EQUATION_PARSE_H
#define ALGSURF_EQUATION_PARSE_H
#include "algsurf/surface.h"
#include "poly.h"
#include "token.h"

/* Set text and constants, the rest to 0. */
typedef struct algsurf_i_parser {
    const char *text;
    const algsurf_constant **constants; /* sorted by name */
    size_t constant_count;
    size_t longest;        /* how many letters, digits, underscores the longest of their names has */
    size_t at;             /* how far the text is read */
    size_t letters_end;    /* up to here, names are products of variables, constants and pi */
    algsurf_i_token token; /* at that place */
    const char *closing;   /* what is to close the signs about the whole, $ for one; null: there are none */
    size_t unknown;        /* the length of the name without a value, after ALGSURF_E_NAME */
    int depth;
    algsurf_status status; /* the failure, if any */
    algsurf_parse_error error;
} algsurf_i_parser;

/* Computes left minus right; returns 1, or 0 after a failure: then status is set, error for the
 * statuses that have one, and *out is not. */
int algsurf_i_parse_equation(algsurf_i_parser *p, algsurf_i_tripoly *out);

#endif
