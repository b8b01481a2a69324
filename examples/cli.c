/* cli.c - see cli.h. */
#include "cli.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "cli_guess.h"
#include "portable.h"

/* ---- complaints ---- */

static const char *program_name = "algsurf"; /* set once, by cli_parse */

static void print_line(const char *format, va_list arguments) {
    fprintf(stderr, "%s: ", program_name);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
}

void cli_complain(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    print_line(format, arguments);
    va_end(arguments);
}

_Noreturn void cli_fail(int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    print_line(format, arguments);
    va_end(arguments);
    exit(status);
}

_Noreturn void cli_fail_in(const char *text, size_t offset, size_t length, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    print_line(format, arguments);
    va_end(arguments);
    cli_point_at(stderr, text, offset, length);
    exit(CLI_BAD_INPUT);
}

_Noreturn void cli_no_memory(void) { cli_fail(CLI_BROKEN, "out of memory"); }

_Noreturn void cli_expected(const cli_option *option, const char *value) {
    cli_fail(CLI_BAD_INPUT, "%s: expected %s, got '%s'", option->name, option->argument,
             cli_quote(value).text);
}

void cli_finish_output(void) {
    if (fflush(stdout) != 0 || ferror(stdout))
        cli_fail(CLI_BROKEN, "cannot write to standard output: %s", strerror(errno));
}

/* ---- numbers and lines ---- */

int cli_number(const char *text, double *value) {
    if (!*text || isspace((unsigned char)*text)) return 0;
    char *end;
    *value = strtod(text, &end);
    return *end == '\0';
}

int cli_numbers(const char *text, char separator, int count, double *values) {
    for (int i = 0; i < count; i++) {
        if (isspace((unsigned char)*text)) return 0;
        char *end;
        values[i] = strtod(text, &end);
        if (end == text || !isfinite(values[i])) return 0;
        if (*end != (i + 1 < count ? separator : '\0')) return 0;
        text = end + 1;
    }
    return 1;
}

int cli_whole(const char *text, int low, int high, int *value) {
    int n = 0;
    if (!*text) return 0;
    for (; *text; text++) {
        if (*text < '0' || *text > '9') return 0;
        int digit = *text - '0';
        if (n > (high - digit) / 10) return 0;
        n = 10 * n + digit;
    }
    if (n < low || n > high) return 0;
    *value = n;
    return 1;
}

cli_line_result cli_read_line(FILE *file, cli_line *line) {
    enum { LONGEST = 1 << 26 };
    line->length = 0;
    for (int c = getc(file);; c = getc(file)) {
        if (line->length == line->capacity) {
            if (line->capacity >= LONGEST) return CLI_LINE_TOO_LONG;
            size_t capacity = line->capacity ? 2 * line->capacity : 256;
            char *text = realloc(line->text, capacity);
            if (!text) return CLI_LINE_NO_MEMORY;
            line->text = text;
            line->capacity = capacity;
        }
        if (c == EOF && line->length == 0) return CLI_LINE_END;
        if (c == EOF || c == '\n') break;
        line->text[line->length++] = (char)c;
    }
    if (line->length > 0 && line->text[line->length - 1] == '\r') line->length--;
    line->text[line->length] = '\0';
    line->number++;
    return CLI_LINE_READ;
}

int cli_split(cli_line *line, char **fields, int capacity) {
    if (strlen(line->text) != line->length) return -1;
    line->text[strcspn(line->text, "#")] = '\0';
    int count = 0;
    for (char *at = line->text;;) {
        at += strspn(at, " \t");
        if (!*at) return count;
        if (count < capacity) fields[count] = at;
        count++;
        at += strcspn(at, " \t");
        if (*at) *at++ = '\0';
    }
}

/* ---- options ---- */

/* A row without a name is a heading. */
static int is_heading(const cli_option *option) { return option->name[0] == '\0'; }

static void print_option(const char *name, const char *argument, const char *help) {
    int width = printf("  %s%s%s", name, argument ? " " : "", argument ? argument : "");
    if (width > 27) {
        putchar('\n');
        width = 0;
    }
    for (;; width = 0) {
        size_t length = strcspn(help, "\n");
        printf("%*s%.*s\n", 28 - width, "", (int)length, help);
        if (!help[length]) return;
        help += length + 1;
    }
}

static void print_examples(const char *line) {
    puts("\nexamples:");
    for (size_t length; *line; line += length + (line[length] == '\n')) {
        length = strcspn(line, "\n");
        printf("  %.*s\n", (int)length, line);
    }
}

