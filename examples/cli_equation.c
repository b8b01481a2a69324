/* cli_equation.c - see cli_equation.h.
 *
 * Constants are evaluated by the library's own parser: a is the constant term of x = TEXT.
 */
#include "cli_equation.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- names ---- */

/* Does the library take constants of these names?  Not when one is no name, or both are the same. */
static int are_constant_names(const char *a, const char *b) {
    const algsurf_constant constants[] = {{a, 1}, {b, 1}};
    algsurf_surface *surface = NULL;
    algsurf_status status = algsurf_surface_from_equation("x", constants, b ? 2 : 1, &surface, NULL);
    algsurf_surface_free(surface);
    return status != ALGSURF_E_ARGUMENT;
}

int cli_is_constant_name(const char *name) { return are_constant_names(name, NULL); }

int cli_is_same_name(const char *a, const char *b) {
    return cli_is_constant_name(a) && cli_is_constant_name(b) && !are_constant_names(a, b);
}

/* ---- equations and values ---- */

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

/* The text behind the definitions of the sums, as the library takes them; to be freed.  Of a blank text, the
 * last of them would be the equation. */
static char *with_sums(const values *known, const char *text) {
    size_t count = text[strspn(text, " \t\n\v\f\r")] ? known->sum_count : 0;
    size_t length = strlen(text) + 1, at = 0;
    for (size_t i = 0; i < count; i++)
        length += strlen(known->sums[i]->name) + strlen(known->sums[i]->value) + strlen("=;");
    char *whole = malloc(length);
    if (!whole) cli_no_memory();
    for (size_t i = 0; i < count; i++)
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
    char *copy = cli_copy(text, length);
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
    if (error->offset < skipped) cli_fail(CLI_BAD_INPUT, "%s: nothing but blanks", what); /* of typesetters */
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
        plane = NULL;
        if (read_equation(known, "x", &plane) == ALGSURF_E_SYNTAX)
            cli_fail(CLI_BAD_INPUT, "%s: expected a sum, without '.' or ',' at its end", what);
        algsurf_surface_free(plane);
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
        if (name && let->from_file && cli_is_same_name(let->name, name)) continue;
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

algsurf_surface *cli_read_equation(const cli_surface *choice, const char *text, const char *name,
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
