/* render_join.c - see render_join.h. */
#include "render_join.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "output.h"
#include "render_slice.h"

typedef struct join_options {
    const char *output, *hits;
    image_format format;
} join_options;

typedef struct piece {
    const char *path;
    render_slice slice;
    long pixels; /* where they start in the file */
} piece;

#define FIELD(member) offsetof(join_options, member), 0, 0

static const cli_option options_table[] = {
    {"--output", "FILE", "the picture: .png, .bmp or .ppm; - is a PPM on standard output", cli_set_text,
     FIELD(output)},
    {"--hits", "FILE",
     "the distances too: those of SLICE.ppm are read from SLICE.hits, as\n"
     "--rows A:B --output SLICE.ppm --hits SLICE.hits wrote them",
     cli_set_text, FIELD(hits)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "render --join",
    .synopsis = "--output FILE [--hits FILE] SLICE.ppm ...",
    .about = "Joins slices that --rows drew, here or elsewhere, in any order: the files are those\n"
             "that a run without --rows writes.  Rows that are missing or there twice, damaged files\n"
             "and slices of different pictures are reported, and nothing is written.",
    .options = options_table,
    .examples = "render barth --rows 0:384 --output upper.ppm\n"
                "render barth --rows 384:768 --output lower.ppm\n"
                "render --join --output barth.png upper.ppm lower.ppm",
};

static size_t rows_of(const render_slice *slice) { return (size_t)(slice->end - slice->begin); }

/* A path to be quoted: its end, which is what differs. */
static cli_quoted name(const char *path) {
    size_t length = strlen(path), room = sizeof(cli_quoted) - 4;
    return cli_quote(length > room ? path + (length - room) : path);
}

static FILE *open_file(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file) cli_fail(CLI_BAD_INPUT, "%s: %s", name(path).text, strerror(errno));
    return file;
}

/* ---- the files' heads ---- */

/* The next line without its end; 0 when it is none or too long. */
static int read_line(FILE *file, char *line, int room) {
    if (!fgets(line, room, file)) return 0;
    char *end = strchr(line, '\n');
    if (end) *end = '\0';
    return end != NULL;
}

static int read_head(FILE *file, render_slice *slice) {
    char line[sizeof(render_slice_note) + 2], size[32];
    if (!read_line(file, line, sizeof line) || strcmp(line, "P6") != 0) return 0;
    if (!read_line(file, line, sizeof line) || strncmp(line, "# ", 2) != 0) return 0;
    if (!render_slice_read(line + 2, slice)) return 0;
    snprintf(size, sizeof size, "%d %d", slice->width, slice->end - slice->begin);
    if (!read_line(file, line, sizeof line) || strcmp(line, size) != 0) return 0;
    return read_line(file, line, sizeof line) && strcmp(line, "255") == 0;
}

static piece read_piece(const char *path) {
    piece p = {.path = path};
    FILE *file = open_file(path);
    if (!read_head(file, &p.slice))
        cli_fail(CLI_BAD_INPUT, "%s: not a .ppm that render --rows wrote", name(path).text);
    p.pixels = ftell(file);
    size_t expected = 3 * (size_t)p.slice.width * rows_of(&p.slice);
    if (p.pixels < 0 || fseek(file, 0, SEEK_END) != 0 || ftell(file) < 0)
        cli_fail(CLI_BAD_INPUT, "%s: not a regular file", name(path).text);
    size_t found = (size_t)(ftell(file) - p.pixels);
    if (found != expected)
        cli_fail(CLI_BAD_INPUT, "%s: damaged: %zu bytes of pixels instead of %zu", name(path).text, found,
                 expected);
    fclose(file);
    return p;
}

/* ---- do they make one picture? ---- */

static void check_same(const piece *a, const piece *b) {
    const render_slice *s = &a->slice, *t = &b->slice;
    if (s->width != t->width || s->height != t->height)
        cli_fail(CLI_BAD_INPUT, "%s and %s are of different pictures, %dx%d and %dx%d", name(a->path).text,
                 name(b->path).text, s->width, s->height, t->width, t->height);
    if (s->job != t->job)
        cli_fail(CLI_BAD_INPUT, "%s and %s are of different pictures: drawn with other options or versions",
                 name(a->path).text, name(b->path).text);
}

static int by_rows(const void *a, const void *b) {
    const render_slice *s = &((const piece *)a)->slice, *t = &((const piece *)b)->slice;
    return s->begin != t->begin ? s->begin - t->begin : s->end - t->end;
}

