/* roots.c - the roots of polynomials, enclosed and counted: roots --help.
 *
 * Plain arguments are the coefficients of one polynomial; without any, polynomials come from standard input.
 *
 * One thread takes line by line, so that a line typed is a line answered.  Several take some hundred lines
 * each, and what they found is printed in the order of the lines. */
#include <errno.h>
#include <math.h>
#if !defined(__wasi__)
#include <pthread.h>
#endif
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "progress.h"
#include "roots_line.h"
#include "roots_write.h"
#include "table.h"

typedef struct roots_options {
    roots_interval real;
    double tolerance;
    int rounded, threads, digits; /* digits 0: doubles */
    enum { FORMAT_TEXT, FORMAT_TSV, FORMAT_JSON } format;
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

#define FIELD(member) offsetof(roots_options, member), 0, 0

static const cli_option options_table[] = {
    {"--real", "LO:HI", "only the real roots from LO to HI, doubles, both included; -inf:inf: all real roots",
     set_interval, FIELD(real)},
    {"--tolerance", "EPS",
     "with --real: how wide the interval about a root may be.  Default 0: as narrow as\n"
     "doubles allow; without --real it always is",
     cli_set_tolerance, FIELD(tolerance)},
    {"--digits", "N",
     "so many correct digits of each root, 1 to 100000, in place of doubles.  Of a complex\n"
     "root, both parts end where the larger one has them.  Boxes may overlap then",
     cli_set_int, offsetof(roots_options, digits), 1, 100000},
    {"--coefficients", "exact|rounded",
     "exact (default): decimals and fractions are taken exactly.  rounded: they are rounded\n"
     "to doubles first, and what is proved holds for the rounded polynomial",
     cli_set_choice, FIELD(rounded)},
    {"--threads", "N", "how many threads share the lines of the input, 1 (default) to 256", cli_set_int,
     offsetof(roots_options, threads), 1, 256},
    {"--format", "text|tsv|json",
     "text (default): for people.  tsv: a table.  json: an object a line, with null for\n'-'", cli_set_choice,
     FIELD(format)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "roots",
    .synopsis = "[options] [P_0 P_1 ... P_N]",
    .about =
        "Finds all roots of polynomials, real and complex, and proves them.  A polynomial is given by\n"
        "its coefficients, lowest degree first: t^2 - 2 is -2 0 1.  Without coefficients on the\n"
        "command line, polynomials are read from standard input, one a line, with blanks between the\n"
        "numbers; '#' starts a comment.\n\n"
        "A coefficient is a real number, or re,im for a complex one; numbers are decimal, hexadecimal,\n"
        "or fractions of two of these, as 1/3.  They are exact, with exponents up to 10^12, as long as\n"
        "a polynomial, times the common denominator of its fractions, has at most 9800 digits\n"
        "from its first to its last.  The degree is at most 512; zeros at the end of a line lower it.\n\n"
        "For each root it prints an approximation, an interval or box that is proved to hold it, and\n"
        "its multiplicity: how many roots, equal or too close to be separated, the box holds.\n"
        "Numbers have the fewest digits that read back exactly.  The columns of --format tsv: line,\n"
        "index, re, im, re_lo, re_hi, im_lo, im_hi, multiplicity, verified (always 1).  A line that\n"
        "is no polynomial has the index \"error\", and '-' in the other columns.",
    .options = options_table,
    .examples = "roots -2 0 1\n"
                "roots --real 0:inf -4 0 3 0 1\n"
                "echo '-4 0 3 0 1' | roots --format tsv\n"
                "echo '1,2 0 -3.5,0x1p-3' | roots\n"
                "roots -0.6 1.1 -0.6 0.1\n"
                "roots -1/147 17/147 -13/21 1\n"
                "roots --digits 100 -2 0 1",
};

enum { MANY_LINES = 256 }; /* for a thread at once */

/* A thread's work: lines, and what is to be printed of them. */
typedef struct batch {
    const roots_options *options;
    const shortest_powers *powers;
    cli_line *line;
    int lines;
    roots_polynomial polynomial;
    roots_row rows[ROOTS_MAX_FIELDS];
    roots_text answers, complaints;
    int bad_lines;
} batch;

/* Is the root the double itself?  The interval from there to there has a root then, which at an end of a
 * wider one may be another. */
static int is_exact(const batch *b, const roots_row *row) {
    const roots_interval here = {row->value.re, row->value.re, 1};
    roots_row found[1];
    roots_complaint why;
    if (!b->polynomial.real || row->box.im.lo != 0 || row->box.im.hi != 0) return 0;
    if (row->box.re.lo < row->box.re.hi && (here.lo == row->box.re.lo || here.lo == row->box.re.hi)) return 0;
    return isfinite(here.lo) && roots_real(&b->polynomial, &here, 0, found, &why) == 1 &&
           found[0].multiplicity == row->multiplicity;
}

static void write_head(batch *b, size_t line, int count) {
    const roots_interval *real = &b->options->real;
    roots_text *to = &b->answers;
    roots_add(to, "line %zu: degree %d", line, b->polynomial.degree);
    if (real->given) {
        roots_add(to, ", real roots in [");
        roots_add_number(to, b->powers, real->lo);
        roots_add(to, ", ");
        roots_add_number(to, b->powers, real->hi);
        roots_add(to, "]");
    }
    roots_add(to, count > 0 ? "\n" : ", no roots\n");
}

static void write_text(batch *b, size_t line, int count) {
    write_head(b, line, count);
    for (int i = 0; i < count; i++)
        roots_write_sentence(&b->answers, b->powers, i + 1, &b->rows[i], is_exact(b, &b->rows[i]),
                             b->options->rounded);
}

static void write_error(batch *b, size_t line, const roots_complaint *why) {
    b->bad_lines++;
    roots_add(&b->complaints, "%s: line %zu: %s\n", program.name, line, why->text);
    roots_add(&b->answers,
              b->options->format != FORMAT_TEXT ? "%zu\terror\t-\t-\t-\t-\t-\t-\t-\t-\n"
                                                : "line %zu: error\n",
              line);
}

static int parse(batch *b, char *const *field, int fields, roots_complaint *why) {
    if (fields < 0) {
        *why = (roots_complaint){"a NUL byte: not a text"};
        return 0;
    }
    return roots_parse(field, fields, b->options->rounded, &b->polynomial, why);
}

/* The roots of the polynomial to as many digits as are asked for; 0 and a complaint. */
static int write_digits(batch *b, size_t line, roots_complaint *why) {
    const roots_options *o = b->options;
    algsurf_precise_roots *roots = NULL;
    int index[ROOTS_MAX_FIELDS];
    int count = roots_precisely(&b->polynomial, &o->real, roots_digits_bits(o->digits), &roots, index, why);
    if (count >= 0 && o->format == FORMAT_TEXT) write_head(b, line, count);
    for (int i = 0; i < count; i++) {
        algsurf_precise_root r;
        roots_decimals re, im;
        (void)algsurf_precise_roots_get(roots, index[i], &r);
        if (!roots_digits(&r, o->digits, &re, &im)) cli_no_memory();
        if (o->format == FORMAT_TEXT)
            roots_write_decimal_sentence(&b->answers, i + 1, &re, &im, r.real, r.multiplicity);
        else
            roots_write_decimal_columns(&b->answers, line, i + 1, &re, &im, r.multiplicity);
        roots_digits_free(&re), roots_digits_free(&im);
    }
    algsurf_precise_roots_free(roots);
    return count >= 0;
}

static int solve(batch *b, roots_complaint *why) {
    const roots_options *o = b->options;
    return o->real.given ? roots_real(&b->polynomial, &o->real, o->tolerance, b->rows, why)
                         : roots_all(&b->polynomial, b->rows, why);
}

/* The same to doubles. */
static int write_doubles(batch *b, size_t line, roots_complaint *why) {
    int count = solve(b, why);
    if (count < 0) return 0;
    if (b->options->format != FORMAT_TEXT)
        roots_write_columns(&b->answers, b->powers, line, b->rows, count);
    else
        write_text(b, line, count);
    return 1;
}
/* One line of input: rows of output, unless it is blank. */
static void take_line(batch *b, cli_line *line) {
    char *field[ROOTS_MAX_FIELDS];
    roots_complaint why;
    int fields = cli_split(line, field, ROOTS_MAX_FIELDS);
    if (fields == 0) return;
    if (!parse(b, field, fields, &why) ||
        !(b->options->digits ? write_digits : write_doubles)(b, line->number, &why))
        write_error(b, line->number, &why);
}

static void *take_batch(void *data) {
    batch *b = data;
    for (int i = 0; i < b->lines; i++) take_line(b, &b->line[i]);
    return NULL;
}

#if defined(__wasi__)
/* WebAssembly's system interface has no threads. */
static void take_batches(batch *b, int count) {
    for (int i = 0; i < count; i++) take_batch(&b[i]);
}
#else
/* All batches that have lines, the first one by this thread; what cannot have a thread, too. */
static void take_batches(batch *b, int count) {
    pthread_t thread[256];
    int started = 1;
    while (started < count && b[started].lines > 0 &&
           pthread_create(&thread[started], NULL, take_batch, &b[started]) == 0)
        started++;
    take_batch(&b[0]);
    for (int i = started; i < count; i++) take_batch(&b[i]);
    for (int i = 1; i < started; i++) pthread_join(thread[i], NULL);
}
#endif

static const table answers = {
    .columns = "line\tindex\tre\tim\tre_lo\tre_hi\tim_lo\tim_hi\tmultiplicity\tverified", .json = 1};

static void print_objects(roots_text *text) {
    roots_add(text, "%s", ""); /* ends it, where there is no room yet, too */
    table_print(&answers, text->text);
    text->length = 0;
}

static void print(FILE *file, roots_text *text) {
    if (text->length > 0) fwrite(text->text, 1, text->length, file);
    text->length = 0;
}

static void print_answers(batch *b) {
    if (b->options->format == FORMAT_JSON)
        print_objects(&b->answers);
    else
        print(stdout, &b->answers);
}

static void make_batches(batch *b, int count, int lines, const roots_options *options,
                         const shortest_powers *powers) {
    for (int i = 0; i < count; i++) {
        b[i].options = options;
        b[i].powers = powers;
        b[i].line = calloc((size_t)lines, sizeof *b[i].line);
        if (!b[i].line) cli_no_memory();
    }
}

static void free_batches(batch *b, int count, int lines) {
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < lines; k++) free(b[i].line[k].text);
        free(b[i].line);
        free(b[i].polynomial.limbs);
        free(b[i].answers.text);
        free(b[i].complaints.text);
    }
    free(b);
}

