/* render_options.c - see render_options.h. */
#include "render_options.h"

#include <stdlib.h>
#include <string.h>

#include "output.h"
#include "portable.h"

enum { LARGEST = 65535 }; /* width, height: algsurf_render_options */

static void set_rows(const cli_option *option, const char *value, void *field) {
    render_options *options = field;
    char text[16];
    size_t cut = strcspn(value, ":");
    if (value[cut] == ':' && cut < sizeof text) {
        memcpy(text, value, cut);
        text[cut] = '\0';
        if (cli_whole(text, 0, LARGEST, &options->row_begin) &&
            cli_whole(value + cut + 1, 1, LARGEST, &options->row_end) &&
            options->row_begin < options->row_end)
            return;
    }
    cli_fail(CLI_BAD_INPUT, "%s: expected A:B, 0 <= A < B, got '%s'", option->name, cli_quote(value).text);
}

/* A command of its own: render_join.c. */
static void set_join(const cli_option *option, const char *value, void *field) {
    (void)value;
    (void)field;
    cli_fail(CLI_BAD_INPUT, "%s: must be the first argument", option->name);
}

static void set_threshold(const cli_option *option, const char *value, void *field) {
    double threshold;
    if (!cli_numbers(value, ',', 1, &threshold) || !(threshold >= 0 && threshold <= 1))
        cli_fail(CLI_BAD_INPUT, "%s: expected a number from 0 to 1, got '%s'", option->name,
                 cli_quote(value).text);
    *(double *)field = threshold;
}

static void set_quality(const cli_option *option, const char *value, void *field) {
    static const algsurf_quality qualities[] = {ALGSURF_QUALITY_PREVIEW, ALGSURF_QUALITY_STANDARD,
                                                ALGSURF_QUALITY_FULL};
    *(algsurf_quality *)field = qualities[cli_choice(option, value)];
}

/* How real roots are found: not for complex space. */
static algsurf_intersect_options *real_only(const cli_option *option, void *field) {
    render_options *options = field;
    options->space.real_only = option->name;
    return &options->intersect;
}

static void set_method(const cli_option *option, const char *value, void *field) {
    cli_set_method(option, value, &real_only(option, field)->method);
}

static void set_thin(const cli_option *option, const char *value, void *field) {
    render_options *options = field;
    options->thin = strcmp(value, "none") == 0 ? THIN_NONE : THIN_ASKED;
    if (options->thin == THIN_NONE) return;
    (void)real_only(option, field);
    colour_set(option, value, &options->look.thin);
}

static void set_tolerance(const cli_option *option, const char *value, void *field) {
    cli_set_tolerance(option, value, &real_only(option, field)->absolute_tolerance);
}

static void set_tier(const cli_option *option, const char *value, void *field) {
    cli_set_tier(option, value, &real_only(option, field)->tier);
}

/* Unlike the other settings, which kernels there are depends on the machine. */
static void set_kernel(const cli_option *option, const char *value, void *field) {
    const char *name;
    char names[128] = "";
    for (int i = 0; (name = algsurf_kernel_name(i)); i++) {
        if (strcmp(name, value) == 0) {
            real_only(option, field)->kernel = name;
            return;
        }
        strncat(strncat(names, i ? ", " : "", sizeof names - strlen(names) - 1), name,
                sizeof names - strlen(names) - 1);
    }
    cli_fail(CLI_BAD_INPUT, "%s: this machine runs %s, not '%s'", option->name, names, cli_quote(value).text);
}

static void set_progress(const cli_option *option, const char *value, void *field) {
    static const progress_mode modes[] = {PROGRESS_AUTO, PROGRESS_ALWAYS, PROGRESS_NEVER};
    *(progress_mode *)field = modes[cli_choice(option, value)];
}

#define FIELD(member) offsetof(render_options, member), 0, 0

