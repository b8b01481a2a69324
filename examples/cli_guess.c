/* cli_guess.c - see cli_guess.h.
 *
 * The distance is the number of letters left out, added, replaced, or swapped with their neighbour (Damerau
 * 1964).  Capitals count as small letters, and the dashes before an option do not count.  A third of the
 * letters may be wrong, but not more than three.
 *
 * People also try words that other programs use for the same thing: a table has them.
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
    for (; length > 0 && *wrong == '-'; length--) wrong++;
    return (cli_guess){wrong, length, NULL, least((int)(length + 2) / 3, MOST_WRONG) + 1};
}

void cli_guess_try(cli_guess *guess, const char *name) {
    const char *letters = name + strspn(name, "-");
    size_t length = strlen(letters);
    if (length > LONGEST || guess->length > LONGEST) return;
    int d = distance(guess->wrong, guess->length, letters, length);
    if (d >= guess->distance) return;
    guess->distance = d;
    guess->name = name;
}

cli_quoted cli_guess_text(const cli_guess *guess) {
    cli_quoted words;
    snprintf(words.text, sizeof words.text, "did you mean '%s'?", guess->name);
    return words;
}

/* Such words, without dashes, and what is to be written instead.  Where a word has several rows, the first
 * one counts whose option the program has. */
static const struct {
    const char *word, *use;
} meanings[] = {
    {"cut", "--clip A,B,C,D"},
    {"cut", "--extent box:X,Y,Z"},
    {"slice", "--clip A,B,C,D"},
    {"slice", "--extent box:X,Y,Z"},
    {"plane", "--clip A,B,C,D"},
    {"box", "--extent box:X,Y,Z"},
    {"bounds", "--extent box:X,Y,Z"},
    {"bbox", "--extent box:X,Y,Z"},
    {"ball", "--extent sphere:R"},
    {"sphere", "--extent sphere:R"},
    {"radius", "--extent sphere:R"},
    {"rotate", "--turn AZ,EL"},
    {"rotation", "--turn AZ,EL"},
    {"spin", "--turn AZ,EL"},
    {"orbit", "--sweep turn:N"},
    {"camera", "--eye X,Y,Z"},
    {"from", "--eye X,Y,Z"},
    {"position", "--eye X,Y,Z"},
    {"target", "--look-at X,Y,Z"},
    {"ortho", "--orthographic HEIGHT"},
    {"parallel", "--orthographic HEIGHT"},
    {"perspective", "--fov DEGREES"},
    {"scale", "--zoom TIMES"},
    {"bg", "--background COLOUR"},
    {"transparent", "--background none"},
    {"transparency", "--background none"},
    {"alpha", "--background none"},
    {"fg", "--colour COLOUR"},
    {"back", "--inside COLOUR"},
    {"width", "--size WxH"},
    {"height", "--size WxH"},
    {"w", "--size WxH"},
    {"s", "--size WxH"},
    {"resolution", "--size WxH"},
    {"res", "--size WxH"},
    {"dimensions", "--size WxH"},
    {"gif", "--animate RATE"},
    {"apng", "--animate RATE"},
    {"fps", "--animate RATE"},
    {"movie", "--animate RATE"},
    {"video", "--animate RATE"},
    {"aa", "--antialias N"},
    {"samples", "--antialias N"},
    {"shadows", "--quality full"},
    {"shadow", "--quality full"},
    {"q", "--quality full"},
    {"fast", "--quality preview"},
    {"out", "--output FILE"},
    {"file", "--output FILE"},
    {"f", "--equation TEXT"},
    {"formula", "--equation TEXT"},
    {"param", "--let A=VALUE"},
    {"parameter", "--let A=VALUE"},
    {"set", "--let A=VALUE"},
    {"const", "--let A=VALUE"},
    {"D", "--let A=VALUE"},
    {"j", "--threads N"},
    {"jobs", "--threads N"},
    {"cores", "--threads N"},
    {"interval", "--real LO:HI"},
    {"range", "--real LO:HI"},
    {"eps", "--tolerance EPS"},
    {"precision", "--tolerance EPS"},
    {"accuracy", "--tolerance EPS"},
    {"json", "--format json"},
    {"tsv", "--format tsv"},
    {"csv", "--format tsv"},
    {"names", "--list"},
    {"surfaces", "--list"},
    {"v", "--version"},
    {"?", "--help"},
};

const char *cli_guess_meaning(const cli_guess *guess, int k) {
    for (size_t i = 0; i < sizeof meanings / sizeof *meanings; i++) {
        const char *word = meanings[i].word;
        if (strlen(word) != guess->length || strncmp(word, guess->wrong, guess->length) != 0) continue;
        if (k-- == 0) return meanings[i].use;
    }
    return NULL;
}
