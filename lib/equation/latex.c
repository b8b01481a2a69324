/* latex.c - see latex.h.
 *
 * Source: Knuth, The TeXbook, 1984, chapters 16 to 18; the commands that LaTeX adds are from Lamport, LaTeX,
 * 1994.
 */
#include "../base/arithmetic.h"
#include "latex.h"

#include <string.h>

#include "letter.h"

enum { BLANK = ' ', FENCE = 1 }; /* FENCE: stands before a bracket, and then is nothing but a blank */

static const struct {
    const char *command; /* without its backslash */
    int kind;
} commands[] = {
    {"left", FENCE},
    {"right", FENCE},
    {"big", FENCE},
    {"Big", FENCE},
    {"bigl", FENCE},
    {"bigr", FENCE},
    {"Bigl", FENCE},
    {"Bigr", FENCE},
    {",", BLANK},
    {";", BLANK},
    {":", BLANK},
    {"!", BLANK},
    {" ", BLANK},
    {"quad", BLANK},
    {"qquad", BLANK},
    {"cdot", '*'},
    {"times", '*'},
    {"ast", '*'},
    {"div", '/'},
    {"{", '{'},
    {"}", '}'},
    {"|", '|'},
    {"vert", '|'},
    {"lvert", '|'},
    {"rvert", '|'},
    {"frac", ALGSURF_I_TOKEN_FRACTION},
    {"dfrac", ALGSURF_I_TOKEN_FRACTION},
    {"tfrac", ALGSURF_I_TOKEN_FRACTION},
    {"sqrt", ALGSURF_I_TOKEN_SQRT},
    {"sin", ALGSURF_I_TOKEN_SINE},
    {"cos", ALGSURF_I_TOKEN_COSINE},
    {"pi", ALGSURF_I_TOKEN_PI},
    {"lt", ALGSURF_I_TOKEN_INEQUALITY},
    {"gt", ALGSURF_I_TOKEN_INEQUALITY},
    {"le", ALGSURF_I_TOKEN_INEQUALITY},
    {"ge", ALGSURF_I_TOKEN_INEQUALITY},
    {"leq", ALGSURF_I_TOKEN_INEQUALITY},
    {"geq", ALGSURF_I_TOKEN_INEQUALITY},
};

static int begins(const char *text, const char *with) { return strncmp(text, with, strlen(with)) == 0; }

static int bracket_follows(const char *text) {
    while (*text == ' ') text++;
    if (*text == '\\') text++;
    return (*text && strchr("()[]{}|", *text)) || begins(text, "vert") || begins(text, "lvert") ||
           begins(text, "rvert");
}

algsurf_i_token algsurf_i_latex_token(const char *text) {
    size_t width = algsurf_i_command_length(text);
    algsurf_i_token token = {ALGSURF_I_TOKEN_COMMAND, 0, width};
    for (size_t c = 0; c < sizeof commands / sizeof *commands; c++) {
        if (strlen(commands[c].command) != width - 1 || !begins(text + 1, commands[c].command)) continue;
        token.kind = commands[c].kind;
    }
    if (token.kind == FENCE) token.kind = bracket_follows(text + width) ? BLANK : ALGSURF_I_TOKEN_COMMAND;
    return token;
}

const algsurf_i_quotes *algsurf_i_latex_quotes(const char *text) {
    static const algsurf_i_quotes quotes[] = {{"$$", "$$"}, {"$", "$"}, {"\\(", "\\)"}, {"\\[", "\\]"}};
    for (size_t q = 0; q < sizeof quotes / sizeof *quotes; q++)
        if (begins(text, quotes[q].open)) return &quotes[q];
    return NULL;
}
