/* cli_surface.c - see cli_surface.h.
 *
 * Constants are evaluated by the library's own parser: a is the constant term of x = TEXT.
 */
#include "cli_surface.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "catalogue.h"
#include "cli_guess.h"
#include "terms_file.h"

/* ---- options ---- */

/* Does the library take constants of these names?  Not when one is no name, or both are the same. */
static int are_constant_names(const char *a, const char *b) {
    const algsurf_constant constants[] = {{a, 1}, {b, 1}};
    algsurf_surface *surface = NULL;
    algsurf_status status = algsurf_surface_from_equation("x", constants, b ? 2 : 1, &surface, NULL);
    algsurf_surface_free(surface);
    return status != ALGSURF_E_ARGUMENT;
}

int cli_is_constant_name(const char *name) { return are_constant_names(name, NULL); }

static char *copy_of(const char *text, size_t length) {
    char *copy = malloc(length + 1);
    if (!copy) cli_no_memory();
    memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}

/* Are these the same, with a Greek letter as itself in one, as a command of LaTeX in the other? */
static int is_same_name(const char *a, const char *b) {
    return cli_is_constant_name(a) && cli_is_constant_name(b) && !are_constant_names(a, b);
}

static int has_let(const cli_surface *surface, const char *name) {
    for (size_t i = 0; i < surface->let_count; i++)
        if (is_same_name(surface->lets[i].name, name)) return 1;
    return 0;
}

/* Takes name and value over. */
static void add_let(cli_surface *surface, const char *what, char *name, char *value, int from_file) {
    cli_let *lets = realloc(surface->lets, (surface->let_count + 1) * sizeof *lets);
    if (!lets) cli_no_memory();
    surface->lets = lets;
    if (!cli_is_constant_name(name))
        cli_fail(CLI_BAD_INPUT,
                 "%s: a constant's name has letters and digits, and is not x, y, z or sqrt; got '%s'", what,
                 cli_quote(name).text);
    lets[surface->let_count++] = (cli_let){name, value, from_file};
}

/* "A=VALUE", of `length` characters. */
static void set_one_let(const cli_option *option, const char *text, size_t length, cli_surface *surface) {
    size_t sign = strcspn(text, "=");
    if (sign + 1 >= length) cli_expected(option, text);
    char *name = copy_of(text, sign);
    if (has_let(surface, name))
        cli_fail(CLI_BAD_INPUT, "%s: '%s' is given twice", option->name, cli_quote(name).text);
    add_let(surface, option->name, name, copy_of(text + sign + 1, length - sign - 1), 0);
}

/* One or several, "a=1,b=2": a comma with another '=' behind it ends a value. */
void cli_set_let(const cli_option *option, const char *value, void *field) {
    size_t length = strlen(value);
    for (const char *comma = strchr(value, ','); comma; comma = strchr(value, ',')) {
        if (!strchr(comma, '=')) break;
        set_one_let(option, value, (size_t)(comma - value), field);
        value = comma + 1;
        length = strlen(value);
    }
    set_one_let(option, value, length, field);
}

/* Several words, of letters only and each longer than a letter: a name of a surface, with blanks. */
static int are_words(const char *text) {
    size_t words = 0;
    for (const char *word = text + strspn(text, " "); *word; words++) {
        size_t letters = 0;
        while (isalpha((unsigned char)word[letters]) || word[letters] == '-') letters++;
        if (letters < 2 || (word[letters] && word[letters] != ' ')) return 0;
        word += letters;
        word += strspn(word, " ");
    }
    return words > 1;
}

/* Signs that no name has, or a text that is an equation as it stands, "xyz", or with constants, "kxy". */
static int is_equation(const char *text, int has_constants) {
    if (!are_words(text) && (strpbrk(text, "=^+*/()[]{}|<>!,;\\$ ") || isdigit((unsigned char)text[0])))
        return 1;
    for (const char *c = text; *c; c++)
        if ((unsigned char)*c >= 0x80) return 1;
    algsurf_surface *surface = NULL;
    algsurf_status status = algsurf_surface_from_equation(text, NULL, 0, &surface, NULL);
    algsurf_surface_free(surface);
    return status == ALGSURF_OK || status == ALGSURF_E_ZERO || (status == ALGSURF_E_NAME && has_constants);
}

