/* intersect.c - meets rays with an algebraic surface: intersect --help. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"

typedef struct intersect_options {
    cli_surface surface;
    cli_extent extent;
    cli_vector centre;
    int all;
    algsurf_intersect_options how;
} intersect_options;

#define FIELD(member) offsetof(intersect_options, member), 0, 0

static const cli_option options_table[] = {
    CLI_SURFACE_OPTIONS(intersect_options),
    {"--all", NULL, "every hit of a ray, a row each; otherwise the first", cli_set_flag, FIELD(all)},
    {"--extent", "sphere:R|box:X,Y,Z", "only hits in there count (half sizes); default: all of space",
     cli_set_extent, FIELD(extent)},
    {"--centre", "X,Y,Z", "the centre of the extent, default 0,0,0", cli_set_vector, FIELD(centre)},
    {"--method", "default|brent|bisection|regula-falsi", "how an isolated root is refined", cli_set_method,
     FIELD(how.method)},
    {"--tolerance", "EPS", "wanted error of t, default 0: all a double can tell", cli_set_tolerance,
     FIELD(how.tolerance)},
    {"--tier", "fast|standard", "signs as computed; signs beyond their error bounds (default)",
     cli_set_tier, FIELD(how.tier)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    "intersect", "[options] (NAME | --equation TEXT | --terms FILE)",
    "Reads rays from standard input, a line \"ox oy oz dx dy dz t_min t_max\" each, decimal or\n"
    "hexadecimal, inf allowed for t_min and t_max; '#' starts a comment.  Prints a table with the\n"
    "columns line, state (hit, miss, uncertain, error), t, t_lo, t_hi, x, y, z, nx, ny, nz: t_lo..t_hi\n"
    "holds the hit (for uncertain: no hit lies before t_lo), x y z is the point, nx ny nz the unit\n"
    "normal, and what does not exist is '-'.  NAME is one of those that render --list shows.",
    options_table, offsetof(intersect_options, surface.name)};

/* What every line needs. */
typedef struct run {
    const algsurf_surface *surface;
    const algsurf_extent *extent; /* null: all of space */
    const algsurf_intersect_options *how;
    int all;
    algsurf_hit *hits;
    int capacity;
    int bad_lines;
} run;

static void print_absent(int columns) {
    while (columns-- > 0) fputs("\t-", stdout);
}

static void print_numbers(const double *values, int count) {
    for (int i = 0; i < count; i++) printf("\t%.17g", values[i]);
}

static void print_hit(const run *r, size_t line, const algsurf_hit *hit) {
    printf("%zu\t%s", line, hit->state == ALGSURF_HIT ? "hit" : "uncertain");
    print_numbers(&hit->t, 1);
    if (r->how->tier == ALGSURF_TIER_FAST) {
        print_absent(2);
    } else {
        print_numbers(&hit->t_lo, 1);
        print_numbers(&hit->t_hi, 1);
    }
    print_numbers(hit->position, 3);
    const double *n = hit->normal;
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) print_absent(3);
    else print_numbers(n, 3);
    putchar('\n');
}

static void print_empty(size_t line, const char *state) {
    printf("%zu\t%s", line, state);
    print_absent(9);
    putchar('\n');
}

/* Returns null, or what is wrong with the ray. */
static const char *parse_ray(char **field, algsurf_ray *ray) {
    double *to[8] = {&ray->origin[0],    &ray->origin[1],    &ray->origin[2], &ray->direction[0],
                     &ray->direction[1], &ray->direction[2], &ray->t_min,     &ray->t_max};
    for (int i = 0; i < 8; i++) {
        if (!cli_number(field[i], to[i])) return "is no number";
        if (isnan(*to[i])) return "is not a number to count with";
        if (i < 6 && isinf(*to[i])) return "is not finite";
        field[0] = field[i < 7 ? i + 1 : 7];
    }
    return NULL;
}

static void complain(run *r, size_t line) {
    r->bad_lines++;
    print_empty(line, "error");
}
