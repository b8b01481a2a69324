/* parse.h - from an equation as text to a polynomial. */
#ifndef ALGSURF_EQUATION_PARSE_H
#define ALGSURF_EQUATION_PARSE_H
#include "name.h"
#include "value.h"
#include "token.h"

/* Set text and names, the rest to 0. */
typedef struct algsurf_i_parser {
    const char *text;
    algsurf_i_names names;
    size_t at;             /* how far the text is read */
    size_t letter;         /* of the name that was read last, the one that comes next */
    size_t letters_end;    /* up to here, it is a product of variables, constants and pi */
    algsurf_i_token token; /* at that place */
    const char *closing;   /* what is to close the signs about the whole, $ for one; null: there are none */
    size_t unknown;        /* the length of the name without a value, after ALGSURF_E_NAME */
    int depth;
    algsurf_status status; /* the failure, if any */
    algsurf_parse_error error;
} algsurf_i_parser;

/* Computes left minus right; returns 1, or 0 after a failure: then status is set, error for the
 * statuses that have one, and *out is not. */
int algsurf_i_parse_equation(algsurf_i_parser *p, algsurf_i_value *out);

#endif