/* Equation and parameters of a file of SURFER; those that --let gives come before. */
static void read_jsurf(cli_surface *choice) {
    const char *path = choice->name;
    FILE *file = fopen(path, "rb");
    jsurf_file *read = malloc(sizeof *read);
    jsurf_error error;
    if (!read) cli_no_memory();
    choice->file = read;
    choice->path = path;
    if (!file) cli_fail(CLI_BAD_INPUT, "%s: %s", cli_quote(path).text, strerror(errno));
    if (jsurf_read(file, read, &error) != 0) {
        if (error.no_memory) cli_no_memory();
        if (error.line == 0) cli_fail(CLI_BAD_INPUT, "%s: %s", cli_quote(path).text, error.message);
        cli_fail(CLI_BAD_INPUT, "%s: line %zu: %s", cli_quote(path).text, error.line, error.message);
    }
    fclose(file);
    for (size_t i = 0; i < read->parameter_count; i++) {
        const jsurf_parameter *p = &read->parameters[i];
        if (!has_let(choice, p->name))
            add_let(choice, path, copy_of(p->name, strlen(p->name)), copy_of(p->value, strlen(p->value)), 1);
    }
    choice->equation = read->equation;
}

/* Ends the program when it is the name of a file: there is one, or it has such an ending. */
static void refuse_file(const char *text) {
    const char *ending = strrchr(text, '.');
    size_t length = ending ? strlen(ending + 1) : 0;
    int is_file =
        length >= 2 && length <= 5 && isalpha((unsigned char)ending[1]) && !strpbrk(text, "=^*+(){}[]|;$ ");
    FILE *file = fopen(text, "rb");
    if (file) is_file = 1, fclose(file);
    algsurf_surface *surface = NULL;
    int is_equation = is_file && algsurf_surface_from_equation(text, NULL, 0, &surface, NULL) == ALGSURF_OK;
    algsurf_surface_free(surface);
    if (is_file && !is_equation)
        cli_fail(CLI_BAD_INPUT, "%s: not a file of SURFER, name.jsurf; a file of terms is read by --terms",
                 cli_quote(text).text);
}

void cli_settle_surface(cli_surface *choice) {
    choice->path = choice->terms;
    if (!choice->name || catalogue_find(choice->name)) return;
    if (jsurf_is_name(choice->name) && !choice->equation && !choice->terms) {
        read_jsurf(choice);
        choice->name = NULL;
        return;
    }
    if (!choice->equation && !choice->terms) refuse_file(choice->name);
    if (!is_equation(choice->name, choice->let_count > 0)) return;
    if (choice->equation)
        cli_fail(CLI_BAD_INPUT, "two equations: --equation, and '%s'", cli_quote(choice->name).text);
    choice->equation = choice->name;
    choice->name = NULL;
}

void cli_forget_surface(cli_surface *choice) {
    for (size_t i = 0; i < choice->let_count; i++) {
        free(choice->lets[i].name);
        free(choice->lets[i].value);
    }
    free(choice->lets);
    if (choice->file) jsurf_release(choice->file);
    free(choice->file);
    choice->file = NULL;
    choice->lets = NULL;
    choice->let_count = 0;
}

/* ---- equations and constants ---- */

/* Values of constants, and sums with x, y, z that have names; all names belong to the options. */
typedef struct values {
    algsurf_constant *all;
    size_t count;
    const cli_let **sums;
    size_t sum_count;
} values;

static values make_values(size_t count) {
    values made = {calloc(count + 1, sizeof *made.all), 0, calloc(count + 1, sizeof *made.sums), 0};
    if (!made.all || !made.sums) cli_no_memory();
    return made;
}

static void free_values(values *known) {
    free(known->all);
    free(known->sums);
}

/* The text behind the definitions of the sums, as the library takes them; to be freed. */
static char *with_sums(const values *known, const char *text) {
    size_t length = strlen(text) + 1, at = 0;
    for (size_t i = 0; i < known->sum_count; i++)
        length += strlen(known->sums[i]->name) + strlen(known->sums[i]->value) + strlen("=;");
    char *whole = malloc(length);
    if (!whole) cli_no_memory();
    for (size_t i = 0; i < known->sum_count; i++)
        at +=
            (size_t)snprintf(whole + at, length - at, "%s=%s;", known->sums[i]->name, known->sums[i]->value);
    memcpy(whole + at, text, length - at);
    return whole;
}

