/* render.c - draws an algebraic surface from the command line: render --help. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "catalogue.h"
#include "fit.h"
#include "cli.h"
#include "output.h"
#include "png.h"
#include "progress.h"
#include "render_axes.h"
#include "render_heatmap.h"
#include "render_join.h"
#include "render_options.h"
#include "render_rounding.h"
#include "render_slice.h"
#include "render_stats.h"
#include "render_sweep_view.h"
#include "view.h"

/* What the pictures of one run have in common. */
typedef struct run {
    const render_options *options;
    algsurf_surface *surface;
    algsurf_scene *scene;
    int rows; /* drawn: all, or the slice */
    uint8_t *pixels;
    double *hits;  /* null when not wanted */
    uint8_t *ways; /* likewise */
    progress bar;
    output_set film; /* one animated file, and its writer; null: a file for each picture */
    png_writer *frames;
} run;

static void list_surfaces(void) {
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        const catalogue_entry *first = catalogue_first_of(entry);
        if (first == entry)
            printf("%s\t%d\t%s\n", entry->name, entry->degree, entry->equation);
        else
            printf("%s\t%d\tas %s\n", entry->name, entry->degree, first->name);
    }
    cli_finish_output();
}

static void demand(algsurf_status status) {
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "%s", algsurf_status_text(status));
}

/* Where coefficients have an error, nothing can be proved to be absent near the surface: all of it seems
 * thin. */
static int shows_thin(const render_options *options) {
    return options->thin == THIN_ASKED || (options->thin == THIN_USUAL && !options->surface.rounded);
}

static algsurf_scene *make_scene(const render_options *options, const algsurf_surface *surface,
                                 const catalogue_entry *entry, const algsurf_extent *extent) {
    algsurf_scene *scene;
    demand(algsurf_scene_create(surface, &scene));
    algsurf_material material = view_material(scene, entry);
    render_paint(&options->look, &material);
    demand(algsurf_scene_set_extent(scene, extent));
    demand(algsurf_scene_set_material(scene, &material));
    demand(algsurf_scene_set_quality(scene, options->quality));
    demand(algsurf_scene_set_antialias(scene, options->antialias));
    demand(algsurf_scene_set_antialias_threshold(scene, options->antialias_threshold));
    double thin_colour[3] = {material.outside[0], material.outside[1], material.outside[2]};
    if (options->look.thin.given) colour_of(&options->look.thin, thin_colour);
    demand(algsurf_scene_set_thin(scene, shows_thin(options) ? thin_colour : NULL));
    demand(algsurf_scene_set_intersect_options(scene, &options->intersect));
    demand(algsurf_scene_set_clip(scene, options->clip.plane, options->clip.count));
    demand(algsurf_scene_set_coherence(scene, options->space.coherence));
    return scene;
}

/* "turn.png" becomes "turn-0003.png" for picture 2 of a sweep; "-" and null stay. */
static char *numbered(const char *path, const run *r, int picture) {
    if (!path) return NULL;
    size_t room = strlen(path) + 16;
    char *name = malloc(room);
    if (!name) cli_no_memory();
    if (r->options->sweep.pictures == 0 || strcmp(path, "-") == 0) return strcpy(name, path);
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path, *dot = strrchr(base, '.');
    int stem = (int)(dot ? dot - path : (ptrdiff_t)strlen(path));
    snprintf(name, room, "%.*s-%04d%s", stem, path, picture + 1, dot ? dot : "");
    return name;
}

/* As --extent and --centre have it. */
typedef struct extent_words {
    char text[160];
} extent_words;

static extent_words extent_text(const algsurf_extent *extent) {
    extent_words words;
    const double *size = extent->size, *c = extent->centre;
    int at = extent->kind == ALGSURF_EXTENT_SPHERE
                 ? snprintf(words.text, sizeof words.text, "sphere:%g", size[0])
                 : snprintf(words.text, sizeof words.text, "box:%g,%g,%g", size[0], size[1], size[2]);
    if (c[0] != 0 || c[1] != 0 || c[2] != 0)
        snprintf(words.text + at, sizeof words.text - (size_t)at, " about %g,%g,%g", c[0], c[1], c[2]);
    return words;
}