static void check_rows(const piece *pieces, int count) {
    int next = 0, height = pieces[0].slice.height;
    for (int i = 0; i < count; i++) {
        const render_slice *s = &pieces[i].slice;
        if (s->begin > next) cli_fail(CLI_BAD_INPUT, "rows %d:%d are missing", next, s->begin);
        if (s->begin < next)
            cli_fail(CLI_BAD_INPUT, "rows %d:%d are in both %s and %s", s->begin,
                     s->end < next ? s->end : next, name(pieces[i - 1].path).text, name(pieces[i].path).text);
        next = s->end;
    }
    if (next < height) cli_fail(CLI_BAD_INPUT, "rows %d:%d are missing", next, height);
}

/* ---- the files' contents ---- */

static void read_pixels(const piece *p, uint8_t *pixels) {
    size_t row = 3 * (size_t)p->slice.width, bytes = row * rows_of(&p->slice);
    uint8_t *to = pixels + row * (size_t)p->slice.begin;
    FILE *file = open_file(p->path);
    if (fseek(file, p->pixels, SEEK_SET) != 0 || fread(to, 1, bytes, file) != bytes ||
        render_pixels_digest(to, bytes) != p->slice.pixels)
        cli_fail(CLI_BAD_INPUT, "%s: damaged: its pixels have changed since it was written",
                 name(p->path).text);
    fclose(file);
}

/* SLICE.hits for SLICE.ppm; to be freed. */
static char *hits_path(const char *path) {
    size_t length = strlen(path);
    image_format format;
    char *hits = malloc(length + sizeof ".hits");
    if (!hits) cli_no_memory();
    if (image_format_of(path, &format)) length -= strlen(".ppm");
    memcpy(hits, path, length);
    strcpy(hits + length, ".hits");
    return hits;
}

/* Little-endian doubles, to the end of the file. */
static int read_doubles(FILE *file, double *to, size_t count) {
    uint8_t bytes[8];
    for (size_t i = 0; i < count; i++) {
        uint64_t bits = 0;
        if (fread(bytes, 1, sizeof bytes, file) != sizeof bytes) return 0;
        for (int b = 7; b >= 0; b--) bits = bits << 8 | bytes[b];
        memcpy(&to[i], &bits, sizeof bits);
    }
    return getc(file) == EOF;
}

static void read_hits(const piece *p, double *hits) {
    size_t width = (size_t)p->slice.width, count = width * rows_of(&p->slice);
    double *to = hits + width * (size_t)p->slice.begin;
    if (p->slice.hits == 0)
        cli_fail(CLI_BAD_INPUT, "--hits: %s was drawn without --hits", name(p->path).text);
    char *path = hits_path(p->path);
    FILE *file = open_file(path);
    if (!read_doubles(file, to, count) || render_hits_digest(to, count) != p->slice.hits)
        cli_fail(CLI_BAD_INPUT, "%s: not the hits of %s", name(path).text, name(p->path).text);
    fclose(file);
    free(path);
}

static void join(const join_options *options, const piece *pieces, int count) {
    int width = pieces[0].slice.width, height = pieces[0].slice.height;
    size_t pixel_count = (size_t)width * (size_t)height;
    uint8_t *pixels = malloc(3 * pixel_count);
    double *hits = options->hits ? malloc(pixel_count * sizeof *hits) : NULL;
    if (!pixels || (options->hits && !hits)) cli_no_memory();
    for (int i = 0; i < count; i++) read_pixels(&pieces[i], pixels);
    for (int i = 0; i < count && hits; i++) read_hits(&pieces[i], hits);
    output_set set = {.count = 0};
    if (hits) output_hits(&set, options->hits, hits, pixel_count);
    output_image(&set, options->output, options->format, width, height, pixels);
    output_commit(&set);
    free(pixels);
    free(hits);
}

int render_join(int argc, char **argv) {
    join_options options = {.output = NULL};
    int count = cli_parse_files(&program, argc, argv, &options);
    if (!options.output) cli_fail(CLI_BAD_INPUT, "expected --output FILE; see --help");
    if (count == 0) cli_fail(CLI_BAD_INPUT, "expected the slices, .ppm files; see --help");
    options.format = render_image_format("--output", options.output);
    if (options.hits && strcmp(options.hits, "-") == 0 && strcmp(options.output, "-") == 0)
        cli_fail(CLI_BAD_INPUT, "only one of --output, --hits can be '-'");
    piece *pieces = malloc((size_t)count * sizeof *pieces);
    if (!pieces) cli_no_memory();
    for (int i = 0; i < count; i++) {
        pieces[i] = read_piece(argv[1 + i]);
        check_same(&pieces[0], &pieces[i]);
    }
    qsort(pieces, (size_t)count, sizeof *pieces, by_rows);
    check_rows(pieces, count);
    join(&options, pieces, count);
    free(pieces);
    return 0;
}
