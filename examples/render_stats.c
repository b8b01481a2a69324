/* render_stats.c - see render_stats.h. */
#include "render_stats.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "table.h"

/* What the surface was given as, in one line. */
static char *surface_text(const cli_surface *surface) {
    const char *text = surface->name ? surface->name : surface->equation ? surface->equation : surface->terms;
    char *line = malloc(strlen(text) + 1);
    if (!line) cli_no_memory();
    strcpy(line, text);
    for (char *c = line; *c; c++)
        if (iscntrl((unsigned char)*c)) *c = ' ';
    return line;
}

static int has_ending(const char *path, const char *ending) {
    size_t length = strlen(path), n = strlen(ending);
    return length > n && strcmp(path + length - n, ending) == 0;
}

/* Lines "key<TAB>value" as one JSON object. */
static void write_members(output_set *set, const char *path, const char *lines) {
    FILE *file = output_open(set, path);
    for (const char *at = lines; *at;) {
        size_t key = strcspn(at, "\t"), value = strcspn(at + key + 1, "\n");
        fputs(at == lines ? "{" : ",\n ", file);
        table_member(file, at, key, at + key + 1, value, at == lines); /* the first one is the surface */
        at += key + 1 + value + 1;
    }
    fputs("}\n", file);
    output_close(set, path, file);
}

void render_write_stats(output_set *set, const char *path, const render_options *options,
                        const algsurf_surface *surface, const algsurf_render_stats *stats) {
    static const char format[] =
        "surface\t%s\ndegree\t%d\nwidth\t%d\nheight\t%d\nquality\t%s\nspace\t%s\ntier\t%s\nkernel\t%s\n"
        "threads\t%d\nrays\t%" PRIu64 "\nhits\t%" PRIu64 "\nundecided\t%" PRIu64 "\nthin\t%" PRIu64
        "\nsingle_rays\t%" PRIu64 "\nexact_rays\t%" PRIu64 "\nempty_rays\t%" PRIu64 "\nsheet_rays\t%" PRIu64
        "\nshadow_rays\t%" PRIu64 "\niterations\t%" PRIu64 "\ntiles\t%" PRIu64 "\nempty_tiles\t%" PRIu64
        "\nsheet_tiles\t%" PRIu64 "\nleaf_tiles\t%" PRIu64
        "\nexpand_s\t%.17g\nsolve_s\t%.17g\npoint_s\t%.17g\nshadow_s\t%.17g\nshade_s\t%.17g\ntotal_s\t%.17g\n"
        "version\t%s\n";
    enum { NUMBERS = 32 * 32 }; /* room for what the format's fields become */
    int is_complex = options->space.is_complex;
    char *name = surface_text(&options->surface);
    size_t room = sizeof format + strlen(name) + NUMBERS;
    char *text = malloc(room);
    if (!text) cli_no_memory();
    snprintf(text, room, format, name, algsurf_surface_degree(surface), options->view.width,
             options->view.height, render_quality_name(options->quality), is_complex ? "complex" : "real",
             is_complex ? "-" : render_tier_name(options->intersect.tier), stats->kernel, stats->threads,
             stats->rays, stats->hits, stats->undecided, stats->thin, stats->single_rays, stats->exact_rays,
             stats->empty_rays, stats->sheet_rays, stats->shadow_rays, stats->iterations, stats->tiles,
             stats->empty_tiles, stats->sheet_tiles, stats->leaf_tiles, stats->expand_s, stats->solve_s,
             stats->point_s, stats->shadow_s, stats->shade_s, stats->total_s, algsurf_version());
    if (has_ending(path, ".json"))
        write_members(set, path, text);
    else
        output_text(set, path, text);
    free(text);
    free(name);
}
