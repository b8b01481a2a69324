/* roots.c - the roots of polynomials, enclosed and counted: roots --help.
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
    const char *extra; /* a plain argument, which this program does not take */
    roots_interval real;
    double tolerance;
    int rounded, threads;
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
    {"--real", "LO:HI", "only the real roots in LO..HI, ends included; -inf and inf are allowed",
     set_interval, FIELD(real)},
    {"--tolerance", "EPS",
     "width wanted of an enclosure with --real, default 0: as narrow as the\n"
     "rounding of the polynomial's values allows; without --real, or where\n"
     "coefficients do not fit doubles, it always is",
     cli_set_tolerance, FIELD(tolerance)},
    {"--coefficients", "exact|rounded",
     "decimals are exact (default), or rounded to doubles: verified is then said\n"
     "of the rounded polynomial",
     cli_set_choice, FIELD(rounded)},
    {"--threads", "N", "1 (default) to 256", cli_set_int, offsetof(roots_options, threads), 1, 256},
    {"--format", "text|tsv|json",
     "to be read by people (default) or programs; json: an object a line, with\nnull for '-'", cli_set_choice,
     FIELD(format)},
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
             "exist.  Roots are printed with the fewest digits that read back exactly.",
    .options = options_table,
    .positional = offsetof(roots_options, extra),
    .examples = "echo '-4 0 3 0 1' | roots\n"
                "echo '-4 0 3 0 1' | roots --real 0:inf --format tsv\n"
                "echo '1,2 0 -3.5,0x1p-3' | roots\n"
                "echo '-0.6 1.1 -0.6 0.1' | roots",
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

/* Is the root the double itself?  The interval from there to there has a root then. */
static int is_exact(const batch *b, const roots_row *row) {
    const roots_interval here = {row->value.re, row->value.re, 1};
    roots_row found[1];
    roots_complaint why;
    if (!b->polynomial.real || row->box.im.lo != 0 || row->box.im.hi != 0) return 0;
    return isfinite(here.lo) && roots_real(&b->polynomial, &here, 0, found, &why) == 1 &&
           found[0].multiplicity == row->multiplicity;
}

static void write_text(batch *b, size_t line, int count) {
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
    for (int i = 0; i < count; i++)
        roots_write_sentence(to, b->powers, i + 1, &b->rows[i], is_exact(b, &b->rows[i]),
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

static int solve(batch *b, char *const *field, int fields, roots_complaint *why) {
    const roots_options *o = b->options;
    if (fields < 0) {
        *why = (roots_complaint){"a NUL byte: not a text"};
        return -1;
    }
    if (!roots_parse(field, fields, o->rounded, &b->polynomial, why)) return -1;
    return o->real.given ? roots_real(&b->polynomial, &o->real, o->tolerance, b->rows, why)
                         : roots_all(&b->polynomial, b->rows, why);
}

/* One line of input: rows of output, unless it is blank. */
static void take_line(batch *b, cli_line *line) {
    char *field[ROOTS_MAX_FIELDS];
    roots_complaint why;
    int fields = cli_split(line, field, ROOTS_MAX_FIELDS);
    if (fields == 0) return;
    int count = solve(b, field, fields, &why);
    if (count < 0)
        write_error(b, line->number, &why);
    else if (b->options->format != FORMAT_TEXT)
        roots_write_columns(&b->answers, b->powers, line->number, b->rows, count);
    else
        write_text(b, line->number, count);
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
            if (b->options->format == FORMAT_JSON)
                print_objects(&b[i].answers);
            else
                print(stdout, &b[i].answers);
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

int main(int argc, char **argv) {
    roots_options options = {.threads = 1};
    shortest_powers powers;
    cli_parse(&program, argc, argv, &options);
    if (options.extra)
        cli_fail(CLI_BAD_INPUT, "unexpected '%s': polynomials come from standard input",
                 cli_quote(options.extra).text);
    const int lines = options.threads > 1 ? MANY_LINES : 1;
    batch *b = calloc((size_t)options.threads, sizeof *b);
    if (!b) cli_no_memory();
    shortest_fill(&powers);
    make_batches(b, options.threads, lines, &options, &powers);
    if (options.format == FORMAT_TSV) printf("#%s\n", answers.columns);
    int bad_lines = take_input(b, options.threads, lines);
    free_batches(b, options.threads, lines);
    return bad_lines > 0 ? CLI_BAD_INPUT : 0;
}
