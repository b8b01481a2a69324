/* cli_guess.h - "did you mean": the nearest of the names there are to one that there is not. */
#ifndef CLI_GUESS_H
#define CLI_GUESS_H
#include <stddef.h>

#include "cli_text.h"

typedef struct cli_guess {
    const char *wrong; /* what was given, and how many of its characters count */
    size_t length;
    const char *name; /* the nearest so far; null: none is near */
    int distance;
} cli_guess;

cli_guess cli_guess_begin(const char *wrong, size_t length);
void cli_guess_try(cli_guess *guess, const char *name);

/* "did you mean 'name'?" for a guess that has one. */
cli_quoted cli_guess_text(const cli_guess *guess);

#endif
