/* truth_corpus.c - tab-separated tables and the corpus's surfaces. */
#include "truth_corpus.h"

#include "terms_file.h"

_Noreturn void truth_give_up(const char *what, const char *which) {
    fprintf(stderr, "corpus: %s: %s\n", what, which);
    exit(2);
}

const char *truth_folder(int argc, char **argv) {
    if (argc != 2) truth_give_up("expected the data's folder after", argv[0]);
    return argv[1];
}

static char *read_whole(const char *path, size_t *length) {
    FILE *file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END) != 0) truth_give_up("cannot open", path);
    long end = ftell(file);
    rewind(file);
    char *text = end >= 0 ? malloc((size_t)end + 1) : NULL;
    if (!text || fread(text, 1, (size_t)end, file) != (size_t)end) truth_give_up("cannot read", path);
    fclose(file);
    *length = (size_t)end;
    text[*length] = '\0';
    return text;
}

truth_table truth_read(const char *folder, const char *name, size_t columns) {
    char path[1024];
    snprintf(path, sizeof path, "%s/truth/%s", folder, name);
    size_t length, lines = 0, tabs = 0;
    truth_table t = {.text = read_whole(path, &length), .columns = columns};
    for (size_t i = 0; i < length; i++) {
        lines += t.text[i] == '\n';
        tabs += t.text[i] == '\t';
    }
    if (lines < 2 || tabs != lines * (columns - 1)) truth_give_up("not a table of the expected width", path);
    t.rows = lines - 1;
    t.cell = malloc(t.rows * columns * sizeof *t.cell);
    if (!t.cell) truth_give_up("no memory for", path);
    char *next = strchr(t.text, '\n') + 1;
    for (size_t i = 0; i < t.rows * columns; i++) {
        t.cell[i] = next;
        next += strcspn(next, "\t\n");
        *next++ = '\0';
    }
    return t;
}

void truth_free(truth_table *t) {
    free(t->cell);
    free(t->text);
    *t = (truth_table){0};
}

double truth_number(const char *text) {
    char *end;
    double x = strtod(text, &end);
    if (end == text || *end) truth_give_up("not a number", text);
    return x;
}

algsurf_ray truth_ray(char *const field[8]) {
    double v[8];
    for (size_t i = 0; i < 8; i++) v[i] = truth_number(field[i]);
    return (algsurf_ray){{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], v[7]};
}

const algsurf_surface *truth_surface(const char *folder, const char *name) {
    static algsurf_surface *surface;
    static char kept[64];
    if (name && surface && strcmp(kept, name) == 0) return surface;
    algsurf_surface_free(surface);
    surface = NULL;
    if (!name) return NULL;
    char path[1024];
    snprintf(path, sizeof path, "%s/surfaces/%s.terms", folder, name);
    FILE *file = fopen(path, "rb");
    terms_error error;
    if (!file || terms_read_surface(file, &surface, &error) != 0) truth_give_up("cannot read", path);
    fclose(file);
    snprintf(kept, sizeof kept, "%s", name);
    return surface;
}
