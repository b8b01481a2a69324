/* read.c - see read.h.
 *
 * Text is UTF-8.  A byte that begins nothing that is known is a token by itself, up to the next byte that
 * begins a character, so that offsets of errors never point into one.
 *
 * A letter is known by its code point, so that names compare equal whether they have the letter itself or its
 * command of LaTeX.  The Greek letters lie in a row in Unicode, U+03B1 to U+03C9, their capitals 32 before
 * them; four variants, such as that of phi, lie behind and are letters of their own.  The micro sign that
 * keyboards have is mu.
 *
 * Source of the commands: Knuth, The TeXbook, 1984, chapters 16 to 18; Lamport, LaTeX, 1994.
 */
#include "../base/arithmetic.h"
#include "read.h"

#include <string.h>

enum { BLANK = ' ', FENCE = 1 }; /* FENCE: stands before a bracket, and then is nothing but a blank */

enum {
    ALPHA = 0x3b1,
    PI = 0x3c0,
    FINAL_SIGMA = 0x3c2,
    MU = 0x3bc,
    OMEGA = 0x3c9,
    MICRO = 0xb5,
    CAPITAL = 32
};

/* Characters beyond ASCII in a row; the digit is that of the first one. */
static const struct {
    int first, last, kind, digit;
} signs[] = {
    {0xa0, 0xa0, BLANK, 0},     /* no-break space */
    {0x1680, 0x1680, BLANK, 0}, /* ogham space */
    {0x2000, 0x200b, BLANK, 0}, /* spaces of the width of n, ..., thin ones, hair, of no width */
    {0x202f, 0x202f, BLANK, 0}, /* narrow no-break space */
    {0x205f, 0x205f, BLANK, 0}, /* of mathematics */
    {0x3000, 0x3000, BLANK, 0}, /* of ideographs */
    {0xfeff, 0xfeff, BLANK, 0}, /* byte order mark */
    {0xb7, 0xb7, '*', 0},       /* middle dot */
    {0xd7, 0xd7, '*', 0},       /* multiplication cross */
    {0x22c5, 0x22c5, '*', 0},   /* dot operator */
    {0x2217, 0x2217, '*', 0},   /* asterisk operator */
    {0x2062, 0x2062, '*', 0},   /* invisible times */
    {0x2212, 0x2212, '-', 0},   /* minus */
    {0x2010, 0x2015, '-', 0},   /* hyphens, dashes, horizontal bar */
    {0xf7, 0xf7, '/', 0},       /* division sign */
    {0x2215, 0x2215, '/', 0},   /* division slash */
    {0x2044, 0x2044, '/', 0},   /* fraction slash */
    {0x221a, 0x221a, ALGSURF_I_TOKEN_ROOT, 0},
    {PI, PI, ALGSURF_I_TOKEN_PI, 0},
    {0x2264, 0x2265, ALGSURF_I_TOKEN_INEQUALITY, 0},
    {0x2070, 0x2070, ALGSURF_I_TOKEN_SUPERSCRIPT, 0},
    {0xb9, 0xb9, ALGSURF_I_TOKEN_SUPERSCRIPT, 1},
    {0xb2, 0xb3, ALGSURF_I_TOKEN_SUPERSCRIPT, 2},
    {0x2074, 0x2079, ALGSURF_I_TOKEN_SUPERSCRIPT, 4},
    {0x2080, 0x2089, ALGSURF_I_TOKEN_SUBSCRIPT, 0}, /* digits */
    {0x2090, 0x209c, ALGSURF_I_TOKEN_SUBSCRIPT, 0}, /* letters */
    {0xbc, 0xbe, ALGSURF_I_TOKEN_QUARTERS, 1},
};