/* Fills the batches; returns what the last line that was asked for came to. */
static cli_line_result read_lines(batch *b, int count, int most, size_t *number) {
    cli_line_result got = CLI_LINE_READ;
    for (int i = 0; i < count; i++)
        for (b[i].lines = 0; b[i].lines < most && got == CLI_LINE_READ;) {
            cli_line *line = &b[i].line[b[i].lines];
            line->number = *number;
            got = cli_read_line(stdin, line);
            if (got == CLI_LINE_READ) b[i].lines++;
            *number = line->number;
        }
    return got;
}

/* Returns the number of bad lines. */
static int take_input(batch *b, int count, int most) {
    size_t number = 0;
    int bad_lines = 0, read_error = 0;
    cli_line_result got = CLI_LINE_READ;
    progress bar;
    progress_begin_lines(&bar);
    while (got == CLI_LINE_READ && !ferror(stdout)) {
        got = read_lines(b, count, most, &number);
        read_error = errno;
        take_batches(b, count);
        for (int i = 0; i < count; i++) {
            print(stderr, &b[i].complaints);
            print_answers(&b[i]);
        }
        progress_lines(&bar, number);
    }
    progress_end(&bar);
    for (int i = 0; i < count; i++) bad_lines += b[i].bad_lines;
    cli_finish_output();
    if (got == CLI_LINE_NO_MEMORY) cli_no_memory();
    if (got == CLI_LINE_TOO_LONG) cli_fail(CLI_BAD_INPUT, "line %zu: too long", number + 1);
    if (ferror(stdin)) cli_fail(CLI_BROKEN, "cannot read standard input: %s", strerror(read_error));
    return bad_lines;
}

