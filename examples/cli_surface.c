/* cli_surface.c - see cli_surface.h. */
#include "cli_surface.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "catalogue.h"
#include "cli_equation.h"
#include "cli_guess.h"
#include "terms_file.h"

/* ---- options ---- */

static int has_let(const cli_surface *surface, const char *name) {
    for (size_t i = 0; i < surface->let_count; i++)
        if (cli_is_same_name(surface->lets[i].name, name)) return 1;
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
    char *name = cli_copy(text, sign);
    if (has_let(surface, name))
        cli_fail(CLI_BAD_INPUT, "%s: '%s' is given twice", option->name, cli_quote(name).text);
    add_let(surface, option->name, name, cli_copy(text + sign + 1, length - sign - 1), 0);
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
            add_let(choice, path, cli_copy(p->name, strlen(p->name)), cli_copy(p->value, strlen(p->value)), 1);
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

/* ---- the surface ---- */

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
    return cli_read_equation(choice, choice->equation ? choice->equation : named(choice->name)->equation, name,
                         value);
}

algsurf_surface *cli_make_surface(const cli_surface *choice) {
    return cli_make_surface_with(choice, NULL, 0);
}
