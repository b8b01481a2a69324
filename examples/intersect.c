/* intersect.c - meets rays with an algebraic surface: intersect --help. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli_surface.h"
#include "progress.h"
#include "table.h"

typedef struct intersect_options {
    cli_surface surface;
    cli_extent extent;
    cli_vector centre;
    cli_planes clip;
    int all, json;
    algsurf_intersect_options how;
} intersect_options;

#define FIELD(member) offsetof(intersect_options, member), 0, 0

static const cli_option options_table[] = {
    CLI_SURFACE_OPTIONS(intersect_options),
    {"--all", NULL, "prints every hit of a ray, a row each; without this option only the first one",
     cli_set_flag, FIELD(all)},
    {"--extent", "sphere:R|box:X,Y,Z",
     "only hits in a ball of radius R count, or in a box from -X,-Y,-Z to X,Y,Z; default:\nall of space",
     cli_set_extent, FIELD(extent)},
    {"--centre", "X,Y,Z", "the centre of that ball or box, default 0,0,0", cli_set_vector, FIELD(centre)},
    {"--clip", "A,B,C,D", "only hits with A x + B y + C z <= D; may be given up to 8 times", cli_set_clip,
     FIELD(clip)},
    {"--method", "default|brent|bisection|regula-falsi",
     "how a root is computed when an interval is found that holds it alone; default: the\nfastest way",
     cli_set_method, FIELD(how.method)},
    {"--tolerance", "EPS", "how much t may be wrong, default 0: as little as doubles can", cli_set_tolerance,
     FIELD(how.absolute_tolerance)},
    {"--tier", "certified|bounded",
     "certified (default): every ray is decided, by integers where doubles do not\n"
     "suffice.  bounded: by doubles alone; what they leave open is undecided",
     cli_set_tier, FIELD(how.tier)},
    {"--format", "tsv|json",
     "tsv (default): a table.  json: an object a line, with null for '-' and inf as a\nstring",
     cli_set_choice, FIELD(json)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "intersect",
    .synopsis = "[options] (NAME | EQUATION | --terms FILE)",
    .about = "Finds where rays meet an algebraic surface P(x,y,z) = 0.  NAME is a surface that\n"
             "render --list shows.  Rays are read from standard input, a line\n"
             "\"ox oy oz dx dy dz t_min t_max\" for each: the points o + t d, t_min <= t <= t_max.  Numbers\n"
             "are decimal or hexadecimal, t_min and t_max may be inf; '#' starts a comment.\n\n"
             "Prints a table with a row for each ray, '-' where there is no value.  Its columns:\n"
             "line, of the input; state: hit, miss, undecided or error; t, at the hit; t_lo, t_hi: the\n"
             "hit is between them (undecided: no hit is before t_lo); x, y, z: the point; nx, ny, nz:\n"
             "the unit normal; multiplicity, of the root t: 1 where the ray crosses the surface, 2 where\n"
             "it touches it, 0 where it lies in it; side: the sign of P just before the hit.",
    .options = options_table,
    .positional = offsetof(intersect_options, surface.name),
    .examples = "echo '-4 0.25 0  1 0 0  0 inf' | intersect torus\n"
                "echo '-4 0 0  1 0 0  0 inf' | intersect 'x^2 + y^2 + z^2 = 1' --all",
};

/* What every line needs. */
typedef struct run {
    const algsurf_surface *surface;
    const algsurf_extent *extent; /* null: all of space */
    const algsurf_intersect_options *how;
    int all;
    algsurf_hit *hits;
    int capacity;
    int bad_lines;
    table out;
} run;

static void add_absent(table *out, int columns) {
    while (columns-- > 0) table_add(out, "\t-");
}

static void add_numbers(table *out, const double *values, int count) {
    for (int i = 0; i < count; i++) table_add(out, "\t%.17g", values[i]);
}

static void print_hit(run *r, size_t line, const algsurf_hit *hit) {
    table *out = &r->out;
    table_add(out, "%zu\t%s", line, hit->state == ALGSURF_STATE_HIT ? "hit" : "undecided");
    add_numbers(out, &hit->t, 1);
    add_numbers(out, &hit->t_lo, 1);
    add_numbers(out, &hit->t_hi, 1);
    add_numbers(out, hit->position, 3);
    const double *n = hit->normal;
    if (n[0] == 0 && n[1] == 0 && n[2] == 0)
        add_absent(out, 3);
    else
        add_numbers(out, n, 3);
    if (hit->state == ALGSURF_STATE_HIT)
        table_add(out, "\t%d\t%d", hit->multiplicity, hit->side);
    else
        add_absent(out, 2);
    table_end(out);
}

static void print_empty(run *r, size_t line, const char *state) {
    table_add(&r->out, "%zu\t%s", line, state);
    add_absent(&r->out, 11);
    table_end(&r->out);
}