static algsurf_status read_equation(const values *known, const char *text, algsurf_surface **surface) {
    char *whole = with_sums(known, text);
    algsurf_status status = algsurf_surface_from_equation(whole, known->all, known->count, surface, NULL);
    free(whole);
    return status;
}

enum { MOST_NAMES = 6 }; /* without a value, told at once */

static const double EULER = 2.718281828459045;

/* Is the name, of `length` bytes, the letter that e^x is written with? */
static int is_euler(const char *name, size_t length) { return length == 1 && *name == 'e'; }

/* With Euler's number for e, as people mean it: what is wrong then; ALGSURF_OK for another name. */
static algsurf_status try_euler(const values *known, const char *text, algsurf_parse_error *error) {
    if (!is_euler(text + error->offset, error->length)) return ALGSURF_OK;
    algsurf_constant *all = calloc(known->count + 1, sizeof *all);
    algsurf_surface *surface = NULL;
    if (!all) cli_no_memory();
    for (size_t i = 0; i < known->count; i++) all[i] = known->all[i];
    all[known->count] = (algsurf_constant){"e", EULER};
    algsurf_status status = algsurf_surface_from_equation(text, all, known->count + 1, &surface, error);
    algsurf_surface_free(surface);
    free(all);
    return status;
}

/* Says which names have no value yet: one after the other, those before given one. */
static _Noreturn void ask_for_values(const values *known, const char *text, const char *shown, size_t skipped,
                                     const algsurf_parse_error *first) {
    algsurf_constant *all = calloc(known->count + MOST_NAMES, sizeof *all);
    char names[MOST_NAMES][32], list[256] = "", fix[256] = "";
    algsurf_parse_error error = *first;
    algsurf_surface *surface = NULL;
    algsurf_status status = ALGSURF_E_NAME;
    size_t n = 0;
    if (!all) cli_no_memory();
    for (size_t i = 0; i < known->count; i++) all[i] = known->all[i];
    for (; status == ALGSURF_E_NAME && n < MOST_NAMES && error.length < sizeof names[0]; n++) {
        size_t length = strlen(list), used = strlen(fix);
        snprintf(names[n], sizeof names[n], "%.*s", (int)error.length, text + error.offset);
        snprintf(list + length, sizeof list - length, "%s%s", n ? ", " : "", names[n]);
        const char *quote = names[n][0] == '\\' ? "'" : ""; /* from the shell */
        snprintf(fix + used, sizeof fix - used, " --let %s%s=%s%s", quote, names[n],
                 is_euler(names[n], error.length) ? "2.718281828459045" : "...", quote);
        all[known->count + n] = (algsurf_constant){names[n], 1.5};
        status = algsurf_surface_from_equation(text, all, known->count + n + 1, &surface, &error);
    }
    algsurf_surface_free(surface);
    free(all);
    if (n == 0)
        cli_fail_in(shown, first->offset - skipped, first->length,
                    "column %zu: this name has no value; see --let",
                    cli_column(shown, first->offset - skipped));
    cli_fail_in(shown, first->offset - skipped, first->length, "%s: give %s:%s", list,
                n == 1 ? "it a value" : "them values", fix);
}

/* The word, a name or a command of LaTeX, at the start of text; "" for a letter, a number or a sign. */
static cli_quoted word_at(const char *text, size_t length) {
    cli_quoted word = {""};
    if (length < 2 || !(isalpha((unsigned char)*text) || *text == '\\')) return word;
    char *copy = copy_of(text, length);
    word = cli_quote(copy);
    free(copy);
    return word;
}

/* Says why text, of which the first `skipped` bytes are not the user's, is no equation. */
static _Noreturn void refuse_equation(const values *known, const char *what, const char *text, size_t skipped,
                                      algsurf_status status, const algsurf_parse_error *error) {
    const char *shown = text + skipped;
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (!error->message) cli_fail(CLI_BAD_INPUT, "%s: %s", what, algsurf_status_text(status));
    algsurf_parse_error at = *error;
    if (status == ALGSURF_E_NAME && try_euler(known, text, &at) != ALGSURF_E_SYNTAX)
        ask_for_values(known, text, shown, skipped, error);
    cli_quoted name = word_at(text + at.offset, at.length);
    cli_fail_in(shown, at.offset - skipped, at.length, "%s: column %zu: %s%s%s", what,
                cli_column(shown, at.offset - skipped), name.text, *name.text ? ": " : "", at.message);
}

