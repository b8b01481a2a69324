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
#include <stdlib.h>

#include "chart.h"
#include "measure.h"
#include "must.h"
#include "rays.h"
#include "results.h"
#include "sheet.h"
#include "surfaces.h"
#include "view.h"

enum { NARROWEST = 128, WIDEST = 8192, QUICK_WIDEST = 1024, SLICE = 512, CHECKED = 1000 };
enum { MOST_WIDTHS = 16, MOST_TAKES = 64, MOST_SHOWN = 7 }; /* surfaces: colours that plot.h has */

typedef struct bench_options {
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
};

static const char legend[] =
    "What a ray of a picture costs, by the picture's width; one thread, one sample a pixel, with shading\n"
    "  takes    pictures timed; the states of a thousand of their pixels are those of their rays alone\n"
    "  ns/ray   wall time of algsurf_render for each ray: median; min, max: its spread\n"
    "  rows%    of the rays: not decided by tiles, but by their own polynomials, with others of their row\n"
    "  single%  of the rays: solved by themselves\n";

/* ---- pictures ---- */

/* Of a surface at one width. */
typedef struct measured {
    int width, height;
    measure_takes takes;        /* of the picture */
    double by_rows, by_singles; /* shares of the rays: solved with their rows, by themselves */
} measured;

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
    s.surface = rays_surface(entry);
    s.scene = rays_scene(s.surface, &s.shown.extent, &s.camera);
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
    const algsurf_ray ray = rays_ray(&s->camera, s->width, s->height, x, y);
    algsurf_hit hit;
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

/* ---- what is told ---- */

static const sheet_column columns[] = {{"surface", -12, NULL},
                                       {"degree", 6, NULL},
                                       {"width", 5, NULL},
                                       {"height", 6, NULL},
                                       {"takes", 5, NULL},
                                       {"ns/ray", 7, "ns_ray"},
                                       {"min", 7, NULL},
                                       {"max", 7, NULL},
                                       {"rows%", 6, "rows_percent"},
                                       {"single%", 7, "single_percent"}};

/* Of each surface's widths. */
static void report(const bench_options *o, int widths, measured (*found)[MOST_WIDTHS]) {
    static char machine[512];
    sheet table = SHEET(columns);
    plot_axis across = {.label = "width of the picture (pixels)"};
    chart charts[] = {{.plot = {.title = "What a ray costs, by resolution",
                                .subtitle = machine,
                                .x = across,
                                .y = {.label = "time of a ray (ns)", .scale = PLOT_LOG}}},
                      {.plot = {.title = "Rays that no tile decides",
                                .subtitle = "100 %: the picture is drawn without tiles, row by row",
                                .x = across,
                                .y = {.label = "% of the rays", .scale = PLOT_LOG}}}};
    measure_machine(machine, sizeof machine);
    for (int i = 0; i < o->surfaces.count; i++) {
        const catalogue_entry *entry = o->surfaces.entry[i];
        for (int c = 0; c < 2; c++) chart_series(&charts[c], entry->name, PLOT_BOTH);
        for (const measured *m = found[i]; m < found[i] + widths; m++) {
            const double ns = 1e9 / ((double)m->width * m->height),
                         median = ns * measure_taken(&m->takes, 0.5);
            char width[16];
            snprintf(width, sizeof width, "%d", m->width);
            sheet_add(&table, "%s\t%d\t%d\t%d\t%zu\t%.2f\t%.2f\t%.2f\t%.2f\t%.4f", entry->name, entry->degree,
                      m->width, m->height, m->takes.count, median, ns * measure_taken(&m->takes, 0),
                      ns * measure_taken(&m->takes, 1), 100 * m->by_rows, 100 * m->by_singles);
            chart_bar(&charts[0], width, median);
            chart_bar(&charts[1], width, 100 * (m->by_rows + m->by_singles));
        }
    }
    const char *mark = o->tsv ? "# " : "";
    measure_head(mark, (const char *const[]){legend, NULL});
    printf("%skernel: %s\n", mark, algsurf_kernel_name(0));
    sheet_print(&table, o->tsv);
    cli_finish_output();
    sheet_write(&table, o->output, "resolution.csv");
    chart_write(charts, 2, o->output, "resolution.svg");
    free(table.rows);
}

/* ---- the run ---- */

/* All surfaces at one width, in turn. */
static void measure_width(const bench_options *o, int width, int number, measured (*found)[MOST_WIDTHS]) {
    studio s[MOST_SHOWN];
    int more = QUICK_WIDEST / width, takes = more > 1 ? more * o->repeat : o->repeat;
    if (takes > MOST_TAKES) takes = MOST_TAKES;
    for (int i = 0; i < o->surfaces.count; i++) {
        s[i] = open_studio(o->surfaces.entry[i], width);
        found[i][number] = (measured){.width = width, .height = s[i].height};
        check_picture(&s[i], &found[i][number]);
    }
    for (int take = 0; take < takes; take++)
        for (int i = 0; i < o->surfaces.count; i++)
            measure_take(&found[i][number].takes, draw_picture(&s[i]));
    for (int i = 0; i < o->surfaces.count; i++) close_studio(&s[i]);
}

static void set_defaults(bench_options *o) {
    static const char *const names[] = {"tangle", "boy", "barth", "labs", "barth-decic"};
    if (o->widest == 0) o->widest = o->quick ? QUICK_WIDEST : WIDEST;
    if (o->repeat == 0) o->repeat = o->quick ? 3 : 5;
    if (o->surfaces.count > 0) return;
    surfaces_add_named(&o->surfaces, names, sizeof names / sizeof *names);
}

int main(int argc, char **argv) {
    static measured found[MOST_SHOWN][MOST_WIDTHS];
    bench_options o = {.surfaces = {.most = MOST_SHOWN}};
    int widths = 0;
    results_begin(&program, argc, argv, &o, &o.output);
    set_defaults(&o);
    for (int width = NARROWEST; width <= o.widest; width *= 2) measure_width(&o, width, widths++, found);
    report(&o, widths, found);
    return 0;
}
