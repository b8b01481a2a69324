/* cli_guess.c - see cli_guess.h.
 *
 * The distance is the number of letters left out, added, replaced, or swapped with their neighbour (Damerau
 * 1964), capitals being as small letters.  A third of the letters may be wrong, but not more than three.
 */
#include "cli_guess.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST = 32, MOST_WRONG = 3 };

static int least(int a, int b) { return a < b ? a : b; }

static int same(char a, char b) { return tolower((unsigned char)a) == tolower((unsigned char)b); }

static int distance(const char *a, size_t m, const char *b, size_t n) {
    int d[LONGEST + 1][LONGEST + 1]; /* [i][j]: of the first i characters of a and the first j of b */
    for (size_t i = 0; i <= m; i++) {
        for (size_t j = 0; j <= n; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = (int)(i + j);
                continue;
            }
            d[i][j] = least(d[i - 1][j - 1] + !same(a[i - 1], b[j - 1]), least(d[i - 1][j], d[i][j - 1]) + 1);
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[m][n];
}

cli_guess cli_guess_begin(const char *wrong, size_t length) {
    return (cli_guess){wrong, length, NULL, least((int)(length + 2) / 3, MOST_WRONG) + 1};
}

void cli_guess_try(cli_guess *guess, const char *name) {
    size_t length = strlen(name);
    if (length > LONGEST || guess->length > LONGEST) return;
    int d = distance(guess->wrong, guess->length, name, length);
    if (d >= guess->distance) return;
    guess->distance = d;
    guess->name = name;
}

cli_quoted cli_guess_text(const cli_guess *guess) {
    cli_quoted words;
    snprintf(words.text, sizeof words.text, "did you mean '%s'?", guess->name);
    return words;
}