static void write_heatmap(output_set *set, const char *path, run *r, const algsurf_extent *extent,
                          const algsurf_camera *camera) {
    render_heatmap map =
        render_make_heatmap(r->options, r->surface, extent, camera, r->pixels, r->ways, &r->bar);
    output_image(set, path, r->options->heatmap_format, map.width, map.height, map.pixels);
    free(map.pixels);
}

/* The picture, or a slice of it that can be joined. */
static void write_picture(output_set *set, const char *path, const run *r, const algsurf_extent *extent,
                          const algsurf_camera *camera, const algsurf_complex_space *space) {
    const render_options *options = r->options;
    size_t count = (size_t)options->view.width * (size_t)r->rows;
    if (r->frames) {
        if (!png_frame(r->frames, r->pixels)) cli_no_memory();
        return;
    }
    if (options->look.transparent) {
        output_alpha(set, path, options->view.width, r->rows, r->pixels);
        return;
    }
    if (options->row_end == 0 || options->format != IMAGE_PPM) {
        output_image(set, path, options->format, options->view.width, r->rows, r->pixels);
        return;
    }
    render_slice slice = {options->view.width,
                          options->view.height,
                          options->row_begin,
                          options->row_end,
                          render_job_digest(options, r->surface, extent, camera, space),
                          render_pixels_digest(r->pixels, 3 * count),
                          options->hits ? render_hits_digest(r->hits, count) : 0};
    output_ppm(set, path, render_slice_write(&slice).text, options->view.width, r->rows, r->pixels);
}

/* As the file of hits has them. */
static void mark_misses(double *hits, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (isinf(hits[i])) hits[i] = NAN;
}

/* A picture without anything in it is explained. */
static void explain_nothing(const run *r, const view *shown) {
    double lo[3], hi[3];
    int empty;
    if (r->options->space.is_complex) {
        cli_complain("nothing is seen: no root has an argument from sigma to sigma + delta; a larger --delta "
                     "shows more");
        return;
    }
    demand(algsurf_surface_enclose(r->surface, &shown->extent, ALGSURF_PART_ALL, 1.0 / 16, lo, hi, &empty));
    if (empty)
        cli_complain("nothing of the surface lies in %s (proved): it is elsewhere (--extent, --centre), or "
                     "the equation "
                     "holds for no real point",
                     extent_text(&shown->extent).text);
    else
        cli_complain("nothing is seen: the surface can only lie within x %.3g..%.3g, y %.3g..%.3g, "
                     "z %.3g..%.3g; %s",
                     lo[0], hi[0], lo[1], hi[1], lo[2], hi[2],
                     r->options->clip.count > 0
                         ? "--clip cuts it off, or --eye, --look-at choose another view"
                         : "--eye, --look-at choose another view");
}

static algsurf_surface *make_surface(const render_options *options, int picture) {
    const render_sweep *sweep = &options->sweep;
    if (sweep->kind != SWEEP_LET) return cli_make_surface(&options->surface);
    return cli_make_surface_with(&options->surface, sweep->name, render_sweep_value(sweep, picture));
}

static void release_surface(run *r) {
    algsurf_scene_free(r->scene);
    algsurf_surface_free(r->surface);
    r->scene = NULL;
    r->surface = NULL;
}

/* The surface of this picture and a scene with it: one for all unless a constant is swept. */
static void prepare_surface(run *r, const view *shown, int picture) {
    const cli_surface *given = &r->options->surface;
    if (r->scene && r->options->sweep.kind != SWEEP_LET) return;
    if (r->scene) release_surface(r);
    if (!r->surface) r->surface = make_surface(r->options, picture);
    r->scene =
        make_scene(r->options, r->surface, given->name ? catalogue_find(given->name) : NULL, &shown->extent);
}

