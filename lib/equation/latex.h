/* latex.h - what LaTeX has in an equation besides letters: commands, and signs about the whole. */
#ifndef ALGSURF_EQUATION_LATEX_H
#define ALGSURF_EQUATION_LATEX_H
#include "token.h"

/* The token of the command at the start of text, which begins with a backslash. */
algsurf_i_token algsurf_i_latex_token(const char *text);

/* The signs about an equation, such as $ and $. */
typedef struct algsurf_i_quotes {
    const char *open, *close;
} algsurf_i_quotes;

/* Those that text starts with; null when it starts with none. */
const algsurf_i_quotes *algsurf_i_latex_quotes(const char *text);

#endif
