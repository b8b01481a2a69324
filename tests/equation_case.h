/* equation_case.h - equations as text, for tests: accepted and equal, or refused and explained. */
#ifndef EQUATION_CASE_H
#define EQUATION_CASE_H
#include "scenes.h"

enum { MOST_TERMS = 64 };

static inline algsurf_surface *parse_with(const char *text, const algsurf_constant *constants, size_t n) {
    algsurf_surface *s = NULL;
    algsurf_parse_error error = {0, 0, ""};
    algsurf_status status = algsurf_surface_from_equation(text, constants, n, &s, &error);
    if (status != ALGSURF_OK) fprintf(stderr, "%.200s\n%zu: %s\n", text, error.offset, error.message);
    assert_ok(status);
    return surface_kept(s);
}

static inline algsurf_surface *parse(const char *text) { return parse_with(text, NULL, 0); }

/* Do both texts make the same terms, bit for bit?  The constants are those of the first. */
static inline void same_with(const char *a, const algsurf_constant *constants, size_t n, const char *b) {
    algsurf_term ta[MOST_TERMS], tb[MOST_TERMS];
    algsurf_surface *sa = parse_with(a, constants, n), *sb = parse(b);
    size_t count = algsurf_surface_term_count(sa);
    int equal = count == algsurf_surface_term_count(sb) && count <= MOST_TERMS;
    if (equal) {
        assert_ok(algsurf_surface_terms(sa, ta));
        assert_ok(algsurf_surface_terms(sb, tb));
    }
    for (size_t t = 0; equal && t < count; t++) {
        equal = ta[t].i == tb[t].i && ta[t].j == tb[t].j && ta[t].k == tb[t].k && ta[t].a == tb[t].a;
    }
    if (!equal) fprintf(stderr, "'%s' and '%s' differ\n", a, b);
    assert_true(equal);
}

static inline void same(const char *a, const char *b) { same_with(a, NULL, 0, b); }

/* A text that is refused: the part of it that the error marks, and a part of the message. */
typedef struct refused_text {
    const char *text, *at, *why;
} refused_text;

static inline void explained(const refused_text *c, const algsurf_constant *constants, size_t n) {
    algsurf_surface *s;
    algsurf_parse_error error = {99, 99, ""};
    (void)algsurf_surface_from_equation(c->text, constants, n, &s, &error);
    if (error.length != strlen(c->at) || !strstr(error.message, c->why) ||
        strncmp(c->text + error.offset, c->at, error.length) != 0)
        fail_msg("'%s': %zu+%zu: %s", c->text, error.offset, error.length, error.message);
}

#endif
