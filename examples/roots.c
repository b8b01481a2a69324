/* roots.c - the roots of polynomials, enclosed and counted: roots --help. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "roots_line.h"

typedef struct roots_options {
    const char *extra; /* a plain argument, which this program does not take */
    roots_interval real;
    double tolerance;
    int rounded, tsv;
} roots_options;

static void set_interval(const cli_option *option, const char *value, void *field) {
    char text[128];
    roots_interval interval = {.given = 1};
    size_t length = strlen(value);
    if (length >= sizeof text) cli_expected(option, value);
    memcpy(text, value, length + 1);
    char *colon = strchr(text, ':');
    if (!colon) cli_expected(option, value);
    *colon = '\0';
    if (!cli_number(text, &interval.lo) || !cli_number(colon + 1, &interval.hi)) cli_expected(option, value);
    if (!(interval.lo <= interval.hi)) cli_expected(option, value);
    *(roots_interval *)field = interval;
}

static void set_choice(const cli_option *option, const char *value, void *field) {
    *(int *)field = cli_choice(option, value);
}

#define FIELD(member) offsetof(roots_options, member), 0, 0

static const cli_option options_table[] = {
    {"--real", "LO:HI", "only the real roots in LO..HI, ends included; -inf and inf are allowed",
     set_interval, FIELD(real)},
    {"--tolerance", "EPS",
     "half width wanted of an enclosure with --real, default 0: as narrow as the\n"
     "rounding of the polynomial's values allows; without --real, or where\n"
     "coefficients do not fit doubles, it always is",
     cli_set_tolerance, FIELD(tolerance)},
    {"--coefficients", "exact|rounded",
     "decimals are exact (default), or rounded to doubles: verified is then said\n"
     "of the rounded polynomial",
     cli_set_coefficients, FIELD(rounded)},
    {"--format", "text|tsv", "to be read by people (default) or programs", set_choice, FIELD(tsv)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "roots",
    .synopsis = "[options]",
    .about = "Reads polynomials from standard input, one a line, as coefficients p_0 p_1 ... p_n\n"
             "separated by blanks, each \"re\" or \"re,im\", decimal or hexadecimal, at most 513; '#'\n"
             "starts a comment.  Numbers are exact, whatever their length and exponent, up to 9800\n"
             "decimals from a line's first digit to its last.  Prints all complex roots: an\n"
             "approximation, a box that is proved to enclose it, and how many roots the box holds: the\n"
             "multiplicity of one, or a cluster of several.  Zeros at the end of a line lower the\n"
             "degree: no root is at infinity.\n"
             "The columns of --format tsv: line, index, re, im, re_lo, re_hi, im_lo, im_hi,\n"
             "multiplicity, verified (1); a bad line has the index \"error\", and '-' for what does not\n"
             "exist.  Roots are printed so that they read back exactly.",
    .options = options_table,
    .positional = offsetof(roots_options, extra),
    .examples = "echo '-4 0 3 0 1' | roots\n"
                "echo '-4 0 3 0 1' | roots --real 0:inf --format tsv\n"
                "echo '1,2 0 -3.5,0x1p-3' | roots\n"
                "echo '-0.6 1.1 -0.6 0.1' | roots",
};

/* What every line needs. */
typedef struct run {
    roots_options options;
    algsurf_root_solver *solver;
    roots_polynomial polynomial;
    roots_row rows[ROOTS_MAX_FIELDS];
    int bad_lines;
} run;

static void print_columns(size_t line, const roots_row *rows, int count) {
    for (int i = 0; i < count; i++) {
        const roots_row *r = &rows[i];
        const double numbers[6] = {r->value.re,  r->value.im,  r->box.re.lo,
                                   r->box.re.hi, r->box.im.lo, r->box.im.hi};
        printf("%zu\t%d", line, i + 1);
        for (int k = 0; k < 6; k++) printf("\t%.17g", numbers[k]);
        printf("\t%d\t1\n", r->multiplicity);
    }
}

static void print_root(int index, const roots_row *r, int rounded) {
    int real = r->box.im.lo == 0 && r->box.im.hi == 0;
    printf("%5d  %-7s  %.17g", index, real ? "real" : "complex", r->value.re);
    if (!real) printf(" %+.17g i", r->value.im);
    printf("   in [%.17g, %.17g]", r->box.re.lo, r->box.re.hi);
    if (!real) printf(" + [%.17g, %.17g] i", r->box.im.lo, r->box.im.hi);
    if (r->multiplicity > 1) printf(", %d roots", r->multiplicity);
    puts(rounded ? ", verified for the rounded polynomial" : ", verified");
}

static void print_text(const run *r, size_t line, int count) {
    const roots_interval *real = &r->options.real;
    printf("line %zu: degree %d", line, r->polynomial.degree);
    if (real->given) printf(", real roots in [%.17g, %.17g]", real->lo, real->hi);
    puts(count > 0 ? "" : ", no roots");
    for (int i = 0; i < count; i++) print_root(i + 1, &r->rows[i], r->options.rounded);
}

static void print_error(const run *r, size_t line) {
    if (r->options.tsv)
        printf("%zu\terror\t-\t-\t-\t-\t-\t-\t-\t-\n", line);
    else
        printf("line %zu: error\n", line);
}

static int solve(run *r, size_t line) {
    const roots_options *o = &r->options;
    return o->real.given ? roots_real(line, &r->polynomial, &o->real, o->tolerance, r->rows)
                         : roots_all(line, r->solver, &r->polynomial, r->rows);
}

/* One line of input: rows of output, unless it is blank. */
static void take_line(run *r, cli_line *line) {
    char *field[ROOTS_MAX_FIELDS];
    int fields = cli_split(line, field, ROOTS_MAX_FIELDS), count = -1;
    if (fields == 0) return;
    if (fields < 0)
        cli_complain("line %zu: a NUL byte: not a text", line->number);
    else if (roots_parse(line->number, field, fields, r->options.rounded, &r->polynomial))
        count = solve(r, line->number);
    if (count < 0) {
        r->bad_lines++;
        print_error(r, line->number);
    } else if (r->options.tsv) {
        print_columns(line->number, r->rows, count);
    } else {
        print_text(r, line->number, count);
    }
}

static void take_lines(run *r) {
    cli_line line = {.number = 0};
    cli_line_result got;
    if (r->options.tsv)
        fputs("#line\tindex\tre\tim\tre_lo\tre_hi\tim_lo\tim_hi\tmultiplicity\tverified\n", stdout);
    while ((got = cli_read_line(stdin, &line)) == CLI_LINE_READ) {
        take_line(r, &line);
        if (ferror(stdout)) break;
    }
    int read_error = errno;
    cli_finish_output();
    if (got == CLI_LINE_NO_MEMORY) cli_no_memory();
    if (got == CLI_LINE_TOO_LONG) cli_fail(CLI_BAD_INPUT, "line %zu: too long", line.number + 1);
    if (ferror(stdin)) cli_fail(CLI_BROKEN, "cannot read standard input: %s", strerror(read_error));
    free(line.text);
}

int main(int argc, char **argv) {
    run *r = calloc(1, sizeof *r);
    if (!r) cli_no_memory();
    cli_parse(&program, argc, argv, &r->options);
    if (r->options.extra)
        cli_fail(CLI_BAD_INPUT, "unexpected '%s': polynomials come from standard input",
                 cli_quote(r->options.extra).text);
    algsurf_status status = algsurf_root_solver_create(ALGSURF_MAX_POLY_DEGREE, &r->solver);
    if (status != ALGSURF_OK) cli_no_memory();
    take_lines(r);
    int bad_lines = r->bad_lines;
    algsurf_root_solver_free(r->solver);
    free(r->polynomial.limbs);
    free(r);
    return bad_lines > 0 ? CLI_BAD_INPUT : 0;
}
