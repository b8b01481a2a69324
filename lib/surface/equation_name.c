/* equation_name.c - see equation_name.h. */
#include "../base/arithmetic.h"
#include "equation_name.h"

#include <string.h>

#include "equation_steps.h"

typedef algsurf_i_parser parser;

static int is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static int is_digit(char c) { return c >= '0' && c <= '9'; }

const algsurf_constant *algsurf_i_find_constant(const parser *p, const char *name, size_t length) {
    size_t low = 0, high = p->constant_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const char *candidate = p->constants[middle]->name;
        int order = strncmp(candidate, name, length);
        if (order == 0 && candidate[length] == '\0') return p->constants[middle];
        if (order < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return NULL;
}

static int is_pi(const char *name, size_t length) {
    return length == 2 && (name[0] == 'p' || name[0] == 'P') && (name[1] == 'i' || name[1] == 'I');
}

size_t algsurf_i_first_factor(const parser *p, const char *name, size_t length,
                              const algsurf_constant **constant) {
    *constant = NULL;
    if (algsurf_i_variable(name[0])) return 1;
    for (size_t n = length; n > 0; n--) {
        *constant = algsurf_i_find_constant(p, name, n);
        if (*constant) return n;
    }
    return length >= 2 && is_pi(name, 2) ? 2 : 0;
}

/* The characters of a name from number `known` on are no factor: says which letters between variables have no
 * value, or what people mean by such names. */
static int refuse_name(parser *p, const char *name, size_t length, size_t known) {
    size_t begin = known, end = known;
    while (begin > 0 && !algsurf_i_variable(name[begin - 1])) begin--;
    while (end < length && !algsurf_i_variable(name[end])) end++;
    if (algsurf_i_is_function(name, length) || algsurf_i_is_function(name + begin, end - begin))
        return algsurf_i_parse_refuse(p, p->at, ALGSURF_I_NOT_POLYNOMIAL);
    if (strncmp(name, "sqrt", strlen("sqrt")) == 0)
        return algsurf_i_parse_refuse(p, p->at, "expected '(' behind sqrt");
    if (known > 0 && is_digit(name[known]))
        return algsurf_i_parse_refuse(
            p, p->at, "a number behind a letter: write x^2 for a power, 2x or x*2 for a product");
    for (size_t n = 0; n < length; n++)
        if (!is_letter(name[n])) begin = 0, end = length; /* no product of letters */
    p->unknown = end - begin;
    return algsurf_i_parse_fail(p, ALGSURF_E_NAME, p->at + begin, "not x, y or z: it needs a value");
}

int algsurf_i_split_name(parser *p, const char *name, size_t length) {
    const algsurf_constant *constant;
    for (size_t known = 0; known < length;) {
        size_t factor = algsurf_i_first_factor(p, name + known, length - known, &constant);
        if (factor == 0) return refuse_name(p, name, length, known);
        known += factor;
    }
    p->letters_end = p->at + length;
    return 1;
}
