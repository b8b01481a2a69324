/* cli_guess.h - "did you mean": the nearest of the names there are to one that there is not, or the option
 * that does what the wrong one means elsewhere. */
#ifndef CLI_GUESS_H
#define CLI_GUESS_H
#include <stddef.h>

#include "cli_text.h"

typedef struct cli_guess {
    const char *wrong; /* what was given, without dashes before it, and how many of its characters count */
    size_t length;
    const char *name; /* the nearest so far; null: none is near */
    int distance;
} cli_guess;

cli_guess cli_guess_begin(const char *wrong, size_t length);
void cli_guess_try(cli_guess *guess, const char *name);

/* The k-th option, with its value, that does what the wrong word means elsewhere, from 0: "--size WxH" for
 * "width".  Null when there are no more. */
const char *cli_guess_meaning(const cli_guess *guess, int k);

/* "did you mean 'name'?" for a guess that has one. */
cli_quoted cli_guess_text(const cli_guess *guess);

#endif
