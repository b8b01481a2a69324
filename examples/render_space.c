/* render_space.c - see render_space.h. */
#include "render_space.h"

#include <math.h>
#include <string.h>

#include "cli_equation.h"

static const double PI = 3.14159265358979323846;
static const double REAL_DELTA =
    1e-10; /* radians: positive real roots only, their argument being exactly 0 */

/* The text up to a separator, copied; returns what stands behind it, null when it is missing or too far. */
static const char *cut(const char *text, const char *separator, char part[64]) {
    const char *at = strstr(text, separator);
    if (!at || at - text >= 64) return NULL;
    memcpy(part, text, (size_t)(at - text));
    part[at - text] = '\0';
    return at + strlen(separator);
}

/* Radians, 0 or above: a number, or a multiple of pi, "7pi/18". */
static int angle(const char *text, double *value) {
    char part[64];
    double times = 1, over = 1;
    const char *rest = cut(text, "pi", part);
    if (!rest) return cli_numbers(text, ',', 1, value) && *value >= 0;
    if (*part && !cli_numbers(part, ',', 1, &times)) return 0;
    if (*rest && (*rest != '/' || !cli_numbers(rest + 1, ',', 1, &over))) return 0;
    *value = times * PI / over;
    return isfinite(*value) && *value >= 0;
}

static double angle_of(const cli_option *option, const char *value) {
    double x;
    if (!angle(value, &x))
        cli_fail(CLI_BAD_INPUT, "%s: expected radians, 0 or above, as 0.2 or 7pi/18, got '%s'", option->name,
                 cli_quote(value).text);
    return x;
}

void render_set_sigma(const cli_option *option, const char *value, void *field) {
    render_space *space = field;
    space->sector.sigma = angle_of(option, value);
    space->sigma = option->name;
}

void render_set_delta(const cli_option *option, const char *value, void *field) {
    render_space *space = field;
    space->sector.delta = angle_of(option, value);
    space->delta = option->name;
}

void render_set_imaginary(const cli_option *option, const char *value, void *field) {
    render_space *space = field;
    char part[64];
    int k;
    double x;
    const char *rest = cut(value, "=", part);
    if (!rest || !cli_whole(part, 0, ALGSURF_MAX_DEGREE, &k) || !cli_numbers(rest, ',', 1, &x))
        cli_fail(CLI_BAD_INPUT, "%s: expected K=V, K from 0 to the degree, V a number, got '%s'",
                 option->name, cli_quote(value).text);
    if (space->imaginary_given[k])
        cli_fail(CLI_BAD_INPUT, "%s: coefficient %d is given twice", option->name, k);
    space->imaginary_given[k] = 1;
    space->imaginary[k] = x;
}

void render_set_coherence(const cli_option *option, const char *value, void *field) {
    static const algsurf_coherence coherences[] = {ALGSURF_COHERENCE_NONE, ALGSURF_COHERENCE_NEIGHBOURS};
    render_space *space = field;
    space->coherence = coherences[cli_choice(option, value)];
    space->coherent = option->name;
}

static int read_sweep(const char *value, render_sweep *sweep) {
    char part[64];
    const char *rest = cut(value, ":", part);
    *sweep = (render_sweep){.kind = SWEEP_TURN};
    if (!rest) return 0;
    if (strcmp(part, "turn") == 0) return cli_whole(rest, 1, RENDER_MOST_PICTURES, &sweep->pictures);
    sweep->kind = strcmp(part, "imag") == 0 ? SWEEP_IMAG : strcmp(part, "let") == 0 ? SWEEP_LET : SWEEP_DELTA;
    if (sweep->kind == SWEEP_DELTA && strcmp(part, "delta") != 0) return 0;
    if (sweep->kind == SWEEP_LET &&
        (!(rest = cut(rest, ":", sweep->name)) || !cli_is_constant_name(sweep->name)))
        return 0;
    if (sweep->kind == SWEEP_IMAG &&
        (!(rest = cut(rest, ":", part)) || !cli_whole(part, 0, ALGSURF_MAX_DEGREE, &sweep->k)))
        return 0;
    for (double *end = &sweep->from; end; end = end == &sweep->from ? &sweep->to : NULL) {
        if (!(rest = cut(rest, ":", part))) return 0;
        if (!(sweep->kind == SWEEP_DELTA ? angle(part, end) : cli_numbers(part, ',', 1, end))) return 0;
    }
    return cli_whole(rest, 1, RENDER_MOST_PICTURES, &sweep->pictures);
}

