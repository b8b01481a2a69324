/* steps.h - the operators of an equation: each checks its conditions and computes, or tells the
 * error.
 *
 * Each function returns 1, or 0 after a failure: then the parser's status and error are set, and operands
 * that the function takes over are freed.  Offsets are places in the text, for the error.
 */
#ifndef ALGSURF_EQUATION_STEPS_H
#define ALGSURF_EQUATION_STEPS_H
#include "parse.h"

enum { ALGSURF_I_EXPONENT_LIMIT = 64 };

/* Fails with a status and a message, which is static; refusing is to fail with E_SYNTAX. */
int algsurf_i_parse_fail(algsurf_i_parser *p, algsurf_status status, size_t offset, const char *message);
int algsurf_i_parse_refuse(algsurf_i_parser *p, size_t offset, const char *message);

/* Turns the outcome of arithmetic into 1 or 0. */
int algsurf_i_parse_computed(algsurf_i_parser *p, algsurf_status status, size_t offset);

/* v 2^exponent times the monomial of the key; err as in algsurf_i_monomial_make. */
int algsurf_i_parse_value(algsurf_i_parser *p, algsurf_dd v, double err, int exponent, int key,
                          algsurf_i_value *out);

/* A monomial as a value. */
int algsurf_i_parse_constant(algsurf_i_parser *p, algsurf_i_monomial m, size_t offset, algsurf_i_value *out);

/* *left *= right, *left /= right; right is freed, left on failure.  divisor: where that stands. */
int algsurf_i_parse_multiply(algsurf_i_parser *p, size_t offset, algsurf_i_value *left,
                             algsurf_i_value *right);
int algsurf_i_parse_divide(algsurf_i_parser *p, size_t offset, size_t divisor, algsurf_i_value *left,
                           algsurf_i_value *right);

/* Is the value, within its error bound, a whole number of magnitude up to 1000?  (This one does not fail.) */
int algsurf_i_parse_whole(const algsurf_i_value *value, int *n);

/* *base becomes base^n, and is freed on failure; exponent: where that stands. */
int algsurf_i_parse_raise(algsurf_i_parser *p, size_t offset, size_t exponent, algsurf_i_value *base, int n);

#endif
