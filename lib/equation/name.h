/* name.h - what a name in an equation stands for: a constant, or a product of constants, x, y, z and pi. */
#ifndef ALGSURF_EQUATION_NAME_H
#define ALGSURF_EQUATION_NAME_H
#include <stddef.h>

#include "algsurf/surface.h"

/* A letter of a name, and the longest constant that the name goes on with from there; null: none. */
typedef struct algsurf_i_name_letter {
    size_t at; /* in bytes, from the name's beginning */
    int code;
    const algsurf_constant *constant;
} algsurf_i_name_letter;

/* The names of the constants as a tree, and the name that was read last.  All 0 at first. */
typedef struct algsurf_i_names {
    struct algsurf_i_name_node *node;
    algsurf_i_name_letter *letter; /* and one behind the last, for its place */
    size_t count, capacity;        /* of letters */
} algsurf_i_names;

/* Fails with E_ARGUMENT when two names are the same, or with E_NO_MEMORY; to be freed anyway.  The names are
 * checked.  Cost: linear in the lengths of the names. */
algsurf_status algsurf_i_names_make(algsurf_i_names *names, const algsurf_constant *constants, size_t count);
void algsurf_i_names_free(algsurf_i_names *names);

/* Reads the name at the start of text.  Cost: linear in its length. */
algsurf_status algsurf_i_names_read(algsurf_i_names *names, const char *text);

/* Of how many letters is the factor that begins with letter i, as part of a product: a variable, else the
 * longest constant, else pi; 0 when it is none.  *constant is null unless it is one of the caller's. */
size_t algsurf_i_names_factor(const algsurf_i_names *names, size_t i, const algsurf_constant **constant);

/* The constant that is the whole name; null: it is none. */
const algsurf_constant *algsurf_i_names_whole(const algsurf_i_names *names);

#endif