/* Commands without their backslashes. */
static const struct {
    const char *words;
    int kind;
} commands[] = {
    {"left right big Big bigl bigr Bigl Bigr", FENCE},
    {", ; : ! quad qquad displaystyle", BLANK},
    {"cdot times ast", '*'},
    {"div", '/'},
    {"{", '{'},
    {"}", '}'},
    {"| vert lvert rvert", '|'},
    {"frac dfrac tfrac", ALGSURF_I_TOKEN_FRACTION},
    {"sqrt", ALGSURF_I_TOKEN_SQRT},
    {"sin", ALGSURF_I_TOKEN_SINE},
    {"cos", ALGSURF_I_TOKEN_COSINE},
    {"pi", ALGSURF_I_TOKEN_PI},
    {"lt gt le ge leq geq", ALGSURF_I_TOKEN_INEQUALITY},
};

static const char greek[] =
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi "
    "rho varsigma sigma tau upsilon phi chi psi omega";
static const char variants[] = "vartheta varphi varrho varepsilon";
static const int variant_codes[] = {0x3d1, 0x3d5, 0x3f1, 0x3f5};

int algsurf_i_listed(const char *list, const char *word, size_t length) {
    for (int place = 1; *list; place++) {
        size_t n = strcspn(list, " ");
        if (n == length && strncmp(list, word, n) == 0) return place;
        list += n + (list[n] == ' ');
    }
    return 0;
}

static int is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static int is_digit(char c) { return c >= '0' && c <= '9'; }
static int goes_on(char c) { return ((unsigned char)c & 0xc0) == 0x80; }

/* ---- letters ---- */

/* A character of two or three bytes; 0 and 0 for others. */
static algsurf_i_letter character_at(const char *text) {
    const unsigned char *c = (const unsigned char *)text;
    if (c[0] >= 0xc2 && c[0] < 0xe0 && goes_on(text[1]))
        return (algsurf_i_letter){(c[0] & 0x1f) << 6 | (c[1] & 0x3f), 2};
    if (c[0] < 0xe0 || c[0] >= 0xf0 || !goes_on(text[1]) || !goes_on(text[2]))
        return (algsurf_i_letter){0, 0};
    int code = (c[0] & 0x0f) << 12 | (c[1] & 0x3f) << 6 | (c[2] & 0x3f);
    return (algsurf_i_letter){code >= 0x800 ? code : 0, 3};
}

/* The code point of the Greek letter with this command, without its backslash; 0 for another command. */
static int greek_command(const char *name, size_t length) {
    char small[sizeof "varepsilon"];
    int capital = name[0] >= 'A' && name[0] <= 'Z', variant = algsurf_i_listed(variants, name, length);
    if (variant) return variant_codes[variant - 1];
    if (length == 0 || length >= sizeof small) return 0;
    memcpy(small, name, length);
    if (capital) small[0] = (char)(name[0] - 'A' + 'a');
    int place = algsurf_i_listed(greek, small, length);
    return place ? ALPHA + place - 1 - (capital ? CAPITAL : 0) : 0;
}

/* Is it a Greek letter that names may have?  Pi is a number; a final sigma has no capital. */
static int is_greek(int code) {
    for (size_t v = 0; v < sizeof variant_codes / sizeof *variant_codes; v++)
        if (variant_codes[v] == code) return 1;
    if (code >= ALPHA - CAPITAL && code <= OMEGA - CAPITAL) return code != FINAL_SIGMA - CAPITAL;
    return code >= ALPHA && code <= OMEGA && code != PI;
}

/* The length of the command at the start of text, with its backslash: letters, or one character. */
static size_t command_length(const char *text) {
    size_t n = 1;
    while (is_latin(text[n])) n++;
    if (n > 1 || text[1] == '\0') return n;
    for (n = 2; (unsigned char)text[1] >= 0x80 && goes_on(text[n]);) n++;
    return n;
}

algsurf_i_letter algsurf_i_letter_at(const char *text) {
    if (is_latin(text[0])) return (algsurf_i_letter){text[0], 1};
    algsurf_i_letter letter = character_at(text);
    if (text[0] == '\\') {
        letter.width = command_length(text);
        letter.code = greek_command(text + 1, letter.width - 1);
    }
    if (letter.code == MICRO) letter.code = MU;
    return is_greek(letter.code) ? letter : (algsurf_i_letter){0, 0};
}