/* The ray of a line's six or eight fields; 0 and a complaint when there is none. */
static int parse_ray(size_t line, char **field, int fields, algsurf_ray *ray) {
    double *to[8] = {&ray->origin[0],    &ray->origin[1],    &ray->origin[2], &ray->direction[0],
                     &ray->direction[1], &ray->direction[2], &ray->t_min,     &ray->t_max};
    ray->t_min = 0;
    ray->t_max = INFINITY;
    for (int i = 0; i < fields; i++) {
        int infinite_allowed = i >= 6;
        if (cli_number(field[i], to[i]) && !isnan(*to[i]) && (infinite_allowed || isfinite(*to[i]))) continue;
        cli_complain("line %zu: field %d: expected a %s, got '%s'", line, i + 1,
                     infinite_allowed ? "number or inf" : "finite number", cli_quote(field[i]).text);
        return 0;
    }
    const double *d = ray->direction;
    if (d[0] != 0 || d[1] != 0 || d[2] != 0) return 1;
    cli_complain("line %zu: the direction is zero", line);
    return 0;
}

/* The hits of one ray; 0 and a complaint when the library refuses it. */
static int meet(run *r, size_t line, const algsurf_ray *ray) {
    int count = 1;
    algsurf_status status =
        r->all ? algsurf_intersect_all(r->surface, r->extent, ray, r->how, r->hits, r->capacity, &count)
               : algsurf_intersect_first(r->surface, r->extent, ray, r->how, r->hits);
    if (status < 0) {
        cli_complain("line %zu: %s", line, algsurf_status_text(status));
        return 0;
    }
    if (count == 0 || r->hits[0].state == ALGSURF_STATE_MISS)
        print_empty(r, line, "miss");
    else
        for (int i = 0; i < count; i++) print_hit(r, line, &r->hits[i]);
    return 1;
}

/* One line of input: rows of output, unless it is blank. */
static void take_line(run *r, cli_line *line) {
    char *field[8];
    algsurf_ray ray;
    int fields = cli_split(line, field, 8);
    if (fields == 0) return;
    if (fields < 0)
        cli_complain("line %zu: a NUL byte: not a text", line->number);
    else if (fields != 6 && fields != 8)
        cli_complain("line %zu: expected six or eight numbers, separated by blanks, got %d", line->number,
                     fields);
    else if (parse_ray(line->number, field, fields, &ray) && meet(r, line->number, &ray))
        return;
    r->bad_lines++;
    print_empty(r, line->number, "error");
}

static void take_lines(run *r) {
    cli_line line = {.number = 0};
    cli_line_result got;
    progress bar;
    progress_begin_lines(&bar);
    table_head(&r->out);
    while ((got = cli_read_line(stdin, &line)) == CLI_LINE_READ) {
        take_line(r, &line);
        progress_lines(&bar, line.number);
        if (ferror(stdout)) break;
    }
    int read_error = errno;
    progress_end(&bar);
    cli_finish_output();
    if (got == CLI_LINE_NO_MEMORY) cli_no_memory();
    if (got == CLI_LINE_TOO_LONG) cli_fail(CLI_BAD_INPUT, "line %zu: too long", line.number + 1);
    if (ferror(stdin)) cli_fail(CLI_BROKEN, "cannot read standard input: %s", strerror(read_error));
    free(line.text);
}

int main(int argc, char **argv) {
    intersect_options options = {.how = {.size = sizeof options.how}};
    cli_parse(&program, argc, argv, &options);
    cli_settle_surface(&options.surface);
    if (options.centre.given && !options.extent.given)
        cli_fail(CLI_BAD_INPUT, "--centre: has no effect without --extent");
    memcpy(options.extent.extent.centre, options.centre.x, sizeof options.centre.x);
    options.how.planes = options.clip.plane;
    options.how.plane_count = options.clip.count;
    algsurf_surface *surface = cli_make_surface(&options.surface);
    run r = {.surface = surface,
             .how = &options.how,
             .all = options.all,
             .out = {.columns = "line\tstate\tt\tt_lo\tt_hi\tx\ty\tz\tnx\tny\tnz\tmultiplicity\tside",
                     .json = options.json}};
    if (options.extent.given) r.extent = &options.extent.extent;
    r.capacity = algsurf_surface_degree(surface) + 1; /* at least 1, for a constant */
    r.hits = malloc((size_t)r.capacity * sizeof *r.hits);
    if (!r.hits) cli_no_memory();
    take_lines(&r);
    free(r.hits);
    free(r.out.row);
    algsurf_surface_free(surface);
    cli_forget_surface(&options.surface);
    return r.bad_lines > 0 ? CLI_BAD_INPUT : 0;
}
