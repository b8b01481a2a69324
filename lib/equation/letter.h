/* letter.h - the letters of names in an equation: Latin ones, and Greek ones but for pi. */
#ifndef ALGSURF_EQUATION_LETTER_H
#define ALGSURF_EQUATION_LETTER_H
#include <stddef.h>

/* A letter as it stands in the text: its code point, however it is spelled, and its bytes; 0 and 0 for none.
 */
typedef struct algsurf_i_letter {
    int code;
    size_t width;
} algsurf_i_letter;

/* The letter the text starts with.  A Greek one is itself in UTF-8, or its command of LaTeX. */
algsurf_i_letter algsurf_i_letter_at(const char *text);

/* The same, or a digit or an underscore: what a name consists of behind its first letter. */
algsurf_i_letter algsurf_i_name_part_at(const char *text);

/* The length in bytes of the name at the start of text: a letter, then letters, digits, underscores. */
size_t algsurf_i_name_length(const char *text);

/* How many letters, digits and underscores a name of that length has. */
size_t algsurf_i_name_parts(const char *name, size_t length);

/* The length of the command of LaTeX at the start of text, with its backslash: letters, or one character. */
size_t algsurf_i_command_length(const char *text);

/* 'x', 'y' or 'z' for these letters and their capitals, 0 for all other characters. */
char algsurf_i_variable(int code);

#endif