algsurf_i_letter algsurf_i_name_part_at(const char *text) {
    if (is_digit(text[0]) || text[0] == '_') return (algsurf_i_letter){text[0], 1};
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

/* ---- signs ---- */

static algsurf_i_token beyond_ascii(const char *text) {
    algsurf_i_letter character = character_at(text);
    for (size_t s = 0; s < sizeof signs / sizeof *signs; s++) {
        int past = character.code - signs[s].first;
        if (past >= 0 && character.code <= signs[s].last)
            return (algsurf_i_token){signs[s].kind, signs[s].digit + past, character.width};
    }
    size_t width = 1;
    while (goes_on(text[width])) width++;
    return (algsurf_i_token){ALGSURF_I_TOKEN_UNKNOWN, 0, width};
}

static int bracket_follows(const char *text) {
    while (*text == ' ') text++;
    if (*text == '\\') text++;
    if (*text && strchr("()[]{}|", *text)) return 1;
    text += *text == 'l' || *text == 'r';
    return strncmp(text, "vert", strlen("vert")) == 0;
}

static algsurf_i_token command_at(const char *text) {
    size_t width = command_length(text);
    algsurf_i_token token = {text[1] == ' ' ? BLANK : ALGSURF_I_TOKEN_COMMAND, 0, width};
    for (size_t c = 0; c < sizeof commands / sizeof *commands; c++)
        if (algsurf_i_listed(commands[c].words, text + 1, width - 1)) token.kind = commands[c].kind;
    if (token.kind == FENCE) token.kind = bracket_follows(text + width) ? BLANK : ALGSURF_I_TOKEN_COMMAND;
    return token;
}

/* '<', or the beginning of a tag of HTML. */
static algsurf_i_token tag_at(const char *text) {
    static const struct {
        const char *tag;
        int kind;
    } tags[] = {{"<sup>", ALGSURF_I_TOKEN_RAISED},
                {"</sup>", ALGSURF_I_TOKEN_LOWERED},
                {"<sub>", ALGSURF_I_TOKEN_SUBSCRIPT}};
    for (size_t t = 0; t < sizeof tags / sizeof *tags; t++)
        if (strncmp(text, tags[t].tag, strlen(tags[t].tag)) == 0)
            return (algsurf_i_token){tags[t].kind, 0, strlen(tags[t].tag)};
    return (algsurf_i_token){ALGSURF_I_TOKEN_INEQUALITY, 0, 1};
}

algsurf_i_token algsurf_i_token_at(const char *text) {
    char c = text[0];
    algsurf_i_letter letter = algsurf_i_letter_at(text);
    if (letter.width > 0) return (algsurf_i_token){ALGSURF_I_TOKEN_LETTER, 0, letter.width};
    if ((unsigned char)c >= 0x80) return beyond_ascii(text);
    if (c == '\\') return command_at(text);
    if (c == '\0') return (algsurf_i_token){'\0', 0, 0};
    if (c == '*' && text[1] == '*') return (algsurf_i_token){'^', 0, 2};
    if (c == '=' && text[1] == '=') return (algsurf_i_token){'=', 0, 2};
    if (c == '&' && text[1] == '=') return (algsurf_i_token){'=', 0, 2}; /* as columns of LaTeX have it */
    if (c == '.' && text[1] && strchr("*/^", text[1])) return (algsurf_i_token){text[1], 0, 2};
    if (c == '<') return tag_at(text);
    if (c == '>') return (algsurf_i_token){ALGSURF_I_TOKEN_INEQUALITY, 0, 1};
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

int algsurf_i_number_follows(const char *text) {
    return is_digit(text[0]) || (text[0] == '.' && is_digit(text[1]));
}

char algsurf_i_closing(int token) {
    return token == '(' ? ')' : token == '[' ? ']' : token == '{' ? '}' : '\0';
}
