/* letter.c - see letter.h.
 *
 * A letter is known by its code point, so that names compare equal whether they have the letter itself or its
 * command of LaTeX.  The Greek letters lie in a row in Unicode, U+03B1 to U+03C9, their capitals 32 before
 * them; four variants, such as that of phi, lie behind and are letters of their own.  The micro sign that
 * keyboards have is mu.
 */
#include "../base/arithmetic.h"
#include "letter.h"

#include <string.h>

enum {
    ALPHA = 0x3b1,
    PI = 0x3c0,
    FINAL_SIGMA = 0x3c2,
    MU = 0x3bc,
    OMEGA = 0x3c9,
    MICRO = 0xb5,
    CAPITAL = 32
};

static const char *const greek[] = {"alpha",   "beta", "gamma", "delta",    "epsilon", "zeta", "eta",
                                    "theta",   "iota", "kappa", "lambda",   "mu",      "nu",   "xi",
                                    "omicron", "pi",   "rho",   "varsigma", "sigma",   "tau",  "upsilon",
                                    "phi",     "chi",  "psi",   "omega"};

static const struct {
    const char *command;
    int code;
} variants[] = {{"vartheta", 0x3d1}, {"varphi", 0x3d5}, {"varrho", 0x3f1}, {"varepsilon", 0x3f5}};

static int is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/* The code point of the Greek letter with this command, without its backslash; 0 for another command. */
static int greek_command(const char *name, size_t length) {
    for (size_t v = 0; v < sizeof variants / sizeof *variants; v++)
        if (strlen(variants[v].command) == length && strncmp(variants[v].command, name, length) == 0)
            return variants[v].code;
    int capital = name[0] >= 'A' && name[0] <= 'Z';
    char first = capital ? (char)(name[0] - 'A' + 'a') : name[0];
    for (int g = 0; g < (int)(sizeof greek / sizeof *greek); g++) {
        if (strlen(greek[g]) != length || greek[g][0] != first) continue;
        if (strncmp(greek[g] + 1, name + 1, length - 1) != 0) continue;
        return capital ? ALPHA + g - CAPITAL : ALPHA + g;
    }
    return 0;
}

/* Is it a Greek letter that names may have?  Pi is a number; a final sigma has no capital. */
static int is_greek(int code) {
    for (size_t v = 0; v < sizeof variants / sizeof *variants; v++)
        if (variants[v].code == code) return 1;
    if (code >= ALPHA - CAPITAL && code <= OMEGA - CAPITAL) return code != FINAL_SIGMA - CAPITAL;
    return code >= ALPHA && code <= OMEGA && code != PI;
}

size_t algsurf_i_command_length(const char *text) {
    size_t n = 1;
    while (is_latin(text[n])) n++;
    if (n > 1 || text[1] == '\0') return n;
    for (n = 2; ((unsigned char)text[n] & 0xc0) == 0x80;) n++;
    return n;
}

algsurf_i_letter algsurf_i_letter_at(const char *text) {
    const unsigned char *c = (const unsigned char *)text;
    algsurf_i_letter letter = {0, 0};
    if (is_latin(text[0])) return (algsurf_i_letter){text[0], 1};
    if (text[0] == '\\') {
        letter.width = algsurf_i_command_length(text);
        letter.code = greek_command(text + 1, letter.width - 1);
    } else if (c[0] >= 0xc2 && c[0] <= 0xdf && (c[1] & 0xc0) == 0x80) {
        letter = (algsurf_i_letter){(c[0] & 0x1f) << 6 | (c[1] & 0x3f), 2};
        if (letter.code == MICRO) letter.code = MU;
    }
    return is_greek(letter.code) ? letter : (algsurf_i_letter){0, 0};
}

algsurf_i_letter algsurf_i_name_part_at(const char *text) {
    if ((text[0] >= '0' && text[0] <= '9') || text[0] == '_') return (algsurf_i_letter){text[0], 1};
    return algsurf_i_letter_at(text);
}

size_t algsurf_i_name_length(const char *text) {
    size_t length = algsurf_i_letter_at(text).width, width = length;
    for (; width > 0; length += width) width = algsurf_i_name_part_at(text + length).width;
    return length;
}

size_t algsurf_i_name_parts(const char *name, size_t length) {
    size_t parts = 0;
    for (size_t at = 0; at < length; parts++) at += algsurf_i_name_part_at(name + at).width;
    return parts;
}

char algsurf_i_variable(int code) {
    if (code >= 'X' && code <= 'Z') code += 'x' - 'X';
    return (char)(code >= 'x' && code <= 'z' ? code : '\0');
}
