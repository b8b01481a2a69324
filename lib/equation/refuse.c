/* refuse.c - why an equation is refused; see parse.h. */
#include "../base/arithmetic.h"
#include <string.h>

#include "parse.h"

int algsurf_i_parse_fail(parser *p, algsurf_status status, size_t offset, const char *message) {
    p->status = status;
    p->error = (algsurf_parse_error){offset, 0, message};
    return 0;
}

int algsurf_i_parse_refuse(parser *p, size_t offset, const char *message) {
    return algsurf_i_parse_fail(p, ALGSURF_E_SYNTAX, offset, message);
}

/* Functions that people know and that are no polynomials, and those of Mathematica; words
 * that join equations, or say more about one.
 */
static const char FUNCTIONS[] =
    "sin cos tan cot sec csc asin acos atan sinh cosh tanh exp log ln abs sgn sign min max "
    "mod floor ceil cbrt";
static const char OTHERS[] = "arcsin arccos arctan Tan Cot Sec Csc ArcSin ArcCos ArcTan Sinh Cosh Tanh Exp "
                             "Log Abs Sign Min Max Mod Floor Ceiling";
static const char POVRAY[] =
    "isosurface object union merge difference intersection polynomial texture pigment";
static const char JOINING[] = "and or where with for if AND OR";

/* ---- names ---- */

static int is_digit(char c) { return c >= '0' && c <= '9'; }

static const char NO_FUNCTION[] = "no function of this name is known";

#define INDEX "the coordinates are x, y and z, no index; constants may be named a or a_1"
#define A_NUMBER "a number behind a factor: write x^2 for a power, 2x or x*2 for a product"

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
    if (*text != '(' && *text != '[') return 0;
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
    if (algsurf_i_listed(JOINING, name, length)) return "one equation at a time";
    if (algsurf_i_listed(POVRAY, name, length))
        return "of POV-Ray, function { }, poly, quadric, cubic or quartic alone: nothing about it";
    if (algsurf_i_listed(FUNCTIONS, name, length) || algsurf_i_listed(OTHERS, name, length) ||
        algsurf_i_listed(FUNCTIONS, name + without->begin, without->end - without->begin))
        return ALGSURF_I_NOT_POLYNOMIAL;
    if (strncmp(name, "sqrt", strlen("sqrt")) == 0) return "expected '(' behind sqrt";
    *from = without->before;
    if (known > 0 && name[known] == '_' && algsurf_i_variable(name[without->before])) return INDEX;
    *from = 0;
    if (algsurf_i_token_at(end).kind == ALGSURF_I_TOKEN_SUBSCRIPT) return INDEX;
    if (end[-1] == '_' && *end == '{') return "an index takes no brackets: write a_1 for a_{1}";
    if (known > 0 && is_digit(name[known]))
        return "a number behind a letter: write x^2 for a power, 2x or x*2 for a product";
    if (!without->letters) return is_call(end, *end == '[' ? 2 : 1) ? NO_FUNCTION : NULL;
    *from = without->begin;
    if (without->end != length) return NULL;
    if (algsurf_i_listed("pow Power", name + without->begin, length - without->begin) &&
        (*end == '(' || *end == '['))
        return "no function here: write x^2 for a power";
    if (is_call(end, algsurf_i_name_parts(name + without->begin, length - without->begin)))
        return NO_FUNCTION;
    return NULL;
}

int algsurf_i_refuse_name(parser *p, size_t length, size_t known) {
    const char *name = p->text + p->at;
    part without = part_without_value(name, length, known);
    size_t from;
    const char *why = meaning(name, length, known, &without, &from);
    if (why) return algsurf_i_parse_refuse(p, p->at + from, why);
    if (!without.letters) without.begin = 0, without.end = length; /* no product of letters */
    (void)algsurf_i_parse_fail(p, ALGSURF_E_NAME, p->at + without.begin, "not x, y or z: it needs a value");
    p->error.length = without.end - without.begin;
    return 0;
}

/* ---- signs ---- */

/* What is said about signs wherever they have no meaning. */
static const struct {
    int kind;
    const char *message;
} meaningless[] = {
    {'|', "not a polynomial: an absolute value; an equation with |a| squared may do"},
    {'!', "not a polynomial: a factorial"},
    {ALGSURF_I_TOKEN_INEQUALITY, "expected '=': a surface is where both sides are equal"},
    {ALGSURF_I_TOKEN_SUPERSCRIPT, "an exponent with nothing before it to raise"},
    {ALGSURF_I_TOKEN_RAISED, "an exponent with nothing before it to raise"},
    {ALGSURF_I_TOKEN_SUBSCRIPT, INDEX},
    {ALGSURF_I_TOKEN_QUARTERS, A_NUMBER},
    {'&', "one equation at a time, without '&'"},
    {'#', "one equation at a time, without '#'"},
    {ALGSURF_I_TOKEN_COMMAND, "this command of LaTeX is not understood"},
};

/* Is the comma at that place one between digits of a number?  (1,2,3) is a point. */
static int is_decimal(const char *text, size_t at, int depth) {
    size_t digits = 0;
    while (is_digit(text[at + 1 + digits])) digits++;
    if (digits == 0 || depth == 0) return digits > 0;
    return at > 0 && is_digit(text[at - 1]) && text[at + 1 + digits] != ',';
}

static const char *about_token(const parser *p, const char *expected) {
    const char *text = p->text + p->at;
    int c = p->token.kind;
    if (c == ',' && is_decimal(p->text, p->at, p->depth)) return "a decimal point is written '.'";
    if (c == ',')
        return p->depth > 0 ? "no points or vectors: write an equation in x, y and z"
                            : "one equation at a time";
    if ((c == ')' || c == ']' || c == '}') && p->depth == 0)
        return "a closing bracket without an opening one";
    if (c == ALGSURF_I_TOKEN_COMMAND && algsurf_i_listed(FUNCTIONS, text + 1, p->token.width - 1))
        return ALGSURF_I_NOT_POLYNOMIAL;
    for (size_t m = 0; m < sizeof meaningless / sizeof *meaningless; m++)
        if (meaningless[m].kind == c) return meaningless[m].message;
    return algsurf_i_number_follows(text) ? A_NUMBER : expected;
}

int algsurf_i_parse_refuse_here(parser *p, const char *expected) {
    (void)algsurf_i_parse_peek(p);
    return algsurf_i_parse_refuse(p, p->at, about_token(p, expected));
}

size_t algsurf_i_wrong_length(const char *text) {
    monomial number;
    size_t length = algsurf_i_name_length(text);
    if (length == 0) length = algsurf_i_read_number(text, &number);
    return length > 0 ? length : algsurf_i_token_at(text).width;
}
