/* gallery_sheet.c - all named surfaces in one picture, each with its name below: gallery_sheet --help.
 *
 * Each is what `render NAME --size 232x174 --quality full` draws.
 */
#include <stdlib.h>
#include <string.h>

#include "canvas.h"
#include "catalogue.h"
#include "cli_surface.h"
#include "output.h"
#include "progress.h"
#include "view.h"

enum { COLUMNS = 5, TILE_WIDTH = 232, TILE_HEIGHT = 174 };
enum { GAP = 4, CAPTION_HEIGHT = 36 }; /* below a tile: to its name, and with the space below that */
enum { WIDTH = COLUMNS * TILE_WIDTH, ROW_HEIGHT = TILE_HEIGHT + CAPTION_HEIGHT };

typedef struct sheet_options {
    const char *extra; /* a plain argument, which this program does not take */
    const char *output;
} sheet_options;

static const cli_option options_table[] = {
    {"--output", "FILE", ".png, .bmp, .ppm by its ending, default sheet.png; - is a PPM on standard\noutput",
     cli_set_text, offsetof(sheet_options, output), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "gallery_sheet",
    .synopsis = "[options]",
    .about = "Draws all named surfaces in one picture, each with its name.",
    .options = options_table,
    .positional = offsetof(sheet_options, extra),
};

static void demand(algsurf_status status, const char *name) {
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "%s: %s", name, algsurf_status_text(status));
}

static int is_second_name(const catalogue_entry *entry) { return catalogue_first_of(entry) != entry; }

static int count_surfaces(void) {
    int count = 0;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) count += !is_second_name(entry);
    return count;
}

/* A tile whose upper left corner is at (x,y) of the sheet. */
static void draw_tile(const canvas *sheet, int x, int y, const catalogue_entry *entry, progress *bar) {
    const view_options size = {.width = TILE_WIDTH, .height = TILE_HEIGHT};
    const view shown = view_make(&size, entry);
    const algsurf_camera camera = view_camera(&shown, 0, 1);
    const algsurf_render_options how = {.size = sizeof how,
                                        .width = TILE_WIDTH,
                                        .height = TILE_HEIGHT,
                                        .progress = progress_rows,
                                        .progress_data = bar};
    const algsurf_picture tile = {.size = sizeof tile,
                                  .pixels = sheet->pixels + 3 * ((size_t)y * WIDTH + (size_t)x),
                                  .stride = 3 * (size_t)WIDTH};
    cli_surface name = {.name = entry->name};
    algsurf_surface *surface = cli_make_surface(&name);
    algsurf_scene *scene;
    demand(algsurf_scene_create(surface, &scene), entry->name);
    const algsurf_material material = view_material(scene, entry);
    demand(algsurf_scene_set_extent(scene, &shown.extent), entry->name);
    demand(algsurf_scene_set_camera(scene, &camera), entry->name);
    demand(algsurf_scene_set_material(scene, &material), entry->name);
    demand(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_FULL), entry->name);
    demand(algsurf_scene_set_antialias(scene, VIEW_ANTIALIAS), entry->name);
    demand(algsurf_scene_set_antialias_threshold(scene, VIEW_THRESHOLD), entry->name);
    demand(algsurf_scene_set_thin(scene, material.outside), entry->name);
    demand(algsurf_render(scene, &how, &tile, NULL), entry->name);
    algsurf_scene_free(scene);
    algsurf_surface_free(surface);
    canvas_write(sheet, x + (TILE_WIDTH - canvas_text_width(entry->name)) / 2, y + TILE_HEIGHT + GAP,
                 entry->name);
}

/* Row by row, the last one in the middle. */
static void draw_sheet(const canvas *sheet, int count) {
    int i = 0;
    progress bar;
    progress_begin(&bar, PROGRESS_AUTO, count);
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        if (is_second_name(entry)) continue;
        int row = i / COLUMNS, left = count - row * COLUMNS, in_row = left < COLUMNS ? left : COLUMNS;
        int x = (COLUMNS - in_row) * TILE_WIDTH / 2 + i % COLUMNS * TILE_WIDTH;
        bar.picture = i + 1;
        draw_tile(sheet, x, row * ROW_HEIGHT, entry, &bar);
        i++;
    }
    progress_end(&bar);
}

int main(int argc, char **argv) {
    sheet_options o = {.output = "sheet.png"};
    image_format format = IMAGE_PPM;
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s': all surfaces are drawn", cli_quote(o.extra).text);
    if (!image_format_of(o.output, &format) && strcmp(o.output, "-") != 0 && !output_is_special(o.output))
        cli_fail(CLI_BAD_INPUT, "--output: expected a name ending in .png, .bmp or .ppm, got '%s'",
                 cli_quote(o.output).text);
    output_check(&o.output, 1, NULL);
    int count = count_surfaces(), height = (count + COLUMNS - 1) / COLUMNS * ROW_HEIGHT;
    size_t bytes = 3 * (size_t)WIDTH * (size_t)height;
    canvas sheet = {malloc(bytes), WIDTH};
    if (!sheet.pixels) cli_no_memory();
    memset(sheet.pixels, 255, bytes);
    draw_sheet(&sheet, count);

    output_set files = {.count = 0};
    output_image(&files, o.output, format, WIDTH, height, sheet.pixels);
    output_commit(&files);
    free(sheet.pixels);
    return 0;
}
