/* resolution.c - what a ray of a picture costs, against the picture's width: resolution --help.
 *
 * Rays that neighbours of theirs decide, too, cost next to nothing (tiles, render.h): what is left for each
 * ray by itself is along the outlines, whose pixels grow with the width of the picture, not with its area. So
 * the more pixels, the less each costs.
 *
 * The view is that of `render NAME`, 4 to 3, one sample a pixel, one thread.  A picture is drawn in slices of
 * whole bands, all into the same memory, and its time is theirs together.  Before it is timed, the states of
 * some of its pixels, chosen at random, are compared with those of their rays alone; one that differs ends
 * the program.  Surfaces take turns at each width.
 */
#include "resolution.h"

#include <stdlib.h>

#include "cli.h"
#include "measure.h"
#include "must.h"
#include "results.h"
#include "surfaces.h"
#include "view.h"

enum { NARROWEST = 128, WIDEST = 8192, QUICK_WIDEST = 1024, SLICE = 512, CHECKED = 1000 };

typedef struct bench_options {
    const char *extra; /* a plain argument, which this program does not take */
    const char *output;
    int widest, repeat, quick, tsv;
    surface_list surfaces;
} bench_options;

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--widest", "W", "pictures of 128, 256, ... pixels a row, up to W, at most 65535; default 8192",
     cli_set_int, FIELD(widest), NARROWEST, 65535},
    {"--repeat", "N", "pictures of which the median is reported, default 5; more of small ones", cli_set_int,
     FIELD(repeat), 1, MOST_TAKES},
    {"--surface", "NAME",
     "a surface of the catalogue (up to seven), default tangle, boy, barth, labs,\nbarth-decic", surfaces_set,
     FIELD(surfaces), 0, 0},
    {"--quick", NULL, "smaller defaults: up to 1024 pixels a row, 3 pictures", cli_set_flag, FIELD(quick), 0,
     0},
    {"--output", "FOLDER", "gets resolution.csv and resolution.svg; made if there is none", cli_set_text,
     FIELD(output), 0, 0},
    {"--format", "text|tsv", "to be read by people (default) or programs", cli_set_choice, FIELD(tsv), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "resolution",
    .synopsis = "[options]",
    .about = "Draws surfaces at growing resolutions, checks the pictures, and prints what a ray costs.",
    .options = options_table,
    .positional = FIELD(extra),
};

/* ---- pictures ---- */

/* A surface at one width, and room for a slice. */
typedef struct studio {
    const catalogue_entry *entry;
    int width, height;
    view shown;
    algsurf_camera camera;
    algsurf_surface *surface;
    algsurf_scene *scene;
    unsigned char *pixels, *states;
} studio;

static studio open_studio(const catalogue_entry *entry, int width) {
    studio s = {.entry = entry, .width = width, .height = 3 * width / 4};
    const view_options size = {.width = s.width, .height = s.height};
    const size_t room = (size_t)width * SLICE;
    s.shown = view_make(&size, entry);
    s.camera = view_camera(&s.shown, 0, 1);
    s.pixels = must_allocate(3 * room, 1);
    s.states = must_allocate(room, 1);
    must(algsurf_surface_from_equation(entry->equation, NULL, 0, &s.surface, NULL), entry->name);
    must(algsurf_scene_create(s.surface, &s.scene), entry->name);
    must(algsurf_scene_set_extent(s.scene, &s.shown.extent), entry->name);
    must(algsurf_scene_set_camera(s.scene, &s.camera), entry->name);
    return s;
}

static void close_studio(studio *s) {
    algsurf_scene_free(s->scene);
    algsurf_surface_free(s->surface);
    free(s->states);
    free(s->pixels);
}

static int slice_end(const studio *s, int begin) {
    return begin + SLICE < s->height ? begin + SLICE : s->height;
}

/* The rows from `begin` on, as far as there is room for them. */
static algsurf_render_stats draw_slice(const studio *s, int begin, int with_states) {
    const algsurf_render_options options = {.size = sizeof options,
                                            .width = s->width,
                                            .height = s->height,
                                            .row_begin = begin,
                                            .row_end = slice_end(s, begin),
                                            .threads = 1};
    const algsurf_picture picture = {
        .size = sizeof picture, .pixels = s->pixels, .state = with_states ? s->states : NULL};
    algsurf_render_stats stats = {.size = sizeof stats};
    must(algsurf_render(s->scene, &options, &picture, &stats), s->entry->name);
    return stats;
}

