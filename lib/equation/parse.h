/* parse.h - from an equation as text to a polynomial: the reader's state, its operators, its refusals. */
#ifndef ALGSURF_EQUATION_PARSE_H
#define ALGSURF_EQUATION_PARSE_H
#include "read.h"
#include "poly.h"

enum { ALGSURF_I_DEPTH_LIMIT = 100, ALGSURF_I_PUT_IN_LIMIT = 20000 };

/* What a name stands for in the text: a sum, from one place to another. */
typedef struct algsurf_i_definition {
    size_t begin, end;
} algsurf_i_definition;

/* Set text and names, the rest to 0. */
typedef struct algsurf_i_parser {
    const char *text;
    algsurf_i_names names;
    size_t at;             /* how far the text is read */
    size_t letter;         /* of the name that was read last, the one that comes next */
    size_t letters_end;    /* up to here, it is a product of variables, constants and pi */
    algsurf_i_token token; /* at that place */
    const char *closing;   /* what is to close the signs about the whole, $ for one; null: there are none */
    algsurf_constant *defined;        /* names that the text defines */
    algsurf_i_definition *definition; /* what they stand for */
    size_t definitions, known;        /* how many; of how many the text is read */
    size_t put_in;                    /* bytes of definitions that were read where their names stand */
    int depth;
    algsurf_status status; /* the failure, if any */
    algsurf_parse_error error;
    int values; /* on the stack: at each depth a product and a base, or a numerator; and the left side */
    algsurf_i_value value[2 * (ALGSURF_I_DEPTH_LIMIT + 1) + 2];
} algsurf_i_parser;

static inline algsurf_i_value *algsurf_i_parse_top(algsurf_i_parser *p) { return p->value + p->values - 1; }

/* Functions return 1, or 0 after a failure: then status is set, and error for the statuses that have one.
 * What stands on the stack is to be freed in any case.  Offsets are places in the text, for the error. */

/* text.c.  Leaves left minus right on the stack. */
int algsurf_i_parse_equation(algsurf_i_parser *p);

/* parse.c.  The next token that is not blank; p->at is its place, p->token itself.  Moves behind the token
 * seen. */
int algsurf_i_parse_peek(algsurf_i_parser *p);
static inline void algsurf_i_parse_take(algsurf_i_parser *p) { p->at += p->token.width; }

/* One value more: a sum; a sum up to the bracket that closes the one of p->token; a part of the text, one
 * level deeper. */
int algsurf_i_parse_sum(algsurf_i_parser *p);
int algsurf_i_parse_inside(algsurf_i_parser *p);
int algsurf_i_parse_nested(algsurf_i_parser *p, size_t offset, int (*part)(algsurf_i_parser *));

/* Refuses what stands here. */
int algsurf_i_parse_refuse_here(algsurf_i_parser *p, const char *expected);

/* define.c: names that a text gives to sums, w = y^2 + z^2; before its equation.  The first function finds
 * them and moves to where the equation begins.  The second one reads them.  The third is for a name in the
 * text: one value more, that of its sum, which is read once more there. */
algsurf_status algsurf_i_definitions_find(algsurf_i_parser *p);
int algsurf_i_parse_definitions(algsurf_i_parser *p);
int algsurf_i_parse_defined(algsurf_i_parser *p, const algsurf_constant *name, size_t place);
static inline int algsurf_i_is_defined(const algsurf_i_parser *p, const algsurf_constant *name) {
    return p->definitions > 0 && name >= p->defined && name < p->defined + p->definitions;
}

/* povray.c: poly, quadric, cubic and quartic of POV-Ray.  Is p->at the beginning of one?  Then one value
 * more.
 */
int algsurf_i_povray_follows(algsurf_i_parser *p);
int algsurf_i_parse_povray(algsurf_i_parser *p);

/* series.c: T_n(a), U_n(a) and P_n(a).  Is that at the start of text?  *head becomes what it is, with all up
 * to its a.  The last value becomes that of the polynomial there. */
typedef struct algsurf_i_series_head {
    size_t width;
    int kind, index; /* the place of its letter in T U P; n, at most 1000 */
    char bracket;    /* in which a stands */
} algsurf_i_series_head;
int algsurf_i_series_follows(const char *text, algsurf_i_series_head *head);
int algsurf_i_parse_series(algsurf_i_parser *p, const algsurf_i_series_head *head, size_t offset);

/* steps.c: the operators.  Each checks its conditions and computes. */

/* Turns the outcome of arithmetic into 1 or 0. */
int algsurf_i_parse_computed(algsurf_i_parser *p, algsurf_status status, size_t offset);

/* One value more: a monomial; v times the monomial of the key; the number at p->at, which then is behind it.
 */
int algsurf_i_parse_monomial(algsurf_i_parser *p, algsurf_i_monomial m, size_t offset);
int algsurf_i_parse_double(algsurf_i_parser *p, double v, int key);
int algsurf_i_parse_number(algsurf_i_parser *p);

/* One value for the last two: divisor: where that stands; place: where the exponent stands. */
int algsurf_i_parse_subtract(algsurf_i_parser *p, size_t offset);
int algsurf_i_parse_multiply(algsurf_i_parser *p, size_t offset);
int algsurf_i_parse_divide(algsurf_i_parser *p, size_t offset, size_t divisor);
int algsurf_i_parse_power(algsurf_i_parser *p, size_t offset, size_t place);

/* The last value becomes its n-th power, its square root, or its sine, quarters of a turn on. */
int algsurf_i_parse_raise(algsurf_i_parser *p, size_t offset, size_t place, int n);
int algsurf_i_parse_root(algsurf_i_parser *p, size_t offset);
int algsurf_i_parse_sine(algsurf_i_parser *p, size_t offset, int quarters);

/* refuse.c: why an equation is refused at a place: what people try there, and what to write instead.  Each
 * function sets the parser's status and error, and returns 0. */

/* Fails with a status and a message, which is static; refusing is to fail with E_SYNTAX. */
int algsurf_i_parse_fail(algsurf_i_parser *p, algsurf_status status, size_t offset, const char *message);
int algsurf_i_parse_refuse(algsurf_i_parser *p, size_t offset, const char *message);

/* The message for functions. */
#define ALGSURF_I_NOT_POLYNOMIAL                                                                             \
    "not a polynomial: of functions, only sqrt, sin and cos of constants are known, and T_n, U_n, P_n"

/* Refuses the name at p->at, whose letters from number `known` on, in bytes, are no factor. */
int algsurf_i_refuse_name(algsurf_i_parser *p, size_t length, size_t known);

/* Refuses p->token, with an explanation where it is something people try, or with the words `expected`. */
int algsurf_i_refuse_token(algsurf_i_parser *p, const char *expected);

/* How many bytes of the text stand for what is wrong at its start: a name, a number, a sign; 0 at the end. */
size_t algsurf_i_wrong_length(const char *text);

#endif
