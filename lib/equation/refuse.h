/* refuse.h - why an equation is refused at a place: what people try there, and what to write
 * instead.
 *
 * Each function sets the parser's status and error, and returns 0.
 */
#ifndef ALGSURF_EQUATION_REFUSE_H
#define ALGSURF_EQUATION_REFUSE_H
#include "parse.h"

/* The message for functions. */
#define ALGSURF_I_NOT_POLYNOMIAL                                                                             \
    "not a polynomial: of functions, only sqrt, sin and cos of constants are known"

/* Refuses the name at p->at, whose letters from number `known` on, in bytes, are no factor. */
int algsurf_i_refuse_name(algsurf_i_parser *p, const char *name, size_t length, size_t known);

/* Refuses p->token, with an explanation where it is something people try, or with the words `expected`. */
int algsurf_i_refuse_token(algsurf_i_parser *p, const char *expected);

#endif
