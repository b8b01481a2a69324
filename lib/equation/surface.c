/* surface.c - a surface from an equation as text: constants in, coefficients out.
 *
 * The constants are checked, the parser (parse.h) computes the polynomial left
 * minus right in double-double, each coefficient is rounded once, and the surface is made of them.
 */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"
#include "../base/fpenv.h"
#include "../surface/impl.h"

/* What rounding a coefficient to the double a changed, or its computation may have, as a part of a. */
static double relative_rounding(const monomial *m, double a) {
    if (m->v.lo == 0 && m->err == 0 && ldexp(a, -256 * m->e) == m->v.hi) return 0;
    double part = (fabs(m->v.lo) + m->err) / fabs(m->v.hi);
    return fabs(a) < 0x1p-1022 ? part + 0x1p-1074 / fabs(a) : part;
}

/* The polynomial with its coefficients rounded, as a surface.  offset: where to place an overflow. */
static algsurf_status to_surface(const tripoly *p, size_t offset, algsurf_surface **surface,
                                 algsurf_parse_error *error) {
    if (p->count == 0) return ALGSURF_E_ZERO;
    algsurf_term *terms = malloc(p->count * sizeof *terms);
    if (!terms) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = ALGSURF_OK;
    double rounding = 0;
    for (size_t t = 0; status == ALGSURF_OK && t < p->count; t++) {
        int key = p->m[t].key;
        double a = algsurf_i_monomial_round(&p->m[t]);
        terms[t] = (algsurf_term){algsurf_i_exponent(key, 0), algsurf_i_exponent(key, 1),
                                  algsurf_i_exponent(key, 2), a};
        rounding = fmax(rounding, relative_rounding(&p->m[t], a));
        if (!isfinite(a)) status = ALGSURF_E_RANGE;
    }
    if (status == ALGSURF_E_RANGE) {
        *error = (algsurf_parse_error){offset, 0, "a coefficient is too large for a double"};
    } else {
        status = algsurf_i_surface_make(terms, p->count, 0, rounding * (1 + 0x1p-40), surface);
    }
    free(terms);
    return status;
}

static algsurf_status check_constants(const algsurf_constant *constants, size_t count) {
    for (size_t c = 0; c < count; c++) {
        const char *name = constants[c].name;
        size_t length = name ? algsurf_i_name_length(name) : 0;
        if (length == 0 || name[length] != '\0' || algsurf_i_listed("x y z sqrt", name, length))
            return ALGSURF_E_ARGUMENT;
        if (!isfinite(constants[c].value)) return ALGSURF_E_NOT_FINITE;
    }
    return ALGSURF_OK;
}

/* The names of the constants and those that the text defines. */
static algsurf_status make_names(parser *p, const algsurf_constant *constants, size_t count) {
    size_t bytes = 0;
    for (size_t c = 0; c < count; c++) bytes += strlen(constants[c].name);
    algsurf_status status = algsurf_i_definitions_find(p);
    for (size_t d = 0; d < p->definitions; d++) bytes += algsurf_i_name_length(p->definition[d].name.name);
    if (status == ALGSURF_OK) status = algsurf_i_names_make(&p->names, bytes);
    for (size_t c = 0; status == ALGSURF_OK && c < count; c++)
        status = algsurf_i_names_add(&p->names, &constants[c]);
    for (size_t d = 0; status == ALGSURF_OK && d < p->definitions; d++) {
        const algsurf_constant *name = &p->definition[d].name;
        status = algsurf_i_names_add(&p->names, name);
        if (status != ALGSURF_E_ARGUMENT) continue;
        (void)algsurf_i_parse_refuse(p, (size_t)(name->name - p->text), "this name has a value already");
        status = ALGSURF_E_SYNTAX;
    }
    if (status == ALGSURF_OK) algsurf_i_names_link(&p->names);
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, surface_from_equation,
                (const char *text, const algsurf_constant *constants, size_t count, algsurf_surface **surface,
                 algsurf_parse_error *error),
                (text, constants, count, surface, error)) {
    if (!text || !surface || (count > 0 && !constants)) return ALGSURF_E_ARGUMENT;
    parser p = {.text = text};
    algsurf_status status = check_constants(constants, count);
    if (status == ALGSURF_OK) status = make_names(&p, constants, count);
    if (status == ALGSURF_OK && !algsurf_i_parse_equation(&p)) status = p.status;
    if (status == ALGSURF_OK) status = to_surface(&p.value[0].p, p.at, surface, &p.error);
    while (p.values > 0) algsurf_i_value_free(&p.value[--p.values]);
    algsurf_i_names_free(&p.names);
    free(p.definition);
    if (!error || !p.error.message) return status;
    *error = p.error;
    if (!error->length) error->length = algsurf_i_wrong_length(text + error->offset);
    return status;
}
