/* define.c - names that a text defines, w = y^2 + z^2; see parse.h.
 *
 * What a name stands for is read once where it is defined, so that what is wrong is told there, and once more
 * in each place that the name is used, as if it stood there in brackets.  So all that is promised about
 * coefficients and about time holds for the text with the definitions put in.  As names in definitions would
 * make that grow as a power, what is put in is limited.
 *
 * Names are found before anything is read, since they tell which letters of the text belong together.
 */
#include "../base/arithmetic.h"
#include "parse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The place of the next ';', which is not a blank of LaTeX; or of the end. */
static size_t statement_end(const char *text, size_t at) {
    for (; text[at] && text[at] != ';'; at++)
        if (text[at] == '\\' && text[at + 1]) at++;
    return at;
}

/* Is the name one that can be defined?  Products of coordinates are none. */
static int is_definable(const char *name, size_t length) {
    if (algsurf_i_listed("sqrt", name, length)) return 0;
    for (size_t at = 0; at < length;) {
        algsurf_i_letter part = algsurf_i_name_part_at(name + at);
        if (!algsurf_i_variable(part.code)) return 1;
        at += part.width;
    }
    return 0;
}

/* Is a definition there, NAME = ..., ended by a ';' with more behind?  Then *found becomes it. */
static int definition_at(const char *text, size_t at, algsurf_i_definition *found) {
    at += algsurf_i_blanks(text + at);
    size_t length = algsurf_i_name_length(text + at), sign = at + length;
    sign += algsurf_i_blanks(text + sign);
    algsurf_i_token token = algsurf_i_token_at(text + sign);
    if (token.kind != '=' || !is_definable(text + at, length)) return 0;
    *found = (algsurf_i_definition){{text + at, NAN}, sign + token.width, statement_end(text, sign)};
    if (text[found->end] == '\0') return 0;
    return text[found->end + 1 + algsurf_i_blanks(text + found->end + 1)] != '\0';
}

/* What stands about an equation; a blank is any blanks, or none. */
static const struct {
    const char *open, *close;
} quotes[] = {
    {"$$", "$$"},
    {"$", "$"},
    {"\\(", "\\)"},
    {"\\[", "\\]"},
    {"\\begin{equation}", "\\end{equation}"},
    {"\\begin{equation*}", "\\end{equation*}"},
    {"\\begin{align}", "\\end{align}"},
    {"\\begin{align*}", "\\end{align*}"},
    {"\\begin{displaymath}", "\\end{displaymath}"},
    {"\\begin{math}", "\\end{math}"},
    {"function {", "}"}, /* POV-Ray */
    {"function ( x , y , z ) {", "}"},
};

/* How many bytes of the text are these signs; 0: it starts with others. */
static size_t width_of(const char *signs, const char *text) {
    size_t at = 0;
    for (; *signs; signs++)
        if (*signs == ' ')
            at += algsurf_i_blanks(text + at);
        else if (text[at++] != *signs)
            return 0;
    return at;
}

/* Moves behind the sign that opens the equation, if one is there and none was. */
static void take_open(parser *p) {
    (void)algsurf_i_parse_peek(p);
    for (size_t q = 0; !p->closing && q < sizeof quotes / sizeof *quotes; q++) {
        const size_t width = width_of(quotes[q].open, p->text + p->at);
        if (width == 0) continue;
        p->at += width;
        p->closing = quotes[q].close;
    }
}

algsurf_status algsurf_i_definitions_find(parser *p) {
    size_t capacity = 0;
    algsurf_i_definition found;
    for (take_open(p); definition_at(p->text, p->at, &found); take_open(p)) {
        if (p->definitions == capacity) {
            capacity = 2 * capacity + 4;
            algsurf_i_definition *room = realloc(p->definition, capacity * sizeof *room);
            if (!room) return ALGSURF_E_NO_MEMORY;
            p->definition = room;
        }
        p->definition[p->definitions++] = found;
        p->at = found.end + 1;
    }
    return ALGSURF_OK;
}

int algsurf_i_parse_definitions(parser *p) {
    size_t equation = p->at;
    for (; p->known < p->definitions; p->known++) {
        p->at = p->definition[p->known].begin;
        if (!algsurf_i_parse_sum(p)) return 0;
        if (algsurf_i_parse_peek(p) != ';')
            return algsurf_i_parse_refuse_here(p, "expected an operator or ';'");
        algsurf_i_value_free(algsurf_i_parse_top(p));
        p->values--;
    }
    p->at = equation;
    return 1;
}

int algsurf_i_parse_defined(parser *p, const algsurf_i_definition *definition, size_t place) {
    if (definition >= p->definition + p->known)
        return algsurf_i_parse_refuse(p, place, "this name is used before it is defined");
    p->put_in += definition->end - definition->begin;
    if (p->put_in > ALGSURF_I_PUT_IN_LIMIT)
        return algsurf_i_parse_refuse(p, place, "definitions put in make more than 20000 characters");
    algsurf_i_names kept = p->names; /* the letters of the name are still to be read */
    size_t at = p->at, letter = p->letter, letters_end = p->letters_end;
    p->names.letter = NULL;
    p->names.count = p->names.capacity = 0;
    p->letters_end = 0;
    p->at = definition->begin;
    int ok = algsurf_i_parse_nested(p, place, algsurf_i_parse_sum);
    free(p->names.letter);
    p->names = kept;
    p->at = at;
    p->letter = letter;
    p->letters_end = letters_end;
    if (!ok && p->error.message) p->error = (algsurf_parse_error){place, 0, p->error.message};
    return ok;
}
