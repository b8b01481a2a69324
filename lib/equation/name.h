/* name.h - what a name in an equation stands for. */
#ifndef ALGSURF_EQUATION_NAME_H
#define ALGSURF_EQUATION_NAME_H
#include "parse.h"

/* The caller's constant of this name, or null. */
const algsurf_constant *algsurf_i_find_constant(const algsurf_i_parser *p, const char *name, size_t length);

/* What a product written as one name begins with: a variable, else the longest constant, else pi.  Returns
 * its length, 0 when it is none; *constant is null unless it is one of the caller's. */
size_t algsurf_i_first_factor(const algsurf_i_parser *p, const char *name, size_t length,
                              const algsurf_constant **constant);

/* Is the name, which begins at p->at, a product of factors that are known?  Then letters are read as such up
 * to its end; otherwise 0, and the parser's status and error are set. */
int algsurf_i_split_name(algsurf_i_parser *p, const char *name, size_t length);

#endif