static _Noreturn void print_help(const cli_program *program) {
    printf("usage: %s %s\n\n%s\n\noptions:\n", program->name, program->synopsis, program->about);
    for (const cli_option *o = program->options; o->name; o++) {
        if (is_heading(o))
            printf("\n %s:\n", o->help);
        else
            print_option(o->name, o->argument, o->help);
    }
    if (is_heading(program->options)) puts("\n This program:");
    print_option("--help", NULL, "prints this text; also -h");
    print_option("--version", NULL, "prints the version of libalgsurf; also -V");
    if (program->examples) print_examples(program->examples);
    cli_finish_output();
    exit(0);
}

static _Noreturn void print_version(const cli_program *program) {
    printf("%s (libalgsurf) %s\n", program->name, algsurf_version());
    cli_finish_output();
    exit(0);
}

/* Is it the name of `length` characters? */
static int is_name(const char *name, const char *text, size_t length) {
    return strlen(name) == length && strncmp(name, text, length) == 0;
}

/* The option of that name, or null. */
static const cli_option *option_named(const cli_program *program, const char *text, size_t length) {
    static const char *const spellings[][2] = {
        {"-o", "--output"}, {"--color", "--colour"}, {"--center", "--centre"}};
    for (size_t i = 0; i < sizeof spellings / sizeof *spellings; i++)
        if (is_name(spellings[i][0], text, length)) {
            text = spellings[i][1];
            length = strlen(text);
        }
    for (const cli_option *o = program->options; o->name; o++)
        if (!is_heading(o) && is_name(o->name, text, length)) return o;
    return NULL;
}

/* What an option that does not exist means in other programs, as an option of this one; or null. */
static const char *meaning_of(const cli_program *program, const cli_guess *guess) {
    const char *use;
    for (int k = 0; (use = cli_guess_meaning(guess, k)); k++) {
        size_t length = strcspn(use, " ");
        if (option_named(program, use, length) || is_name("--help", use, length) ||
            is_name("--version", use, length))
            return use;
    }
    return NULL;
}

static _Noreturn void refuse_option(const cli_program *program, const char *text, size_t length) {
    cli_guess guess = cli_guess_begin(text, length);
    guess.name = meaning_of(program, &guess);
    if (!guess.name) {
        for (const cli_option *o = program->options; o->name; o++)
            if (!is_heading(o)) cli_guess_try(&guess, o->name);
        cli_guess_try(&guess, "--help");
        cli_guess_try(&guess, "--version");
    }
    if (text[1] != '-' && !guess.name)
        cli_fail(CLI_BAD_INPUT, "unknown option '%s'; an equation that begins with '-' needs -- before it",
                 cli_quote(text).text);
    cli_fail(CLI_BAD_INPUT, "unknown option '%s'; %s", cli_quote(text).text,
             guess.name ? cli_guess_text(&guess).text : "--help lists them");
}

/* One option, its value behind '=' or in the next argument; returns how many arguments it took. */
static int parse_option(const cli_program *program, char **argument, char *options) {
    const char *text = argument[0];
    size_t length = strcspn(text, "=");
    const cli_option *option = option_named(program, text, length);
    if (!option) refuse_option(program, text, length);
    const char *value = text[length] ? text + length + 1 : NULL;
    int taken = 1;
    if (!option->argument && value) cli_fail(CLI_BAD_INPUT, "%s: takes no value", option->name);
    if (option->argument && !value) {
        value = argument[1];
        taken = 2;
        if (!value || option_named(program, value, strlen(value)))
            cli_fail(CLI_BAD_INPUT, "%s: expected %s, got nothing", option->name, option->argument);
    }
    option->set(option, value, options + option->offset);
    return taken;
}

/* "-2" and "-.5x" are numbers or equations. */
static int is_plain(const char *text) {
    return text[0] != '-' || isdigit((unsigned char)text[1]) || text[1] == '.';
}

static int is_one_of(const char *text, const char *a, const char *b) {
    return strcmp(text, a) == 0 || strcmp(text, b) == 0;
}

int cli_parse_files(const cli_program *program, int argc, char **argv, void *options) {
    program_name = program->name;
    portable_binary_output();
    int plain_only = 0, files = 0;
    for (int i = 1; i < argc;) {
        const char *text = argv[i];
        if (plain_only || is_plain(text)) {
            argv[++files] = argv[i++];
        } else if (strcmp(text, "--") == 0) {
            plain_only = 1;
            i++;
        } else if (is_one_of(text, "--help", "-h")) {
            print_help(program);
        } else if (is_one_of(text, "--version", "-V")) {
            print_version(program);
        } else {
            i += parse_option(program, argv + i, options);
        }
    }
    return files;
}

