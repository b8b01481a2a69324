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
    CLI_HEADING("The surface"),
    {"--list", NULL,
     "lists the named surfaces: name, degree, equation; \"as NAME\" instead of an\n"
     "equation: the surface NAME, seen from elsewhere",
     cli_set_flag, FIELD(list)},
    CLI_SURFACE_OPTIONS(render_options),
    CLI_HEADING("The view"),
    VIEW_OPTIONS(render_options),
    {"--clip", "A,B,C,D",
     "cuts the surface by a plane: shows only the points with A x + B y + C z <= D.  May\n"
     "be given up to 8 times.  The view stays that of the whole surface",
     cli_set_clip, FIELD(clip)},
    CLI_HEADING("The picture"),
    {"--output", "FILE",
     "the file of the picture, a .png, .bmp or .ppm; also -o.  Default NAME.png, or\n"
     "surface.png for an equation.  - is standard output; there, and into devices and\n"
     "pipes, a .ppm is written",
     cli_set_text, FIELD(output)},
    {"--colour", "COLOUR",
     "the colour of the surface: a name of CSS, as teal, or #rrggbb; default: one for\n"
     "each of its two sides",
     colour_set, FIELD(look.outside)},
    {"--inside", "COLOUR",
     "another colour for the inner side.  That is the side on which the equation's left\n"
     "side is less than its right side: the inside of the ball x^2 + y^2 + z^2 = 1.\n"
     "Default: as --colour, if that is given",
     colour_set, FIELD(look.inside)},
    {"--background", "COLOUR|none",
     "the colour where there is no surface, default white; none: a transparent .png", render_set_background,
     FIELD(look)},
    {"--light", "X,Y,Z|AZ:EL",
     "where the light is: a point of space; or a direction seen from the camera, AZ\n"
     "degrees to the right and EL up, as -40:35.  Default: above on the left",
     render_set_light, FIELD(look)},
    {"--lights", "usual|paper",
     "usual (default): one wide light.  paper: two square lights of 5x5 points, as in\n"
     "the pictures of Chuyeshov (2005).  A file of SURFER has lights of its own;\n"
     "--lights usual leaves them out",
     render_set_lights, FIELD(look)},
    {"--quality", "preview|standard|full",
     "preview: shading by direction alone, as if the camera were the lamp.\n"
     "standard (default): a light, without shadows.\n"
     "full: soft shadows, and less light in hollows; the best picture, and the slowest",
     set_quality, FIELD(quality)},
    {"--antialias", "N",
     "makes edges smooth: a pixel at an edge is the mean of N x N samples, any other\n"
     "pixel has one sample; 1 to 16, default 4; 1: edges stay rough",
     cli_set_int, offsetof(render_options, antialias), 1, 16},
    {"--antialias-threshold", "X",
     "what an edge is for --antialias: red, green or blue of two neighbouring pixels\n"
     "differ by more than X, 0 to 1, default 0.1; 0: all pixels have N x N samples",
     set_threshold, FIELD(antialias_threshold)},
    {"--thin", "COLOUR|none",
     "the colour of parts without width, which rays miss: isolated points, lines,\n"
     "needles.  They are drawn a pixel wide, up to degree 24: by default in the\n"
     "surface's colour; with none they are left out.  An aid to the eye: not proved",
     set_thin, 0, 0, 0},
    {"--axes", NULL,
     "draws the axes x, y and z through 0,0,0, with numbers, as far as --extent goes;\n"
     "what is behind the surface is hidden.  In complex space nothing is",
     cli_set_flag, FIELD(axes)},
    {"--box", NULL,
     "draws a box about --extent, with numbers along its edges.  All is shown so much\n"
     "smaller that the box is seen, unless --eye, --fov, --zoom or --orthographic\n"
     "is given",
     cli_set_flag, FIELD(box)},
    CLI_HEADING("Animations"),
    {"--sweep", "turn:N|let:NAME:A:B:N|delta:A:B:N|imag:K:A:B:N",
     "draws N pictures, NAME-0001.png and so on.  turn: the camera goes once around the\n"
     "surface.  let: the letter NAME of the equation goes from A to B; the view fits the\n"
     "first, middle and last surface at once.  delta, imag: --delta, or the V of\n"
     "--imag K=V, goes from A to B",
     render_set_sweep, FIELD(sweep)},
    {"--animate", "RATE",
     "writes the pictures of --sweep into one animated .png, RATE pictures a second,\n"
     "1 to 60",
     cli_set_int, offsetof(render_options, a_second), 1, 60},
    {"--frame", "K", "draws only picture K of the --sweep, counted from 1", cli_set_int,
     offsetof(render_options, frame), 1, RENDER_MOST_PICTURES},
    CLI_HEADING("How certain, how fast"),
    {"--tier", "certified|bounded",
     "certified (default): for every ray it is proved what it meets, by integers where\n"
     "doubles do not suffice.  bounded: by doubles alone; rays that they leave open are\n"
     "counted as undecided",
     set_tier, 0, 0, 0},
    {"--threads", "N", "how many threads draw, 0 to 256; default 0: one for each processor", cli_set_int,
     offsetof(render_options, threads), 0, 256},
    {"--method", "default|brent|bisection|regula-falsi",
     "how a root is computed when an interval is found that holds it alone; default: the\n"
     "fastest way",
     set_method, 0, 0, 0},
    {"--tolerance", "EPS", "how much the distance of a hit may be wrong, default 0: as little as doubles can",
     set_tolerance, 0, 0, 0},
    {"--kernel", "baseline|avx2|avx512",
     "the instruction set, default the fastest that runs here; the picture is the same\nwith each",
     set_kernel, 0, 0, 0},
    {"--progress", "auto|always|never",
     "shows a bar with the time left on standard error; auto (default): on a terminal", set_progress,
     FIELD(progress)},
    CLI_HEADING("Complex space"),
    {"--sigma", "S",
     "shows complex roots t of the polynomial along each ray from the camera: of those\n"
     "with S <= |arg t| <= S + D, the one of least |t|.  D is the value of --delta, S is\n"
     "in radians, as 0.2 or 7pi/18, default 0.  Not with --method, --tolerance, --tier,\n"
     "--kernel, --quality full",
     render_set_sigma, FIELD(space)},
    {"--delta", "D", "the D of --sigma, in radians; default 1e-10, which shows the real surface",
     render_set_delta, FIELD(space)},
    {"--imag", "K=V",
     "adds the imaginary number V i to the coefficient of t^K of the polynomial along\n"
     "each ray, K from 0 to the degree; repeatable",
     render_set_imaginary, FIELD(space)},
    {"--coherence", "none|neighbours",
     "how complex roots are found.  neighbours (default): from those of neighbouring\n"
     "rays.  none: each ray's from scratch, which takes longer; the picture is the same",
     render_set_coherence, FIELD(space)},
    CLI_HEADING("Slices, for several machines"),
    {"--rows", "A:B",
     "draws only a slice of the picture: rows A to B-1, counted from 0 at the top.\n"
     "Slices in .ppm files can be joined",
     set_rows, 0, 0, 0},
    {"--join", "SLICE.ppm ...",
     "makes a picture of slices; a command of its own, and the first argument:\n"
     "render --join --help",
     set_join, 0, 0, 0},
    CLI_HEADING("Numbers about the picture"),
    {"--hits", "FILE",
     "writes how far from the eye each pixel's hit is: raw little-endian doubles, row\n"
     "by row from the top, t of the hit along the ray of unit length; NaN: no hit",
     cli_set_text, FIELD(hits)},
    {"--heatmap", "FILE",
     "draws a second picture of the work, with a legend: tiles of pixels that one proof\n"
     "decided, empty or with one sheet of the surface; of other pixels, what the ray\n"
     "through the middle cost (intervals and evaluations, as a single ray), and rays\n"
     "that doubles left open.  Files as for --output",
     cli_set_text, FIELD(heatmap)},
    {"--stats", "FILE",
     "writes counts and times, a line 'key<TAB>value' each, or, if FILE ends in .json,\n"
     "an object; - is standard output.\n"
     "rays: samples of the picture; hits, undecided: of these, rays that meet the\n"
     "surface, or are left open; thin: samples that show a thin part;\n"
     "single_rays: rays not solved together with others of their row; exact_rays: of\n"
     "these, decided by integers; empty_rays, sheet_rays: decided by tiles;\n"
     "shadow_rays: rays to lights and around that were solved one by one;\n"
     "tiles: squares of pixels that were looked at as a whole; empty_tiles, sheet_tiles:\n"
     "of these, decided for all of their rays; leaf_tiles: the smallest that were not;\n"
     "iterations: corrections of complex roots, 0 for a real surface;\n"
     "expand_s, solve_s, point_s, shadow_s, shade_s: seconds for the polynomials, their\n"
     "roots, positions and normals, shadows, colours, added up over all threads;\n"
     "total_s: seconds by the clock, without reading and writing files",
     cli_set_text, FIELD(stats)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "render",
    .synopsis = "[options] (NAME | EQUATION | FILE.jsurf | --terms FILE)",
    .about = "Draws an algebraic surface: all points x, y, z at which a polynomial equation holds.\n"
             "NAME is a surface that --list shows.  EQUATION is text in x, y, z, as 'x^2 + y^2 = z^2';\n"
             "without '=' it is taken as \"= 0\".  FILE.jsurf is a file of IMAGINARY's SURFER; options come\n"
             "before its view, parameters and colours.",
    .options = options_table,
    .positional = offsetof(render_options, surface.name),
    .examples = "render barth --output barth.png\n"
                "render 'x^2 + y^2 = z^2' --output cone.png\n"
                "render 'x^4 + y^4 + z^4 = a^4' --let a=1.2 --extent sphere:2 --output cube.png\n"
                "render boy --quality full --output boy.png\n"
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
        cli_fail(CLI_BAD_INPUT, "%s: '-' takes one picture, not a --sweep", option);
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
        cli_fail(CLI_BAD_INPUT, "--heatmap: has no effect with --background none");
    if (options->heatmap) options->heatmap_format = check_image(options, "--heatmap", options->heatmap);
    check_standard_output(options);
}