void render_set_sweep(const cli_option *option, const char *value, void *field) {
    if (!read_sweep(value, field))
        cli_fail(CLI_BAD_INPUT,
                 "%s: expected turn:N, let:NAME:A:B:N, delta:A:B:N or imag:K:A:B:N, N from 1 to %d, got '%s'",
                 option->name, RENDER_MOST_PICTURES, cli_quote(value).text);
}

void render_check_space(render_space *space, const render_sweep *sweep) {
    int imaginary = sweep->kind == SWEEP_IMAG;
    for (int k = 0; k <= ALGSURF_MAX_DEGREE; k++) imaginary |= space->imaginary_given[k];
    space->is_complex = space->sigma || space->delta || imaginary || sweep->kind == SWEEP_DELTA;
    if (!space->is_complex && space->coherent)
        cli_fail(CLI_BAD_INPUT, "%s: has no effect in real space", space->coherent);
    if (!space->is_complex) return;
    if (space->real_only) cli_fail(CLI_BAD_INPUT, "%s: has no effect in complex space", space->real_only);
    if (sweep->kind == SWEEP_DELTA && space->delta)
        cli_fail(CLI_BAD_INPUT, "--sweep: sets delta; leave %s out", space->delta);
    if (sweep->kind == SWEEP_IMAG && space->imaginary_given[sweep->k])
        cli_fail(CLI_BAD_INPUT, "--sweep: sets coefficient %d; leave its --imag out", sweep->k);
    if (!space->delta) space->sector.delta = REAL_DELTA;
    double widest = sweep->kind == SWEEP_DELTA ? fmax(sweep->from, sweep->to) : space->sector.delta;
    if (space->sector.sigma + widest > nextafter(PI, 4)) /* algsurf_sector: pi, rounded up */
        cli_fail(CLI_BAD_INPUT, "--sigma, --delta: their sum is above pi");
}

void render_check_degree(const render_space *space, const render_sweep *sweep, int degree) {
    for (int k = degree + 1; k <= ALGSURF_MAX_DEGREE; k++)
        if (space->imaginary_given[k] || (sweep->kind == SWEEP_IMAG && sweep->k == k))
            cli_fail(CLI_BAD_INPUT, "%s: no coefficient %d, the surface has degree %d",
                     space->imaginary_given[k] ? "--imag" : "--sweep", k, degree);
}

double render_sweep_value(const render_sweep *sweep, int picture) {
    double share = sweep->pictures > 1 ? (double)picture / (sweep->pictures - 1) : 0;
    return (1 - share) * sweep->from + share * sweep->to;
}

algsurf_complex_space render_space_of(const render_space *space, const render_sweep *sweep, int picture,
                                      double imaginary[ALGSURF_MAX_DEGREE + 1]) {
    algsurf_complex_space of = {.size = sizeof of,
                                .sector = space->sector,
                                .imaginary = imaginary,
                                .imaginary_count = ALGSURF_MAX_DEGREE + 1};
    const double value = render_sweep_value(sweep, picture);
    memcpy(imaginary, space->imaginary, sizeof space->imaginary);
    if (sweep->kind == SWEEP_DELTA) of.sector.delta = value;
    if (sweep->kind == SWEEP_IMAG) imaginary[sweep->k] = value;
    return of;
}