/* Null for a text that holds at every point; skipped: not the user's. */
static algsurf_surface *parse(const values *known, const char *what, const char *text, size_t skipped) {
    algsurf_surface *surface = NULL;
    algsurf_parse_error error = {0, 0, NULL};
    char *whole = with_sums(known, text);
    algsurf_status status = algsurf_surface_from_equation(whole, known->all, known->count, &surface, &error);
    if (status != ALGSURF_OK && status != ALGSURF_E_ZERO)
        refuse_equation(known, what, whole, strlen(whole) - strlen(text) + skipped, status, &error);
    free(whole);
    return surface;
}

static const char PLANE[] = "x="; /* x minus a constant is a plane, whatever the constant */

/* The equation of such a plane, to be freed. */
static char *as_plane(const char *value) {
    char *text = malloc(sizeof PLANE + strlen(value));
    if (!text) cli_no_memory();
    return strcat(strcpy(text, PLANE), value);
}

/* One value more: a constant, or a sum with x, y, z. */
static void add_value(values *known, const cli_let *let) {
    char *text = as_plane(let->value), what[64];
    snprintf(what, sizeof what, "--let %.40s", let->name);
    if (strchr(let->value, ';')) cli_fail(CLI_BAD_INPUT, "%s: expected one value, without ';'", what);
    algsurf_surface *plane = parse(known, what, text, strlen(PLANE));
    algsurf_term terms[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    size_t count = algsurf_surface_term_count(plane);
    int is_plane = plane && count <= 2 && algsurf_surface_terms(plane, terms) == ALGSURF_OK &&
                   terms[0].i == 1 && terms[0].a == 1 && algsurf_surface_degree(plane) == 1 &&
                   terms[1].i == 0 && terms[1].j == 0 && terms[1].k == 0;
    algsurf_surface_free(plane);
    free(text);
    if (is_plane) {
        known->all[known->count++] = (algsurf_constant){let->name, count == 2 ? -terms[1].a : 0};
    } else if (let->name[strspn(let->name, "xyzXYZ")] == '\0') {
        cli_fail(CLI_BAD_INPUT, "%s: expected a constant; what has x, y or z needs another name", what);
    } else {
        known->sums[known->sum_count++] = let;
    }
}

/* ---- constants that nothing depends on ---- */

static int have_equal_terms(const algsurf_surface *a, const algsurf_surface *b) {
    size_t count = algsurf_surface_term_count(a);
    if (count != algsurf_surface_term_count(b)) return 0;
    algsurf_term *terms = calloc(2 * count + 1, sizeof *terms);
    if (!terms) cli_no_memory();
    int equal = algsurf_surface_terms(a, terms) == ALGSURF_OK &&
                algsurf_surface_terms(b, terms + count) == ALGSURF_OK;
    for (size_t i = 0; i < count && equal; i++) {
        const algsurf_term *s = &terms[i], *t = &terms[count + i];
        equal = s->i == t->i && s->j == t->j && s->k == t->k && s->a == t->a;
    }
    free(terms);
    return equal;
}

/* Does the text, an equation, read otherwise without that constant? */
static int depends_on(const values *known, const char *text, const char *name) {
    values others = make_values(known->count + known->sum_count);
    algsurf_surface *with = NULL, *without = NULL;
    for (size_t i = 0; i < known->count; i++)
        if (strcmp(known->all[i].name, name) != 0) others.all[others.count++] = known->all[i];
    for (size_t i = 0; i < known->sum_count; i++)
        if (strcmp(known->sums[i]->name, name) != 0) others.sums[others.sum_count++] = known->sums[i];
    algsurf_status is = read_equation(known, text, &with), was = read_equation(&others, text, &without);
    int depends = is != was || (is == ALGSURF_OK && !have_equal_terms(with, without));
    algsurf_surface_free(with);
    algsurf_surface_free(without);
    free_values(&others);
    return depends;
}

/* Is it in the equation, or in the value of another constant? */
static int is_used(const cli_surface *choice, const values *known, const char *name) {
    if (depends_on(known, choice->equation, name)) return 1;
    for (size_t i = 0; i < choice->let_count; i++) {
        char *text = as_plane(choice->lets[i].value);
        int depends = depends_on(known, text, name);
        free(text);
        if (depends) return 1;
    }
    return 0;
}

/* Ends the program when a constant plays no part: it is a slip.  Files of SURFER may have such ones. */
static void check_used(const cli_surface *choice, const values *known, const char *swept) {
    if (swept && !is_used(choice, known, swept)) cli_fail(CLI_BAD_INPUT, "%s: not in the equation", swept);
    for (size_t i = 0; i < choice->let_count; i++) {
        const cli_let *let = &choice->lets[i];
        if (!let->from_file && !is_used(choice, known, let->name))
            cli_fail(CLI_BAD_INPUT, "%s: not in the equation", let->name);
    }
}

/* The constants of the options, and one more before them if its name is not null. */
static values evaluate(const cli_surface *choice, const char *name, double value) {
    values known = make_values(choice->let_count + 1);
    if (name) known.all[known.count++] = (algsurf_constant){name, value};
    for (size_t i = 0; i < choice->let_count; i++) {
        const cli_let *let = &choice->lets[i];
        if (name && let->from_file && is_same_name(let->name, name)) continue;
        add_value(&known, let);
    }
    return known;
}

/* The surface with what rounding its coefficients may have changed. */
static algsurf_surface *with_rounding(algsurf_surface *exact) {
    algsurf_surface *surface = NULL;
    algsurf_status status = algsurf_surface_with_error(exact, algsurf_surface_rounding(exact), &surface);
    algsurf_surface_free(exact);
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (status != ALGSURF_OK)
        cli_fail(CLI_BAD_INPUT, "--coefficients rounded: a coefficient is too small for a double");
    return surface;
}

static algsurf_surface *from_equation(const cli_surface *choice, const char *text, const char *name,
                                      double value) {
    values known = evaluate(choice, name, value);
    algsurf_surface *surface = parse(&known, "equation", text, 0);
    if (!surface)
        cli_fail(CLI_BAD_INPUT,
                 "equation: it holds at every point, whatever x, y and z are: that is no surface");
    if (choice->equation) check_used(choice, &known, name);
    free_values(&known);
    return choice->rounded ? with_rounding(surface) : surface;
}

static algsurf_surface *from_terms(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file) cli_fail(CLI_BAD_INPUT, "--terms: %s: %s", cli_quote(path).text, strerror(errno));
    algsurf_surface *surface = NULL;
    terms_error error;
    if (terms_read_surface(file, &surface, &error) != 0) {
        if (error.no_memory) cli_no_memory();
        if (error.line == 0) cli_fail(CLI_BAD_INPUT, "--terms: %s: %s", cli_quote(path).text, error.message);
        cli_fail(CLI_BAD_INPUT, "--terms: %s: line %zu: %s", cli_quote(path).text, error.line, error.message);
    }
    fclose(file);
    return surface;
}

