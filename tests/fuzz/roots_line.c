/* roots_line.c - fuzzes the lines that the example program roots reads, and the rows it makes of them. */
#include "roots_line.h"
#include "exact_roots.h"
#include "fuzz.h"

static roots_polynomial p;
static roots_row rows[ROOTS_MAX_FIELDS];

static void check_row(const roots_row *r) {
    fuzz_check(r->box.re.lo <= r->value.re && r->value.re <= r->box.re.hi);
    fuzz_check(r->box.im.lo <= r->value.im && r->value.im <= r->box.im.hi);
    fuzz_check(r->multiplicity >= 0 && (r->verified == 0 || r->verified == 1));
}

static void check_all(algsurf_root_solver *solver) {
    int count = roots_all(1, solver, &p, rows), sum = 0;
    for (int i = 0; i < count; i++) {
        check_row(&rows[i]);
        sum += rows[i].multiplicity;
    }
    fuzz_check(count == -1 || sum == p.degree);
}

/* In order, disjoint but for their ends, and what is verified holds one root. */
static void check_real(double lo, double hi) {
    const roots_interval where = {lo, hi, 1};
    int count = roots_real(1, &p, &where, 0, rows);
    double c[ROOTS_MAX_FIELDS];
    if (count < 0) return;
    for (int k = 0; k <= p.degree; k++) c[k] = p.c[k].re;
    int judged = p.degree > 0 && p.degree <= 16 && fuzz_span(c, p.degree + 1) * p.degree < 20000;
    exact_sturm s;
    if (judged) s = exact_sturm_of_doubles(c, p.degree);
    for (int i = 0; i < count; i++) {
        check_row(&rows[i]);
        algsurf_interval x = rows[i].box.re;
        fuzz_check(lo <= x.lo && x.hi <= hi && (i == 0 || rows[i - 1].box.re.hi <= x.lo));
        if (judged && rows[i].verified) fuzz_check(exact_count_roots(&s, x.lo, x.hi) == 1);
    }
    if (judged) exact_sturm_clear(&s);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static algsurf_root_solver *solver;
    if (!solver) fuzz_check(algsurf_root_solver_create(ALGSURF_MAX_POLY_DEGREE, &solver) == ALGSURF_OK);
    if (size == 0) return 0;
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "rb");
    cli_line line = {.number = 0};
    char *field[ROOTS_MAX_FIELDS];
    fuzz_check(file);
    while (cli_read_line(file, &line) == CLI_LINE_READ) {
        int fields = cli_split(&line, field, ROOTS_MAX_FIELDS);
        if (fields <= 0 || !roots_parse(line.number, field, fields, &p)) continue;
        fuzz_check(p.degree >= 0 && p.degree < fields);
        check_all(solver);
        check_real(-INFINITY, INFINITY);
        check_real(-1, 1);
    }
    free(line.text);
    fclose(file);
    return 0;
}