static void check_pixel(const studio *s, int x, int y, int state) {
    algsurf_ray ray;
    algsurf_hit hit;
    must(algsurf_camera_ray(&s->camera, s->width, s->height, x + 0.5, y + 0.5, &ray), s->entry->name);
    must(algsurf_intersect_first(s->surface, &s->shown.extent, &ray, NULL, &hit), s->entry->name);
    if (hit.state != state)
        cli_fail(CLI_BROKEN, "%s, %d wide: pixel %d,%d: state %d, alone %d", s->entry->name, s->width, x, y,
                 state, hit.state);
}

/* Draws the picture once, checks it, and tells how its rays were decided. */
static void check_picture(const studio *s, measured *m) {
    measure_random random = {(uint64_t)s->width};
    double rays = (double)s->width * s->height, tiled = 0, singles = 0;
    int slices = (s->height + SLICE - 1) / SLICE;
    for (int begin = 0; begin < s->height; begin += SLICE) {
        const algsurf_render_stats stats = draw_slice(s, begin, 1);
        tiled += (double)(stats.empty_rays + stats.sheet_rays);
        singles += (double)stats.single_rays;
        for (int i = 0; i < CHECKED / slices; i++) {
            int x = (int)measure_uniform(&random, 0, s->width - 1);
            int y = (int)measure_uniform(&random, begin, slice_end(s, begin) - 1);
            check_pixel(s, x, y, s->states[(size_t)(y - begin) * (size_t)s->width + (size_t)x]);
        }
    }
    m->by_singles = singles / rays;
    m->by_rows = (rays - tiled - singles) / rays;
}

static double draw_picture(const studio *s) {
    double seconds = 0;
    for (int begin = 0; begin < s->height; begin += SLICE) seconds += draw_slice(s, begin, 0).total_s;
    return seconds;
}

/* ---- the run ---- */

/* All surfaces at one width, in turn. */
static void measure_width(const bench_options *o, int width, int number, record *records) {
    double seconds[MOST_SHOWN][MOST_TAKES];
    studio s[MOST_SHOWN];
    int more = QUICK_WIDEST / width, takes = more > 1 ? more * o->repeat : o->repeat;
    if (takes > MOST_TAKES) takes = MOST_TAKES;
    for (int i = 0; i < o->surfaces.count; i++) {
        s[i] = open_studio(o->surfaces.entry[i], width);
        records[i].at[number] = (measured){.width = width, .height = s[i].height, .takes = takes};
        check_picture(&s[i], &records[i].at[number]);
    }
    for (int take = 0; take < takes; take++)
        for (int i = 0; i < o->surfaces.count; i++) seconds[i][take] = draw_picture(&s[i]);
    for (int i = 0; i < o->surfaces.count; i++) {
        static const double shares[3] = {0.5, 0, 1};
        double rays = (double)width * s[i].height;
        measure_sort(seconds[i], (size_t)takes);
        for (int k = 0; k < 3; k++)
            records[i].at[number].ns[k] = 1e9 * measure_quantile(seconds[i], (size_t)takes, shares[k]) / rays;
        close_studio(&s[i]);
    }
}

static void set_defaults(bench_options *o) {
    static const char *const names[] = {"tangle", "boy", "barth", "labs", "barth-decic"};
    if (o->widest == 0) o->widest = o->quick ? QUICK_WIDEST : WIDEST;
    if (o->repeat == 0) o->repeat = o->quick ? 3 : 5;
    if (o->surfaces.count > 0) return;
    surfaces_add_named(&o->surfaces, names, sizeof names / sizeof *names);
}

int main(int argc, char **argv) {
    static record records[MOST_SHOWN];
    bench_options o = {.surfaces = {.most = MOST_SHOWN}};
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s'", cli_quote(o.extra).text);
    set_defaults(&o);
    if (o.output) results_folder(o.output); /* before the work */
    report r = {.records = records, .surfaces = o.surfaces.count};
    for (int i = 0; i < o.surfaces.count; i++) records[i].entry = o.surfaces.entry[i];
    for (int width = NARROWEST; width <= o.widest; width *= 2) measure_width(&o, width, r.widths++, records);
    if (o.output) report_write(&r, o.output);
    report_print(&r, o.tsv);
    return 0;
}
