/* refuse.c - see refuse.h. */
#include "../base/arithmetic.h"
#include "refuse.h"

#include <string.h>

#include "letter.h"
#include "name.h"
#include "steps.h"

typedef algsurf_i_parser parser;

/* ---- names ---- */

static int is_digit(char c) { return c >= '0' && c <= '9'; }

static int is_word(const char *name, size_t length, const char *word) {
    return strlen(word) == length && strncmp(word, name, length) == 0;
}

static const char NO_FUNCTION[] = "no function of this name is known";

/* Words that people join equations with, or say more about one with. */
static int is_joining(const char *name, size_t length) {
    static const char *const words[] = {"and", "or", "where", "with", "for", "if", "AND", "OR"};
    for (size_t w = 0; w < sizeof words / sizeof *words; w++)
        if (is_word(name, length, words[w])) return 1;
    return 0;
}

static const char INDEX[] = "the coordinates are x, y and z, no index; constants may be named a or a_1";

/* The part of a name that has no value, and what stands around it. */
typedef struct part {
    size_t begin, end; /* between variables; of the name */
    size_t before;     /* where the letter before what is not known begins */
    int letters;       /* does the name consist of letters only? */
} part;

static part part_without_value(const char *name, size_t length, size_t known) {
    part without = {0, length, 0, 1};
    for (size_t at = 0, width; at < length; at += width) {
        algsurf_i_letter letter = algsurf_i_name_part_at(name + at);
        width = letter.width;
        if (is_digit(name[at]) || name[at] == '_') without.letters = 0;
        if (at < known) without.before = at;
        if (!algsurf_i_variable(letter.code)) continue;
        if (at < known) without.begin = at + width;
        if (at >= known && without.end == length) without.end = at;
    }
    return without;
}

/* Is the bracket at the start of text one around arguments?  Behind a single letter, that takes a comma. */
static int is_call(const char *text, size_t letters) {
    if (*text != '(') return 0;
    if (letters > 1) return 1;
    for (text++; *text == ' ';) text++;
    if (!algsurf_i_variable(*text)) return 0;
    for (text++; *text == ' ';) text++;
    return *text == ',';
}

/* What people mean by a name that is no product of names known; null when it is a name without value.  *from
 * becomes where that begins in the name. */
static const char *meaning(const char *name, size_t length, size_t known, const part *without, size_t *from) {
    const char *end = name + length;
    *from = 0;
    if (is_joining(name, length)) return "one equation at a time";
    if (algsurf_i_is_function(name, length) ||
        algsurf_i_is_function(name + without->begin, without->end - without->begin))
        return ALGSURF_I_NOT_POLYNOMIAL;
    if (strncmp(name, "sqrt", strlen("sqrt")) == 0) return "expected '(' behind sqrt";
    *from = without->before;
    if (known > 0 && name[known] == '_' && algsurf_i_variable(name[without->before])) return INDEX;
    *from = 0;
    if (algsurf_i_token_at(end).kind == ALGSURF_I_TOKEN_SUBSCRIPT) return INDEX;
    if (end[-1] == '_' && *end == '{') return "an index takes no brackets: write a_1 for a_{1}";
    if (known > 0 && is_digit(name[known]))
        return "a number behind a letter: write x^2 for a power, 2x or x*2 for a product";
    if (!without->letters) return is_call(end, 1) ? NO_FUNCTION : NULL;
    *from = without->begin;
    if (without->end != length) return NULL;
    if (is_word(name + without->begin, length - without->begin, "pow") && *end == '(')
        return "no function here: write x^2 for a power";
    if (is_call(end, algsurf_i_name_parts(name + without->begin, length - without->begin)))
        return NO_FUNCTION;
    return NULL;
}

int algsurf_i_refuse_name(parser *p, const char *name, size_t length, size_t known) {
    part without = part_without_value(name, length, known);
    size_t from;
    const char *why = meaning(name, length, known, &without, &from);
    if (why) return algsurf_i_parse_refuse(p, p->at + from, why);
    if (!without.letters) without.begin = 0, without.end = length; /* no product of letters */
    p->unknown = without.end - without.begin;
    return algsurf_i_parse_fail(p, ALGSURF_E_NAME, p->at + without.begin, "not x, y or z: it needs a value");
}

/* ---- signs ---- */

static int number_follows(const char *text) {
    return is_digit(text[0]) || (text[0] == '.' && is_digit(text[1]));
}

/* What is said about a command of LaTeX that stands where it has no meaning. */
static const char *about_command(const char *text) {
    if (algsurf_i_is_function(text + 1, algsurf_i_command_length(text) - 1)) return ALGSURF_I_NOT_POLYNOMIAL;
    return "this command of LaTeX is not understood";
}

static const char *about_token(const parser *p, const char *expected) {
    const char *text = p->text + p->at;
    switch (p->token.kind) {
    case '|':
        return "not a polynomial: an absolute value; an equation with |a| squared may do";
    case ALGSURF_I_TOKEN_INEQUALITY:
        return "expected '=': a surface is where both sides are equal";
    case ALGSURF_I_TOKEN_SUPERSCRIPT:
        return "an exponent with nothing before it to raise";
    case ALGSURF_I_TOKEN_COMMAND:
        return about_command(text);
    case ',':
        return p->depth > 0 || is_digit(text[1]) ? "a decimal point is written '.'"
                                                 : "one equation at a time";
    case ALGSURF_I_TOKEN_SUBSCRIPT:
        return INDEX;
    case '!':
        return "not a polynomial: a factorial";
    case ')':
    case ']':
    case '}':
        return p->depth == 0 ? "a closing bracket without an opening one" : expected;
    default:
        return number_follows(text) || p->token.kind == ALGSURF_I_TOKEN_QUARTERS
                   ? "a number behind a factor: write x^2 for a power, 2x or x*2 for a product"
                   : expected;
    }
}

int algsurf_i_refuse_token(parser *p, const char *expected) {
    return algsurf_i_parse_refuse(p, p->at, about_token(p, expected));
}
