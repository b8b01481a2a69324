/* name.c - see name.h. */
#include "../base/arithmetic.h"
#include "name.h"

#include <string.h>

#include "letter.h"
#include "refuse.h"

typedef algsurf_i_parser parser;

const algsurf_constant *algsurf_i_find_constant(const parser *p, const char *name, size_t length) {
    size_t low = 0, high = p->constant_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const char *candidate = p->constants[middle]->name;
        int order = algsurf_i_name_order(candidate, strlen(candidate), name, length);
        if (order == 0) return p->constants[middle];
        if (order < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return NULL;
}

static int is_pi(const char *name, size_t length) {
    return length >= 2 && (name[0] == 'p' || name[0] == 'P') && (name[1] == 'i' || name[1] == 'I');
}

size_t algsurf_i_first_factor(const parser *p, const char *name, size_t length,
                              const algsurf_constant **constant) {
    *constant = NULL;
    if (algsurf_i_variable(name[0])) return 1;
    size_t found = 0;
    for (size_t parts = 0, n = 0; n < length && parts < p->longest; parts++) {
        n += algsurf_i_name_part_at(name + n).width;
        const algsurf_constant *candidate = algsurf_i_find_constant(p, name, n);
        if (candidate) *constant = candidate, found = n;
    }
    return found ? found : is_pi(name, length) ? 2 : 0;
}

int algsurf_i_split_name(parser *p, const char *name, size_t length) {
    const algsurf_constant *constant;
    for (size_t known = 0; known < length;) {
        size_t factor = algsurf_i_first_factor(p, name + known, length - known, &constant);
        if (factor == 0) return algsurf_i_refuse_name(p, name, length, known);
        known += factor;
    }
    p->letters_end = p->at + length;
    return 1;
}