static void draw_picture(run *r, const view *shown, int picture) {
    const render_options *options = r->options;
    const render_sweep *sweep = &options->sweep;
    prepare_surface(r, shown, picture);
    algsurf_camera camera = view_camera(shown, sweep->kind == SWEEP_TURN ? picture : 0, sweep->pictures);
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    algsurf_complex_space space = render_space_of(&options->space, sweep, picture, imaginary);
    char *output = r->frames ? NULL : numbered(options->output, r, picture);
    char *hits = numbered(options->hits, r, picture), *stats = numbered(options->stats, r, picture);
    char *heatmap = numbered(options->heatmap, r, picture);
    const char *const written[] = {r->frames ? options->output : output, hits, stats, heatmap};
    output_check(written, 4, options->surface.path);

    algsurf_render_options how = {
        sizeof how,       options->view.width, options->view.height, options->row_begin,
        options->row_end, options->threads,    progress_rows,        &r->bar};
    const algsurf_picture planes = {.size = sizeof planes,
                                    .pixels = r->pixels,
                                    .format = options->look.transparent ? ALGSURF_RGBA8 : ALGSURF_RGB8,
                                    .t = r->hits,
                                    .way = r->ways};
    algsurf_render_stats counted = {.size = sizeof counted};
    r->bar.picture = options->frame > 0 ? 1 : picture + 1;
    demand(algsurf_scene_set_camera(r->scene, &camera));
    demand(render_light_scene(&options->look, &camera, &shown->extent, r->scene));
    demand(algsurf_scene_set_complex_space(r->scene, options->space.is_complex ? &space : NULL));
    demand(algsurf_render(r->scene, &how, &planes, &counted));
    if (counted.hits + counted.undecided + counted.thin == 0 && options->row_end == 0)
        explain_nothing(r, shown);
    if (counted.thin > 0 && options->thin == THIN_USUAL && !options->surface.name)
        cli_complain("thin: %" PRIu64
                     " sample%s points or lines that no ray meets, some of them perhaps not there; "
                     "--thin none leaves them out",
                     counted.thin, counted.thin == 1 ? " shows" : "s show");
    if (r->hits) mark_misses(r->hits, (size_t)options->view.width * (size_t)r->rows);

    output_set set = {.count = 0};
    progress_say(&r->bar, "writing");
    if (stats) render_write_stats(&set, stats, options, r->surface, &counted);
    if (hits) output_hits(&set, hits, r->hits, (size_t)options->view.width * (size_t)r->rows);
    if (heatmap) write_heatmap(&set, heatmap, r, &shown->extent, &camera);
    render_axes(options, r->surface, shown, &camera, r->rows, r->pixels, r->hits);
    write_picture(&set, output, r, &shown->extent, &camera, options->space.is_complex ? &space : NULL);
    output_commit(&set);
    free(output);
    free(hits);
    free(stats);
    free(heatmap);
}

static void check_degree(const render_options *options, const algsurf_surface *surface) {
    int degree = algsurf_surface_degree(surface);
    if (options->thin == THIN_ASKED && degree > RENDER_THIN_DEGREE)
        cli_fail(CLI_BAD_INPUT, "--thin: the surface has degree %d, the limit is %d", degree,
                 RENDER_THIN_DEGREE);
    render_check_degree(&options->space, &options->sweep, degree);
}