void cli_parse(const cli_program *program, int argc, char **argv, void *options) {
    const char **name = (const char **)(void *)((char *)options + program->positional);
    int count = cli_parse_files(program, argc, argv, options);
    if (count > 1)
        cli_fail(CLI_BAD_INPUT,
                 "unexpected '%s': an equation with blanks needs quotes, a file --output, a value --let",
                 cli_quote(argv[2]).text);
    if (count > 0) *name = argv[1];
}

void cli_set_flag(const cli_option *option, const char *value, void *field) {
    (void)option;
    (void)value;
    *(int *)field = 1;
}

void cli_set_int(const cli_option *option, const char *value, void *field) {
    if (!cli_whole(value, option->low, option->high, field))
        cli_fail(CLI_BAD_INPUT, "%s: expected a whole number from %d to %d, got '%s'", option->name,
                 option->low, option->high, cli_quote(value).text);
}

void cli_set_text(const cli_option *option, const char *value, void *field) {
    (void)option;
    *(const char **)field = value;
}

void cli_set_vector(const cli_option *option, const char *value, void *field) {
    cli_vector vector = {.given = 1};
    if (!cli_numbers(value, ',', 3, vector.x)) cli_expected(option, value);
    *(cli_vector *)field = vector;
}

void cli_set_extent(const cli_option *option, const char *value, void *field) {
    cli_extent extent = {.given = 1};
    double *size = extent.extent.size;
    if (strncmp(value, "sphere:", 7) == 0 && cli_numbers(value + 7, ',', 1, size)) {
        extent.extent.kind = ALGSURF_EXTENT_SPHERE;
        if (!(size[0] > 0)) cli_expected(option, value);
    } else if (strncmp(value, "box:", 4) == 0 && cli_numbers(value + 4, ',', 3, size)) {
        extent.extent.kind = ALGSURF_EXTENT_BOX;
        if (!(size[0] > 0 && size[1] > 0 && size[2] > 0)) cli_expected(option, value);
    } else {
        cli_expected(option, value);
    }
    *(cli_extent *)field = extent;
}

void cli_set_clip(const cli_option *option, const char *value, void *field) {
    cli_planes *planes = field;
    double number[4];
    if (!cli_numbers(value, ',', 4, number)) cli_expected(option, value);
    if (number[0] == 0 && number[1] == 0 && number[2] == 0)
        cli_fail(CLI_BAD_INPUT, "%s: A, B and C are all 0: that is no plane", option->name);
    if (planes->count == ALGSURF_MAX_CLIP_PLANES)
        cli_fail(CLI_BAD_INPUT, "%s: there may be %d planes, not more", option->name,
                 ALGSURF_MAX_CLIP_PLANES);
    planes->plane[planes->count++] = (algsurf_plane){{number[0], number[1], number[2]}, number[3]};
}

int cli_choice(const cli_option *option, const char *value) {
    const char *word = option->argument;
    for (int i = 0;; i++) {
        size_t length = strcspn(word, "|");
        if (strlen(value) == length && strncmp(word, value, length) == 0) return i;
        if (!word[length]) cli_expected(option, value);
        word += length + 1;
    }
}

void cli_set_choice(const cli_option *option, const char *value, void *field) {
    *(int *)field = cli_choice(option, value);
}

void cli_set_method(const cli_option *option, const char *value, void *field) {
    static const int methods[] = {ALGSURF_METHOD_DEFAULT, ALGSURF_METHOD_BRENT, ALGSURF_METHOD_BISECTION,
                                  ALGSURF_METHOD_REGULA_FALSI};
    *(int *)field = methods[cli_choice(option, value)];
}

void cli_set_tier(const cli_option *option, const char *value, void *field) {
    static const int tiers[] = {ALGSURF_TIER_CERTIFIED, ALGSURF_TIER_BOUNDED};
    *(int *)field = tiers[cli_choice(option, value)];
}

void cli_set_tolerance(const cli_option *option, const char *value, void *field) {
    double tolerance;
    if (!cli_numbers(value, ',', 1, &tolerance) || tolerance < 0)
        cli_fail(CLI_BAD_INPUT, "%s: expected a number, 0 or above, got '%s'", option->name,
                 cli_quote(value).text);
    *(double *)field = tolerance;
}
