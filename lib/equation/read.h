/* read.h - what stands at a place of an equation, as people type and paste it: signs, letters, names. */
#ifndef ALGSURF_EQUATION_READ_H
#define ALGSURF_EQUATION_READ_H
#include <stddef.h>

#include "algsurf/surface.h"

/* An ASCII character that is no letter, or one of these. */
enum {
    ALGSURF_I_TOKEN_SUPERSCRIPT = 256, /* one digit of an exponent */
    ALGSURF_I_TOKEN_SUBSCRIPT,         /* one digit of an index, or a letter */
    ALGSURF_I_TOKEN_QUARTERS,          /* 1, 2 or 3 of them as one sign */
    ALGSURF_I_TOKEN_INEQUALITY,
    ALGSURF_I_TOKEN_RAISED, /* <sup> and </sup>: an exponent stands between them */
    ALGSURF_I_TOKEN_LOWERED,
    ALGSURF_I_TOKEN_ROOT,     /* a root sign; from here on: what begins a factor, with brackets and numbers */
    ALGSURF_I_TOKEN_PI,       /* the letter */
    ALGSURF_I_TOKEN_LETTER,   /* of a name */
    ALGSURF_I_TOKEN_FRACTION, /* from here on: commands of LaTeX */
    ALGSURF_I_TOKEN_SQRT,
    ALGSURF_I_TOKEN_SINE,
    ALGSURF_I_TOKEN_COSINE,  /* the last one that begins a factor */
    ALGSURF_I_TOKEN_COMMAND, /* any other */
    ALGSURF_I_TOKEN_UNKNOWN
};

typedef struct algsurf_i_token {
    int kind;
    int digit;    /* of a superscript; how many quarters */
    size_t width; /* in bytes; 0 at the end of the text */
} algsurf_i_token;

/* The token the text starts with.  Signs that mean the same are the same: '^' for two asterisks, '=' for two
 * equality signs or one behind '&', '*' for a raised dot, a cross or \cdot, '-' for a minus sign; those of
 * MATLAB that apply to each element, behind a point, for those without. */
algsurf_i_token algsurf_i_token_at(const char *text);

/* How many bytes of blanks the text starts with, those of typesetters among them. */
size_t algsurf_i_blanks(const char *text);

/* A digit, or a point and a digit. */
int algsurf_i_number_follows(const char *text);

/* The bracket that closes what the token opens: ) ] }; 0 for all other tokens. */
char algsurf_i_closing(int token);

/* A letter of a name as it stands in the text, Latin, or Greek but for pi: its code point, however it is
 * spelled, and its bytes; 0 and 0 for none. */
typedef struct algsurf_i_letter {
    int code;
    size_t width;
} algsurf_i_letter;

/* The letter the text starts with; or a digit or an underscore: what a name has behind its first letter. */
algsurf_i_letter algsurf_i_letter_at(const char *text);
algsurf_i_letter algsurf_i_name_part_at(const char *text);

/* The length in bytes of the name at the start of text: a letter, then letters, digits, underscores. */
size_t algsurf_i_name_length(const char *text);

/* How many letters, digits and underscores a name of that length has. */
size_t algsurf_i_name_parts(const char *name, size_t length);

/* 'x', 'y' or 'z' for these letters and their capitals, 0 for all other characters. */
char algsurf_i_variable(int code);

/* The place of a word in a list of words with a blank between them, from 1 on; 0: it is none of them. */
int algsurf_i_listed(const char *list, const char *word, size_t length);

/* ---- names: name.c.  A name stands for a constant, or a product of constants, x, y, z and pi. ---- */

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
    size_t nodes;
} algsurf_i_names;

/* Makes room for names of so many bytes together, takes them one by one, and makes them ready for use.  Each
 * fails with E_NO_MEMORY, adding a name that is there already with E_ARGUMENT; to be freed anyway.  The names
 * are checked; one may go on in its text behind its end.  Cost: linear in the lengths of the names. */
algsurf_status algsurf_i_names_make(algsurf_i_names *names, size_t bytes);
algsurf_status algsurf_i_names_add(algsurf_i_names *names, const algsurf_constant *constant);
void algsurf_i_names_link(algsurf_i_names *names);
void algsurf_i_names_free(algsurf_i_names *names);

/* Reads the name at the start of text.  Cost: linear in its length. */
algsurf_status algsurf_i_names_read(algsurf_i_names *names, const char *text);

/* Of how many letters is the factor that begins with letter i, as part of a product: x, y, z, else the
 * longest of the constants and pi, else X, Y, Z; 0 when it is none.  *constant is null unless it is one of
 * the caller's. */
size_t algsurf_i_names_factor(const algsurf_i_names *names, size_t i, const algsurf_constant **constant);

/* The constant that is the whole name; null: it is none. */
const algsurf_constant *algsurf_i_names_whole(const algsurf_i_names *names);

#endif
