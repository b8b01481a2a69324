/* token.c - see token.h.
 *
 * Text is UTF-8.  Characters beyond ASCII are few, hence looked up in a table; a byte that begins none of
 * them, and no letter, is a token by itself, up to the next byte that begins a character, so that offsets of
 * errors never point into one.
 */
#include "../base/arithmetic.h"
#include "token.h"

#include <string.h>

#include "latex.h"
#include "letter.h"
#include "number.h"

enum { BLANK = ' ' };

static const struct {
    const char *text;
    int kind, digit;
} signs[] = {
    {"\xc2\xa0", BLANK, 0},                          /* no-break space */
    {"\xe2\x80\x82", BLANK, 0},                      /* spaces of the width of n, of m, */
    {"\xe2\x80\x83", BLANK, 0},                      /* of a third of that, ... */
    {"\xe2\x80\x84", BLANK, 0},                      /* */
    {"\xe2\x80\x85", BLANK, 0},                      /* */
    {"\xe2\x80\x86", BLANK, 0},                      /* */
    {"\xe2\x80\x87", BLANK, 0},                      /* of a digit */
    {"\xe2\x80\x88", BLANK, 0},                      /* of a point */
    {"\xe2\x80\x89", BLANK, 0},                      /* thin */
    {"\xe2\x80\x8a", BLANK, 0},                      /* hair */
    {"\xe2\x80\x8b", BLANK, 0},                      /* of no width */
    {"\xe2\x80\xaf", BLANK, 0},                      /* narrow no-break space */
    {"\xe2\x81\x9f", BLANK, 0},                      /* of mathematics */
    {"\xef\xbb\xbf", BLANK, 0},                      /* byte order mark */
    {"\xc2\xb7", '*', 0},                            /* middle dot */
    {"\xc3\x97", '*', 0},                            /* multiplication cross */
    {"\xe2\x8b\x85", '*', 0},                        /* dot operator */
    {"\xe2\x88\x97", '*', 0},                        /* asterisk operator */
    {"\xe2\x81\xa2", '*', 0},                        /* invisible times */
    {"\xe2\x88\x92", '-', 0},                        /* minus */
    {"\xe2\x80\x93", '-', 0},                        /* en dash */
    {"\xc3\xb7", '/', 0},                            /* division sign */
    {"\xe2\x88\x95", '/', 0},                        /* division slash */
    {"\xe2\x81\x84", '/', 0},                        /* fraction slash */
    {"\xe2\x88\x9a", ALGSURF_I_TOKEN_ROOT, 0},       /* */
    {"\xcf\x80", ALGSURF_I_TOKEN_PI, 0},             /* */
    {"\xe2\x89\xa4", ALGSURF_I_TOKEN_INEQUALITY, 0}, /* less or equal */
    {"\xe2\x89\xa5", ALGSURF_I_TOKEN_INEQUALITY, 0}, /* greater or equal */
    {"\xe2\x81\xb0", ALGSURF_I_TOKEN_SUPERSCRIPT, 0},
    {"\xc2\xb9", ALGSURF_I_TOKEN_SUPERSCRIPT, 1},
    {"\xc2\xb2", ALGSURF_I_TOKEN_SUPERSCRIPT, 2},
    {"\xc2\xb3", ALGSURF_I_TOKEN_SUPERSCRIPT, 3},
    {"\xe2\x81\xb4", ALGSURF_I_TOKEN_SUPERSCRIPT, 4},
    {"\xe2\x81\xb5", ALGSURF_I_TOKEN_SUPERSCRIPT, 5},
    {"\xe2\x81\xb6", ALGSURF_I_TOKEN_SUPERSCRIPT, 6},
    {"\xe2\x81\xb7", ALGSURF_I_TOKEN_SUPERSCRIPT, 7},
    {"\xe2\x81\xb8", ALGSURF_I_TOKEN_SUPERSCRIPT, 8},
    {"\xe2\x81\xb9", ALGSURF_I_TOKEN_SUPERSCRIPT, 9},
    {"\xc2\xbc", ALGSURF_I_TOKEN_QUARTERS, 1},
    {"\xc2\xbd", ALGSURF_I_TOKEN_QUARTERS, 2},
    {"\xc2\xbe", ALGSURF_I_TOKEN_QUARTERS, 3},
};

/* U+2080 to U+2089, the digits, and U+2090 to U+209C, letters. */
static int is_subscript(const char *text, size_t width) {
    unsigned char last = (unsigned char)text[width - 1];
    return width == 3 && strncmp(text, "\xe2\x82", 2) == 0 &&
           (last <= 0x89 || (last >= 0x90 && last <= 0x9c));
}

static algsurf_i_token beyond_ascii(const char *text) {
    for (size_t s = 0; s < sizeof signs / sizeof *signs; s++) {
        size_t width = strlen(signs[s].text);
        if (strncmp(text, signs[s].text, width) == 0)
            return (algsurf_i_token){signs[s].kind, signs[s].digit, width};
    }
    size_t width = 1;
    while (((unsigned char)text[width] & 0xc0) == 0x80) width++;
    return (algsurf_i_token){is_subscript(text, width) ? ALGSURF_I_TOKEN_SUBSCRIPT : ALGSURF_I_TOKEN_UNKNOWN,
                             0, width};
}

algsurf_i_token algsurf_i_token_at(const char *text) {
    char c = text[0];
    algsurf_i_letter letter = algsurf_i_letter_at(text);
    if (letter.width > 0) return (algsurf_i_token){ALGSURF_I_TOKEN_LETTER, 0, letter.width};
    if ((unsigned char)c >= 0x80) return beyond_ascii(text);
    if (c == '\\') return algsurf_i_latex_token(text);
    if (c == '\0') return (algsurf_i_token){'\0', 0, 0};
    if (c == '*' && text[1] == '*') return (algsurf_i_token){'^', 0, 2};
    if (c == '=' && text[1] == '=') return (algsurf_i_token){'=', 0, 2};
    if (c == '<' || c == '>') return (algsurf_i_token){ALGSURF_I_TOKEN_INEQUALITY, 0, 1};
    if ((c >= '\t' && c <= '\r') || c == '~') c = BLANK;
    return (algsurf_i_token){c, 0, 1};
}

size_t algsurf_i_blanks(const char *text) {
    size_t n = 0;
    for (;;) {
        algsurf_i_token token = algsurf_i_token_at(text + n);
        if (token.kind != BLANK) return n;
        n += token.width;
    }
}

char algsurf_i_closing(int token) {
    return token == '(' ? ')' : token == '[' ? ']' : token == '{' ? '}' : '\0';
}

int algsurf_i_is_function(const char *name, size_t length) {
    static const char *const functions[] = {"sin",  "cos",  "tan",  "cot",  "sec", "csc",   "asin", "acos",
                                            "atan", "sinh", "cosh", "tanh", "exp", "log",   "ln",   "abs",
                                            "sgn",  "sign", "min",  "max",  "mod", "floor", "ceil", "cbrt"};
    for (size_t f = 0; f < sizeof functions / sizeof *functions; f++) {
        if (strlen(functions[f]) == length && strncmp(functions[f], name, length) == 0) return 1;
    }
    return 0;
}

size_t algsurf_i_wrong_length(const char *text) {
    size_t length = algsurf_i_name_length(text);
    algsurf_i_number number;
    if (length > 0 || algsurf_i_read_number(text, &length, &number) != ALGSURF_I_NO_NUMBER) return length;
    return algsurf_i_token_at(text).width;
}
