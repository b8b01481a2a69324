/* parse.h - from an equation as text to a polynomial: the reader's state, its operators, its refusals. */
#ifndef ALGSURF_EQUATION_PARSE_H
#define ALGSURF_EQUATION_PARSE_H
#include "read.h"
#include "poly.h"

enum { ALGSURF_I_DEPTH_LIMIT = 100, ALGSURF_I_PUT_IN_LIMIT = 20000 };

/* A name that the text gives to a sum, and where that is in the text.  The name comes first, so that it tells
 * the definition; its value is NaN, which no caller's is. */
typedef struct algsurf_i_definition {
    algsurf_constant name;
    size_t begin, end;
} algsurf_i_definition;

/* Set text and names, the rest to 0. */
typedef struct parser {
    const char *text;
    algsurf_i_names names;
    size_t at;             /* how far the text is read */
    size_t letter;         /* of the name that was read last, the one that comes next */
    size_t letters_end;    /* up to here, it is a product of variables, constants and pi */
    algsurf_i_token token; /* at that place */
    const char *closing;   /* what is to close the signs about the whole, $ for one; null: there are none */
    algsurf_i_definition *definition;
    size_t definitions, known; /* how many; of how many the text is read */
    size_t put_in;             /* bytes of definitions that were read where their names stand */
    int depth;
    algsurf_status status; /* the failure, if any */
    algsurf_parse_error error;
    int values; /* on the stack: at each depth a product and a base, or a numerator; and the left side */
    value value[2 * (ALGSURF_I_DEPTH_LIMIT + 1) + 2];
} parser;

static inline value *algsurf_i_parse_top(parser *p) { return p->value + p->values - 1; }

/* Functions return 1, or 0 after a failure: then status is set, and error for the statuses that have one.
 * What stands on the stack is to be freed in any case.  Offsets are places in the text, for the error. */

/* text.c.  Leaves left minus right on the stack. */
int algsurf_i_parse_equation(parser *p);

/* parse.c.  The next token that is not blank; p->at is its place, p->token itself.  Moves behind it. */
int algsurf_i_parse_peek(parser *p);
static inline void algsurf_i_parse_take(parser *p) { p->at += p->token.width; }

/* One value more: a sum; a sum up to the bracket that closes the one of p->token; a part of the text, one
 * level deeper. */
int algsurf_i_parse_sum(parser *p);
int algsurf_i_parse_inside(parser *p);
int algsurf_i_parse_nested(parser *p, size_t offset, int (*part)(parser *));

/* define.c: names that a text gives to sums, w = y^2 + z^2; before its equation.  The first function finds
 * them and moves to where the equation begins.  The second one reads them.  The third is for a name in the
 * text: one value more, that of its sum, which is read once more there. */
algsurf_status algsurf_i_definitions_find(parser *p);
int algsurf_i_parse_definitions(parser *p);
int algsurf_i_parse_defined(parser *p, const algsurf_i_definition *definition, size_t place);

/* povray.c: poly, quadric, cubic and quartic of POV-Ray.  *is_one becomes whether p->at is the beginning of
 * one; then one value more. */
int algsurf_i_parse_povray(parser *p, int *is_one);

/* series.c: T_n(a), U_n(a) and P_n(a).  Is that at the start of text?  *head becomes what it is, with all up
 * to its a.  One value more: the one that begins at p->at. */
typedef struct algsurf_i_series_head {
    size_t width;
    int kind, index; /* the place of its letter in T U P; n, at most 1000 */
    char bracket;    /* in which a stands */
} algsurf_i_series_head;
int algsurf_i_series_follows(const char *text, algsurf_i_series_head *head);
int algsurf_i_parse_series(parser *p, const algsurf_i_series_head *head);

/* steps.c: the operators.  Each checks its conditions and computes. */

/* Turns the outcome of arithmetic into 1 or 0. */
int algsurf_i_parse_computed(parser *p, algsurf_status status, size_t offset);

/* One value more: a monomial; v times the monomial of the key; the number at p->at, which then is behind it.
 */
int algsurf_i_parse_monomial(parser *p, monomial m, size_t offset);
int algsurf_i_parse_double(parser *p, double v, int key);
int algsurf_i_parse_number(parser *p);

/* One value for the last two: divisor: where that stands; place: where the exponent stands. */
int algsurf_i_parse_subtract(parser *p, size_t offset);
int algsurf_i_parse_multiply(parser *p, size_t offset);
int algsurf_i_parse_divide(parser *p, size_t offset, size_t divisor);
int algsurf_i_parse_power(parser *p, size_t offset, size_t place);

/* The last value becomes its n-th power, its square root, or its sine, quarters of a turn on. */
int algsurf_i_parse_raise(parser *p, size_t offset, size_t place, int n);
int algsurf_i_parse_root(parser *p, size_t offset);
int algsurf_i_parse_sine(parser *p, size_t offset, int quarters);

/* refuse.c: why an equation is refused at a place: what people try there, and what to write instead.  Each
 * function sets the parser's status and error, and returns 0. */

/* With a status and a message, which is static; or with E_SYNTAX. */
int algsurf_i_parse_fail(parser *p, algsurf_status status, size_t offset, const char *message);
int algsurf_i_parse_refuse(parser *p, size_t offset, const char *message);

/* The message for functions. */
#define ALGSURF_I_NOT_POLYNOMIAL                                                                             \
    "not a polynomial: of functions, only sqrt, sin and cos of constants are known, and T_n, U_n, P_n"

/* Refuses the name at p->at, whose letters from number `known` on, in bytes, are no factor. */
int algsurf_i_refuse_name(parser *p, size_t length, size_t known);

/* Refuses what stands here, with an explanation where it is something people try, or with the words
 * `expected`. */
int algsurf_i_parse_refuse_here(parser *p, const char *expected);

/* How many bytes of the text stand for what is wrong at its start: a name, a number, a sign; 0 at the end. */
size_t algsurf_i_wrong_length(const char *text);

#endif