/* Makes the surface of the first picture; what is bad about any is told before one is drawn. */
static void check_surfaces(run *r, int first, int end) {
    r->surface = make_surface(r->options, first);
    check_degree(r->options, r->surface);
    if (r->options->sweep.kind != SWEEP_LET && algsurf_surface_degree(r->surface) == 0)
        cli_fail(CLI_BAD_INPUT, "x, y and z are missing or cancel: the equation holds at no point");
    if (r->options->sweep.kind != SWEEP_LET) return;
    for (int i = first + 1; i < end; i++) {
        algsurf_surface *surface = make_surface(r->options, i);
        check_degree(r->options, surface);
        algsurf_surface_free(surface);
    }
}

/* The view is chosen once for all pictures of a sweep. */
static void choose_view(const run *r, view *shown) {
    const render_options *options = r->options;
    const render_sweep *sweep = &options->sweep;
    int extent_only = options->space.is_complex || sweep->kind == SWEEP_TURN;
    const int chosen[3] = {0, sweep->pictures - 1, (sweep->pictures - 1) / 2};
    algsurf_surface *surface[3];
    if (sweep->kind != SWEEP_LET) {
        fit_view(shown, &options->view, r->surface, extent_only, shows_thin(options));
        return;
    }
    for (int i = 0; i < 3; i++) surface[i] = make_surface(options, chosen[i]);
    render_sweep_view(shown, &options->view, surface, 3, extent_only);
    for (int i = 0; i < 3; i++) algsurf_surface_free(surface[i]);
}

/* One file for all pictures; until its end, whatever ends the program removes it. */
static FILE *begin_film(run *r, int pictures) {
    const render_options *options = r->options;
    FILE *file = output_open(&r->film, options->output);
    r->frames = png_begin(file, options->view.width, options->view.height, options->look.transparent ? 4 : 3);
    if (!r->frames) cli_no_memory();
    png_animate(r->frames, pictures, options->a_second);
    return file;
}

static void end_film(run *r, FILE *file) {
    png_end(r->frames);
    output_close(&r->film, r->options->output, file);
    output_commit(&r->film);
}

static void draw(const render_options *options) {
    const cli_surface *given = &options->surface;
    int first = options->frame > 0 ? options->frame - 1 : 0;
    int end = options->frame > 0 ? options->frame : options->sweep.pictures > 0 ? options->sweep.pictures : 1;
    run r = {.options = options};
    check_surfaces(&r, first, end);
    view shown = view_make(&options->view, given->name ? catalogue_find(given->name) : NULL);
    if (!given->name) choose_view(&r, &shown);
    render_make_room(options, &shown);
    (void)view_camera(&shown, 0, 1); /* a bad camera is told before anything else is done */
    if (given->equation && !given->rounded && !options->space.is_complex)
        render_tell_of_rounding(r.surface, &shown);
    r.rows = options->row_end > 0 ? options->row_end - options->row_begin : options->view.height;
    size_t count = (size_t)options->view.width * (size_t)r.rows;
    r.pixels = malloc((options->look.transparent ? 4 : 3) * count);
    int with_hits = options->hits || render_has_axes(options);
    if (with_hits) r.hits = malloc(count * sizeof *r.hits);
    if (options->heatmap) r.ways = malloc(count);
    if (!r.pixels || (with_hits && !r.hits) || (options->heatmap && !r.ways)) cli_no_memory();
    progress_begin(&r.bar, options->progress, end - first);
    FILE *film = options->a_second > 0 ? begin_film(&r, end - first) : NULL;
    for (int i = first; i < end; i++) draw_picture(&r, &shown, i);
    if (film) end_film(&r, film);
    progress_end(&r.bar);
    release_surface(&r);
    free(r.pixels);
    free(r.hits);
    free(r.ways);
}

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "--join") == 0) return render_join(argc - 1, argv + 1);
    render_options options = render_parse_options(argc, argv);
    if (options.list) {
        if (options.surface.name || options.surface.equation || options.surface.terms)
            cli_fail(CLI_BAD_INPUT, "--list: takes no surface");
        list_surfaces();
        return 0;
    }
    draw(&options);
    cli_forget_surface(&options.surface);
    free(options.default_output);
    return 0;
}