static const cli_option options_table[] = {
    {"--list", NULL, "the named surfaces: name, degree, equation, or as NAME: another view of it",
     cli_set_flag, FIELD(list)},
    CLI_SURFACE_OPTIONS(render_options),
    VIEW_OPTIONS(render_options),
    {"--output", "FILE",
     "the picture, .png, .bmp or .ppm by its ending; - is standard output, as a\n"
     "PPM, as for the names of devices and pipes;\n"
     "default NAME.png, or surface.png when the surface has no name",
     cli_set_text, FIELD(output)},
    {"--colour", "COLOUR",
     "of the surface: a name of CSS, as teal, or #rrggbb; default: as suits the\n"
     "surface, one for each side",
     colour_set, FIELD(look.outside)},
    {"--inside", "COLOUR", "of the side where the equation's left side is less than its right, if another",
     colour_set, FIELD(look.inside)},
    {"--background", "COLOUR|none", "where nothing is seen, default white; none: transparent, in a .png",
     render_set_background, FIELD(look)},
    {"--light", "X,Y,Z|AZ:EL",
     "where the light is: a point of space; or, seen from the eye, so many\n"
     "degrees to the right and upwards, as -40:35",
     render_set_light, FIELD(look)},
    {"--lights", "usual|paper", "paper: two square lights of 5x5 points instead of one wide one",
     render_set_lights, FIELD(look)},
    {"--quality", "preview|standard|full",
     "no illumination model; lights without shadows (default);\n"
     "soft shadows, and light from all around",
     set_quality, FIELD(quality)},
    {"--antialias", "N", "N x N samples a pixel, 1 to 16, default 4; see --antialias-threshold", cli_set_int,
     offsetof(render_options, antialias), 1, 16},
    {"--antialias-threshold", "X",
     "they go only to pixels whose middle differs from a neighbour's by more than\n"
     "X, 0 to 1, in red, green or blue, the others get one sample; default 0.1;\n"
     "0: all pixels get them",
     set_threshold, FIELD(antialias_threshold)},
    {"--thin", "COLOUR|none",
     "of what is so thin that rays pass it by: isolated points, lines without\n"
     "sheets, needles, up to degree 12; default that of the surface up to degree 6;\n"
     "none: it is left out",
     set_thin, 0, 0, 0},
    {"--method", "default|brent|bisection|regula-falsi", "how an isolated root is refined", set_method, 0, 0,
     0},
    {"--tolerance", "EPS", "wanted error of a hit's distance, default 0: all a double can tell",
     set_tolerance, 0, 0, 0},
    {"--tier", "certified|bounded",
     "every ray decided, by integers where doubles leave it open (default);\n"
     "doubles alone, the rest uncertain",
     set_tier, 0, 0, 0},
    {"--kernel", "baseline|avx2|avx512",
     "packet code, default the fastest that runs here; the picture does not\ndepend on it", set_kernel, 0, 0,
     0},
    {"--sigma", "S",
     "complex space: shows, of the complex roots t along each ray from the\n"
     "eye, the one of least |t| among those with S <= |arg t| <= S + D;\n"
     "radians, as 0.2 or 7pi/18, default 0.  --method, --tolerance, --tier,\n"
     "--kernel and --quality full (shadows) play no part there and are refused",
     render_set_sigma, FIELD(space)},
    {"--delta", "D", "complex space: D, default 1e-10, which shows the real surface", render_set_delta,
     FIELD(space)},
    {"--imag", "K=V",
     "complex space: adds V i to the coefficient of t^K, K from 0 to the\ndegree (repeatable)",
     render_set_imaginary, FIELD(space)},
    {"--coherence", "none|neighbours",
     "complex space: each ray's roots are found from scratch, or from those\n"
     "of its neighbours (default): the same picture in less time",
     render_set_coherence, FIELD(space)},
    {"--sweep", "turn:N|let:NAME:A:B:N|delta:A:B:N|imag:K:A:B:N",
     "N pictures NAME-0001.png ...: a turn about the upward axis; --let NAME,\n--delta or --imag K from A to "
     "B",
     render_set_sweep, FIELD(sweep)},
    {"--animate", "RATE", "the --sweep as one animated .png, RATE pictures a second, 1 to 60", cli_set_int,
     offsetof(render_options, a_second), 1, 60},
    {"--frame", "K", "only picture K of the --sweep, from 1 as in its name", cli_set_int,
     offsetof(render_options, frame), 1, RENDER_MOST_PICTURES},
    {"--threads", "N", "0 to 256, default 0: one for each processor", cli_set_int,
     offsetof(render_options, threads), 0, 256},
    {"--rows", "A:B",
     "a slice: only the rows A to B-1 of the picture, from 0 at the top; as a\n"
     ".ppm it can be joined with others",
     set_rows, 0, 0, 0},
    {"--join", "SLICE.ppm ...", "a command of its own: slices become a picture; render --join --help",
     set_join, 0, 0, 0},
    {"--hits", "FILE",
     "distances as raw little-endian doubles, row by row from the top:\nt of the hit "
     "along the unit ray from the eye, NaN where none",
     cli_set_text, FIELD(hits)},
    {"--heatmap", "FILE",
     "a second picture, with a legend: which tiles of pixels were proved empty, or\n"
     "to see one sheet of the surface; of the other pixels, what the ray through\n"
     "the middle costs (intervals looked at, and evaluations, counted for single\n"
     "rays on one thread), and which rays doubles leave open; names as --output",
     cli_set_text, FIELD(heatmap)},
    {"--stats", "FILE",
     "counts and times, a line 'key<TAB>value' each, or, by the ending .json, an\n"
     "object; - is standard output.\n"
     "rays: samples of the picture; hits, uncertain: of them; thin: samples that\n"
     "show what is thin; single_rays: of all, those not solved together with\n"
     "their row; exact_rays: of these, decided by integers; empty_rays, sheet_rays:\n"
     "decided by tiles; shadow_rays: to lights;\n"
     "iterations: corrections of roots in complex space, 0 for a real surface;\n"
     "tiles: of pixels, that were searched; empty_tiles, sheet_tiles: of them,\n"
     "that decide all of their rays; leaf_tiles: of them, the smallest that do not;\n"
     "expand_s, solve_s, point_s, shadow_s, shade_s: seconds for the surface in the\n"
     "view, for roots, positions and normals, shadows, colours, each summed over\n"
     "threads; total_s: seconds by the clock, without reading and writing files",
     cli_set_text, FIELD(stats)},
    {"--progress", "auto|always|never", "a bar with the time left on standard error", set_progress,
     FIELD(progress)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "render",
    .synopsis = "[options] (NAME | EQUATION | FILE.jsurf | --terms FILE)",
    .about = "Draws an algebraic surface, P(x,y,z) = 0.  NAME is one of those that --list shows;\n"
             "FILE.jsurf a file of IMAGINARY's SURFER: equation, parameters, view and colours, as far\n"
             "as options do not say otherwise.",
    .options = options_table,
    .positional = offsetof(render_options, surface.name),
    .examples = "render barth --output barth.png\n"
                "render 'x^2 + y^2 = z^2' --output cone.png\n"
                "render 'x^4 + y^4 + z^4 = a^4' --let a=1.2 --extent sphere:2 --output cube.png\n"
                "render boy --quality full --antialias 4 --antialias-threshold 0.1 --output boy.png\n"
                "render labs --stats -\n"
                "render steiner --delta pi/36 --output opening.png\n"
                "render 'x^2 + y^2 - a z^2 = 1' --sweep let:a:-1:1:24 --size 512x384 --output bend.png\n"
                "render barth --sweep turn:72 --animate 24 --size 400x400 --output turn.png\n"
                "render tangle --sweep turn:36 --size 512x384 --output turn.png",
};

/* Which file gets standard output; at most one may. */
static void check_standard_output(const render_options *options) {
    const char *files[] = {options->output, options->hits, options->stats, options->heatmap};
    int users = 0;
    for (int i = 0; i < 4; i++) users += files[i] && strcmp(files[i], "-") == 0;
    if (users > 1) cli_fail(CLI_BAD_INPUT, "only one of --output, --hits, --stats, --heatmap can be '-'");
}

image_format render_image_format(const char *option, const char *path) {
    image_format format = IMAGE_PPM;
    if (!image_format_of(path, &format) && strcmp(path, "-") != 0 && !output_is_special(path))
        cli_fail(CLI_BAD_INPUT, "%s: expected a name that ends in .png, .bmp or .ppm, got '%s'", option,
                 cli_quote(path).text);
    return format;
}

static image_format check_image(const render_options *options, const char *option, const char *path) {
    int is_film = options->a_second > 0 && path == options->output;
    if (options->sweep.pictures > 0 && options->frame == 0 && !is_film && strcmp(path, "-") == 0)
        cli_fail(CLI_BAD_INPUT, "%s: '-' holds one picture, not a --sweep", option);
    return render_image_format(option, path);
}

/* "folder/name.jsurf" becomes "name.png". */
static char *picture_of(const char *path) {
    const char *name = path + portable_folder_length(path);
    char *picture = malloc(strlen(name) + sizeof ".png");
    if (!picture) cli_no_memory();
    strcpy(strrchr(strcpy(picture, name), '.'), ".png");
    return picture;
}

static void check_output(render_options *options) {
    if (!options->output && options->default_output) options->output = options->default_output;
    if (!options->output) {
        const char *name = options->surface.name ? options->surface.name : "surface";
        options->default_output = malloc(strlen(name) + sizeof ".png");
        if (!options->default_output) cli_no_memory();
        options->output = strcat(strcpy(options->default_output, name), ".png");
    }
    options->format = check_image(options, "--output", options->output);
    if (options->a_second > 0 && options->format != IMAGE_PNG)
        cli_fail(CLI_BAD_INPUT, "--animate: only a .png is animated, --output is '%s'",
                 cli_quote(options->output).text);
    if (options->look.transparent && options->format != IMAGE_PNG)
        cli_fail(CLI_BAD_INPUT, "--background none: only a .png is transparent, --output is '%s'",
                 cli_quote(options->output).text);
    if (options->look.transparent && options->heatmap)
        cli_fail(CLI_BAD_INPUT, "--heatmap: plays no part with --background none");
    if (options->heatmap) options->heatmap_format = check_image(options, "--heatmap", options->heatmap);
    check_standard_output(options);
}

static void check_animation(const render_options *options) {
    if (options->sweep.pictures == 0) cli_fail(CLI_BAD_INPUT, "--animate: plays no part without --sweep");
    if (options->frame > 0)
        cli_fail(CLI_BAD_INPUT, "--animate: all pictures of the --sweep; leave --frame out");
    if (options->row_end > 0) cli_fail(CLI_BAD_INPUT, "--animate: whole pictures; leave --rows out");
}

static void check_swept_constant(const render_options *options) {
    const char *name = options->sweep.name;
    if (options->sweep.kind != SWEEP_LET) return;
    if (!options->surface.equation) cli_fail(CLI_BAD_INPUT, "--sweep let: only an equation has constants");
    for (size_t i = 0; i < options->surface.let_count; i++)
        if (!options->surface.lets[i].from_file && strcmp(options->surface.lets[i].name, name) == 0)
            cli_fail(CLI_BAD_INPUT, "--sweep: sets %s; leave its --let out", cli_quote(name).text);
}

render_options render_parse_options(int argc, char **argv) {
    render_options options = {.quality = ALGSURF_QUALITY_STANDARD,
                              .antialias = VIEW_ANTIALIAS,
                              .antialias_threshold = -1,
                              .intersect = {.size = sizeof options.intersect},
                              .space = {.coherence = ALGSURF_COHERENCE_NEIGHBOURS}};
    cli_parse(&program, argc, argv, &options);
    const char *file = options.surface.name;
    cli_settle_surface(&options.surface);
    if (options.surface.file) {
        view_follow(&options.view, options.surface.file);
        render_look_follow(&options.look, options.surface.file);
        options.default_output = picture_of(file);
    }
    view_check(&options.view);
    if (options.list) return options;
    if (options.row_end > options.view.height)
        cli_fail(CLI_BAD_INPUT, "--rows: row %d is below the picture's %d rows", options.row_end,
                 options.view.height);
    check_swept_constant(&options);
    if (options.frame > 0 && options.sweep.pictures == 0)
        cli_fail(CLI_BAD_INPUT, "--frame: plays no part without --sweep");
    if (options.frame > options.sweep.pictures)
        cli_fail(CLI_BAD_INPUT, "--frame: the --sweep has no picture %d, only %d", options.frame,
                 options.sweep.pictures);
    if (options.a_second > 0) check_animation(&options);
    if (options.antialias_threshold > 0 && options.antialias < 2)
        cli_fail(CLI_BAD_INPUT, "--antialias-threshold: plays no part with --antialias 1");
    if (options.antialias_threshold < 0) options.antialias_threshold = VIEW_THRESHOLD;
    if (options.look.light != LIGHT_DEFAULT && options.look.paper)
        cli_fail(CLI_BAD_INPUT, "--light: plays no part with --lights paper");
    if ((options.look.light != LIGHT_DEFAULT || options.look.paper) &&
        options.quality == ALGSURF_QUALITY_PREVIEW)
        cli_fail(CLI_BAD_INPUT, "%s: plays no part in preview quality",
                 options.look.paper ? "--lights" : "--light");
    if (options.thin == THIN_ASKED && options.intersect.method != ALGSURF_METHOD_DEFAULT)
        cli_fail(CLI_BAD_INPUT, "--thin: plays no part with another --method");
    if (options.quality == ALGSURF_QUALITY_FULL) options.space.real_only = "--quality full";
    if (options.heatmap) options.space.real_only = "--heatmap";
    render_check_space(&options.space, &options.sweep);
    check_output(&options);
    return options;
}

const char *render_quality_name(algsurf_quality quality) {
    return quality == ALGSURF_QUALITY_PREVIEW ? "preview"
           : quality == ALGSURF_QUALITY_FULL  ? "full"
                                              : "standard";
}

const char *render_tier_name(int tier) { return tier == ALGSURF_TIER_BOUNDED ? "bounded" : "certified"; }