static const catalogue_entry *named(const char *name) {
    const catalogue_entry *entry = catalogue_find(name);
    if (entry) return entry;
    cli_guess guess = cli_guess_begin(name, strlen(name));
    for (entry = catalogue; entry->name; entry++) cli_guess_try(&guess, entry->name);
    cli_fail(CLI_BAD_INPUT, "unknown surface '%s'; %s", cli_quote(name).text,
             guess.name ? cli_guess_text(&guess).text : "render --list shows the names, --help the options");
}

algsurf_surface *cli_make_surface_with(const cli_surface *choice, const char *name, double value) {
    int chosen = (choice->name != NULL) + (choice->equation != NULL) + (choice->terms != NULL);
    if (chosen != 1)
        cli_fail(CLI_BAD_INPUT, "expected %s a NAME, an equation, --terms FILE; see --help",
                 chosen ? "only one of" : "a surface:");
    if (choice->let_count > 0 && !choice->equation)
        cli_fail(CLI_BAD_INPUT, "--let: only an equation has letters that take values");
    if (choice->rounded && choice->terms)
        cli_fail(CLI_BAD_INPUT, "--coefficients: has no effect with --terms, whose numbers are doubles");
    if (choice->terms) return from_terms(choice->terms);
    return from_equation(choice, choice->equation ? choice->equation : named(choice->name)->equation, name,
                         value);
}

algsurf_surface *cli_make_surface(const cli_surface *choice) {
    return cli_make_surface_with(choice, NULL, 0);
}
