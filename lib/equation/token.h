/* token.h - the signs of an equation, as people type and paste them. */
#ifndef ALGSURF_EQUATION_TOKEN_H
#define ALGSURF_EQUATION_TOKEN_H
#include <stddef.h>

/* What stands at a place of the text: an ASCII character that is no letter, or one of these. */
enum {
    ALGSURF_I_TOKEN_SUPERSCRIPT = 256, /* one digit of an exponent */
    ALGSURF_I_TOKEN_SUBSCRIPT,         /* one digit of an index, or a letter */
    ALGSURF_I_TOKEN_QUARTERS,          /* 1, 2 or 3 of them as one sign */
    ALGSURF_I_TOKEN_ROOT,              /* a root sign */
    ALGSURF_I_TOKEN_PI,                /* the letter */
    ALGSURF_I_TOKEN_LETTER,            /* of a name: letter.h */
    ALGSURF_I_TOKEN_INEQUALITY,
    ALGSURF_I_TOKEN_FRACTION, /* from here on: commands of LaTeX */
    ALGSURF_I_TOKEN_SQRT,
    ALGSURF_I_TOKEN_SINE,
    ALGSURF_I_TOKEN_COSINE,
    ALGSURF_I_TOKEN_COMMAND, /* any other */
    ALGSURF_I_TOKEN_UNKNOWN
};

typedef struct algsurf_i_token {
    int kind;
    int digit;    /* of a superscript; how many quarters */
    size_t width; /* in bytes; 0 at the end of the text */
} algsurf_i_token;

/* How many bytes of blanks the text starts with, those of typesetters among them. */
size_t algsurf_i_blanks(const char *text);

/* The token the text starts with.  Signs that mean the same are the same: '^' for two asterisks, '=' for two
 * equality signs, '*' for a raised dot, a cross or \cdot, '-' for a minus sign. */
algsurf_i_token algsurf_i_token_at(const char *text);

/* The bracket that closes what the token opens: ) ] }; 0 for all other tokens. */
char algsurf_i_closing(int token);

/* Is the name that of a function people know which is no polynomial, such as sin? */
int algsurf_i_is_function(const char *name, size_t length);

/* How many bytes of the text stand for what is wrong at its start: a name, a number, a sign; 0 at the end. */
size_t algsurf_i_wrong_length(const char *text);

#endif
