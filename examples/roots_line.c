/* roots_line.c - see roots_line.h. */
#include "roots_line.h"

int roots_parse(size_t line, char *const *field, int count, roots_polynomial *p) {
    if (count > ROOTS_MAX_FIELDS) {
        cli_complain("line %zu: degree %d, the limit is %d", line, count - 1, ALGSURF_MAX_POLY_DEGREE);
        return 0;
    }
    for (int i = 0; i < count; i++) {
        double parts[2] = {0, 0};
        if (!cli_numbers(field[i], ',', 1, parts) && !cli_numbers(field[i], ',', 2, parts)) {
            cli_complain("line %zu: coefficient %d: expected finite numbers, re or re,im, got '%s'", line, i,
                         cli_quote(field[i]).text);
            return 0;
        }
        p->c[i] = (algsurf_complex){parts[0], parts[1]};
    }
    p->degree = count - 1;
    while (p->degree > 0 && p->c[p->degree].re == 0 && p->c[p->degree].im == 0) p->degree--;
    return 1;
}

static int refused(size_t line, algsurf_status status) {
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    cli_complain("line %zu: %s", line, algsurf_status_text(status));
    return -1;
}

int roots_all(size_t line, algsurf_root_solver *solver, const roots_polynomial *p, roots_row *rows) {
    algsurf_enclosure e[ALGSURF_MAX_POLY_DEGREE];
    int count;
    algsurf_status status = algsurf_root_solver_run(solver, p->c, NULL, p->degree, NULL, e, &count, NULL);
    if (status < 0) return refused(line, status);
    for (int i = 0; i < count; i++) rows[i] = (roots_row){e[i].value, e[i].box, e[i].multiplicity, 1};
    return count;
}

/* A bracket made narrow. */
static roots_row refined(const double *c, int degree, const algsurf_bracket *b, double tolerance) {
    const algsurf_refine_options options = {.size = sizeof options, .tolerance = tolerance};
    algsurf_root root;
    if (algsurf_refine_poly(c, degree, b->lo, b->hi, &options, &root) == ALGSURF_E_NO_MEMORY) cli_no_memory();
    return (roots_row){{root.root, 0}, {{root.lo, root.hi}, {0, 0}}, b->multiplicity, 1};
}

static roots_row exact(const algsurf_bracket *b) {
    return (roots_row){{b->lo, 0}, {{b->lo, b->lo}, {0, 0}}, b->multiplicity, 1};
}

int roots_real(size_t line, const roots_polynomial *p, const roots_interval *where, double tolerance,
               roots_row *rows) {
    double c[ROOTS_MAX_FIELDS];
    algsurf_bracket b[ROOTS_MAX_FIELDS];
    int count;
    for (int i = 0; i <= p->degree; i++) {
        c[i] = p->c[i].re;
        if (p->c[i].im == 0) continue;
        cli_complain("line %zu: coefficient %d is not real, as --real needs it", line, i);
        return -1;
    }
    algsurf_status status =
        algsurf_isolate_all(c, NULL, p->degree, where->lo, where->hi, b, ROOTS_MAX_FIELDS, &count);
    if (status < 0) return refused(line, status);
    for (int i = 0; i < count; i++)
        rows[i] = b[i].kind == ALGSURF_ROOT_EXACT ? exact(&b[i]) : refined(c, p->degree, &b[i], tolerance);
    return count;
}
