/* text.c - from an equation as text to a polynomial: what stands about the expressions of parse.c.
 *
 *     text     = { definition } [ open ] { definition } body [ stop ] [ close ] [ stop ] [ ";" ]
 *     definition = name "=" sum ";"
 *     body     = solid | [ head ] equation
 *     open, close                                                  $ and $, or another pair of define.c
 *     stop     = "." | ","
 *     solid    = ("poly" | "quadric" | "cubic" | "quartic") "{" sums with "," "<" ">" between "}"
 *     head     = name "(" "x" "," "y" "," "z" ")" "="
 *     equation = sum [ "=" sum ]  |  "=" sum                       without head, that one
 */
#include "../base/arithmetic.h"
#include "parse.h"

#include <string.h>

/* Takes the signs that close the equation, where some opened it. */
static void take_closing(parser *p) {
    (void)algsurf_i_parse_peek(p);
    if (!p->closing || strncmp(p->text + p->at, p->closing, strlen(p->closing)) != 0) return;
    p->at += strlen(p->closing);
    p->closing = NULL;
}

/* Takes a full stop or a comma behind the equation, as in running text. */
static void take_stop(parser *p) {
    size_t start = p->at;
    int c = algsurf_i_parse_peek(p);
    if (c != '.' && c != ',') return;
    algsurf_i_parse_take(p);
    int at_end = algsurf_i_parse_peek(p) == '\0' ||
                 (p->closing && strncmp(p->text + p->at, p->closing, strlen(p->closing)) == 0);
    if (!at_end) p->at = start;
}

/* The end of the text, after a whole equation. */
static int parse_end(parser *p, int equals_seen) {
    take_stop(p);
    take_closing(p);
    take_stop(p);
    if (!p->closing && algsurf_i_parse_peek(p) == ';') {
        algsurf_i_parse_take(p);
        if (algsurf_i_parse_peek(p) != '\0')
            return algsurf_i_parse_refuse(p, p->at, "nothing may follow ';' but in w = y^2 + z^2; x = w");
    }
    int c = algsurf_i_parse_peek(p);
    if (c == '=') return algsurf_i_parse_refuse(p, p->at, "a second '='");
    if (p->closing)
        return algsurf_i_parse_refuse_here(p, "expected an operator or the sign that closes the equation");
    if (c == '\0') return 1;
    return algsurf_i_parse_refuse_here(p, equals_seen ? "expected an operator or the end"
                                                      : "expected an operator, '=' or the end");
}

/* Does the text go on with these signs, 'x' for X as well, blanks aside?  Then they are taken. */
static int take_signs(parser *p, const char *signs) {
    size_t start = p->at;
    for (; *signs; signs++, algsurf_i_parse_take(p)) {
        int c = algsurf_i_parse_peek(p);
        if (c == ALGSURF_I_TOKEN_LETTER) c = algsurf_i_variable(p->text[p->at]);
        if (c == *signs) continue;
        p->at = start;
        return 0;
    }
    return 1;
}

/* P(x,y,z) = as a name of what is zero.  *named becomes whether that is there. */
static int parse_head(parser *p, int *named) {
    (void)algsurf_i_parse_peek(p);
    size_t start = p->at;
    p->at += algsurf_i_name_length(p->text + start);
    *named = p->at > start && take_signs(p, "(x,y,z)=");
    if (*named) return 1;
    int of_two = p->at > start && take_signs(p, "(x,y)=");
    p->at = start;
    return !of_two || algsurf_i_parse_refuse(p, start, "a function of x and y: write z = ... for its graph");
}

int algsurf_i_parse_equation(parser *p) {
    int solid, named;
    if (!algsurf_i_parse_definitions(p) || !algsurf_i_parse_povray(p, &solid)) return 0;
    if (solid) return parse_end(p, 1);
    if (!parse_head(p, &named)) return 0;
    int equals = !named && algsurf_i_parse_peek(p) == '=';
    if (equals) algsurf_i_parse_take(p);
    if (!algsurf_i_parse_sum(p)) return 0;
    if (!equals && algsurf_i_parse_peek(p) == '=') {
        size_t offset = p->at;
        equals = 1;
        algsurf_i_parse_take(p);
        if (!algsurf_i_parse_sum(p) || !algsurf_i_parse_subtract(p, offset)) return 0;
    }
    return parse_end(p, equals);
}