static void check_animation(const render_options *options) {
    if (options->sweep.pictures == 0) cli_fail(CLI_BAD_INPUT, "--animate: has no effect without --sweep");
    if (options->frame > 0)
        cli_fail(CLI_BAD_INPUT, "--animate: takes all pictures of the --sweep; leave --frame out");
    if (options->row_end > 0) cli_fail(CLI_BAD_INPUT, "--animate: takes whole pictures; leave --rows out");
}

static void check_swept_constant(const render_options *options) {
    const char *name = options->sweep.name;
    if (options->sweep.kind != SWEEP_LET) return;
    if (!options->surface.equation)
        cli_fail(CLI_BAD_INPUT, "--sweep let: only an equation has letters that take values");
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
        cli_fail(CLI_BAD_INPUT, "--rows: the slice ends at row %d, the picture has %d rows", options.row_end,
                 options.view.height);
    check_swept_constant(&options);
    if (options.frame > 0 && options.sweep.pictures == 0)
        cli_fail(CLI_BAD_INPUT, "--frame: has no effect without --sweep");
    if (options.frame > options.sweep.pictures)
        cli_fail(CLI_BAD_INPUT, "--frame: the --sweep has no picture %d, only %d", options.frame,
                 options.sweep.pictures);
    if (options.a_second > 0) check_animation(&options);
    if (options.antialias_threshold > 0 && options.antialias < 2)
        cli_fail(CLI_BAD_INPUT, "--antialias-threshold: has no effect with --antialias 1");
    if (options.antialias_threshold < 0) options.antialias_threshold = VIEW_THRESHOLD;
    if (options.look.light != LIGHT_DEFAULT && options.look.paper)
        cli_fail(CLI_BAD_INPUT, "--light: has no effect with --lights paper");
    int asked = options.look.light == LIGHT_POINT || options.look.light == LIGHT_ANGLES;
    if ((asked || options.look.paper) && options.quality == ALGSURF_QUALITY_PREVIEW)
        cli_fail(CLI_BAD_INPUT, "%s: has no effect in preview quality",
                 options.look.paper ? "--lights" : "--light");
    if (options.thin == THIN_ASKED && options.intersect.method != ALGSURF_METHOD_DEFAULT)
        cli_fail(CLI_BAD_INPUT, "--thin: has no effect with another --method");
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