/* The arguments as a line of input, with blanks between them; to be freed. */
static cli_line line_of(char *const *argument, int count) {
    size_t length = 0;
    for (int i = 0; i < count; i++) length += strlen(argument[i]) + 1;
    cli_line line = {malloc(length + 1), 0, length + 1, 1};
    if (!line.text) cli_no_memory();
    for (int i = 0; i < count; i++)
        line.length += (size_t)sprintf(line.text + line.length, "%s ", argument[i]);
    return line;
}

/* Returns the number of bad lines: one polynomial, of which nothing is printed when it is bad. */
static int take_arguments(batch *b, char *const *argument, int count) {
    cli_line line = line_of(argument, count);
    take_line(b, &line);
    free(line.text);
    if (b->bad_lines == 0 && b->answers.length == 0)
        cli_fail(CLI_BAD_INPUT, "expected coefficients, lowest degree first, as -2 0 1 for t^2 - 2");
    if (b->bad_lines > 0) {
        print(stderr, &b->complaints);
        return b->bad_lines;
    }
    if (b->options->format == FORMAT_TSV) printf("#%s\n", answers.columns);
    print_answers(b);
    cli_finish_output();
    return 0;
}

int main(int argc, char **argv) {
    roots_options options = {.threads = 1};
    shortest_powers powers;
    int coefficients = cli_parse_files(&program, argc, argv, &options);
    if (options.digits && options.rounded)
        cli_fail(CLI_BAD_INPUT, "--digits: --coefficients rounded has no more than those of doubles");
    if (options.digits && options.tolerance > 0)
        cli_fail(CLI_BAD_INPUT, "--digits and --tolerance: one of them");
    const int lines = options.threads > 1 ? MANY_LINES : 1;
    batch *b = calloc((size_t)options.threads, sizeof *b);
    if (!b) cli_no_memory();
    shortest_fill(&powers);
    make_batches(b, options.threads, lines, &options, &powers);
    if (options.format == FORMAT_TSV && coefficients == 0) printf("#%s\n", answers.columns);
    int bad_lines =
        coefficients > 0 ? take_arguments(b, argv + 1, coefficients) : take_input(b, options.threads, lines);
    free_batches(b, options.threads, lines);
    return bad_lines > 0 ? CLI_BAD_INPUT : 0;
}
