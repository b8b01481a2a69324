/* roots_line.c - fuzzes the lines that the example program roots reads, and the rows it makes of them, which
 * are judged by the exact numbers of the line. */
#include "roots_line.h"
#include "exact_decimal.h"
#include "fuzz.h"
#include "isolate_case.h"

static roots_polynomial p;
static roots_row rows[ROOTS_MAX_FIELDS];
static roots_complaint why;

static isolate_chains chains;

enum { MOST_BITS = 20000 }; /* times degree: what a judge, or --real, has time for */

static void check_row(const roots_row *r) {
    fuzz_check(r->box.re.lo <= r->value.re && r->value.re <= r->box.re.hi);
    fuzz_check(r->box.im.lo <= r->value.im && r->value.im <= r->box.im.hi);
    fuzz_check(r->multiplicity >= 1);
}

/* The chains of the line's polynomial, if it is real, not constant, and short. */
static int judge_is_there(char *const *field, int rounded) {
    if (p.degree < 1 || p.degree > 16 || !p.real) return 0;
    int n = p.degree, done = 1;
    mpq_t q[17], common;
    mpz_t *z = exact_polynomials(1, n + 1);
    mpq_init(common);
    mpq_set_ui(common, 1, 1);
    for (int k = 0; k <= n; k++) {
        mpq_init(q[k]);
        done = exact_fraction(q[k], field[k]) && done;
        if (rounded && done && strchr(field[k], '/')) fuzz_check(exact_is_nearest(p.c[k].re, q[k]));
        if (rounded) mpq_set_d(q[k], strchr(field[k], '/') ? p.c[k].re : strtod(field[k], NULL));
        mpz_lcm(mpq_numref(common), mpq_numref(common), mpq_denref(q[k]));
    }
    for (int k = 0; k <= n; k++) {
        mpq_mul(q[k], q[k], common);
        mpz_set(z[k], mpq_numref(q[k]));
        if (mpz_sizeinbase(z[k], 2) * (size_t)n > MOST_BITS) done = 0;
        mpq_clear(q[k]);
    }
    mpq_clear(common);
    if (done) isolate_chains_of(z, n, &chains);
    exact_free(z, n + 1);
    fuzz_check(!done || chains.degree == n);
    return done;
}

/* All roots are there; judged: all real ones are in boxes. */
static void check_all(int judged) {
    int count = roots_all(&p, rows, &why), sum = 0, inside = 0;
    if (count < 0) return;
    for (int i = 0; i < count; i++) {
        const algsurf_cinterval box = rows[i].box;
        check_row(&rows[i]);
        sum += rows[i].multiplicity;
        if (judged && box.im.lo <= 0 && box.im.hi >= 0)
            inside += exact_count_roots(chains.s, box.re.lo, box.re.hi);
    }
    fuzz_check(sum == p.degree);
    fuzz_check(!judged || inside == exact_count_roots(chains.s, -INFINITY, INFINITY));
}

/* In order, and judged: these roots with these multiplicities. */
static void check_real(double lo, double hi, int judged) {
    static isolate_answer a;
    const roots_interval where = {lo, hi, 1};
    a.count = roots_real(&p, &where, 0, rows, &why);
    if (a.count < 0) return;
    for (int i = 0; i < a.count; i++) {
        check_row(&rows[i]);
        algsurf_interval x = rows[i].box.re;
        a.b[i] = (algsurf_bracket){.lo = x.lo, .hi = x.hi, .multiplicity = rows[i].multiplicity};
        a.b[i].kind = x.lo == x.hi ? ALGSURF_BRACKET_EXACT : ALGSURF_BRACKET_ISOLATED;
        int shares = i > 0 && isolate_same_place(a.b + i - 1, a.b + i);
        fuzz_check(lo <= x.lo && x.hi <= hi && (i == 0 || shares || a.b[i - 1].hi <= x.lo));
        if (judged) a.b[i].sign = isolate_sign_after(&chains, x.lo);
        if (shares) a.b[i].sign = a.b[i - 1].multiplicity % 2 ? -a.b[i - 1].sign : a.b[i - 1].sign;
    }
    const char *wrong = judged ? isolate_decisions(&chains, lo, hi, &a) : NULL;
    if (wrong) fprintf(stderr, "[%g, %g]: %s\n", lo, hi, wrong);
    fuzz_check(!wrong);
}

/* Has --real time for the line, instrumented as it is here? */
static int is_short(int rounded) {
    int most = 1;
    for (int k = 0; k <= p.degree; k++)
        if (!rounded && abs(p.integer[k].length) > most) most = abs(p.integer[k].length);
    return p.degree <= 64 && 64 * most * p.degree < 5 * MOST_BITS;
}

static void check_line(char *const *field, int fields, int rounded) {
    if (!roots_parse(field, fields, rounded, &p, &why)) return;
    fuzz_check(p.degree >= 0 && p.degree < fields);
    int judged = judge_is_there(field, rounded);
    check_all(judged);
    if (is_short(rounded)) {
        check_real(-INFINITY, INFINITY, judged);
        check_real(-1, 1, judged);
    }
    if (judged) isolate_chains_clear(&chains);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size == 0) return 0;
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "rb");
    cli_line line = {.number = 0};
    char *field[ROOTS_MAX_FIELDS];
    fuzz_check(file);
    while (cli_read_line(file, &line) == CLI_LINE_READ) {
        int fields = cli_split(&line, field, ROOTS_MAX_FIELDS);
        for (int rounded = 0; fields > 0 && rounded < 2; rounded++) check_line(field, fields, rounded);
    }
    free(line.text);
    free(p.limbs);
    p.limbs = NULL;
    p.capacity = 0;
    fclose(file);
    return 0;
}
