/* output.c - see output.h. */
#define _POSIX_C_SOURCE 200809L
#include "output.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli.h"
#include "portable.h"

_Noreturn void output_fail(const output_set *set, const char *path, const char *why) {
    for (int i = 0; i < set->count; i++) {
        if (!set->files[i].temporary) continue;
        if (set->files[i].open) (void)fclose(set->files[i].open); /* Windows removes no open file */
        remove(set->files[i].temporary);
        portable_forget(set->files[i].temporary);
    }
    if (strcmp(path, "-") == 0) cli_fail(CLI_BROKEN, "cannot write to standard output: %s", why);
    cli_fail(CLI_BROKEN, "cannot write '%s': %s", cli_quote(path).text, why);
}

/* The links of /dev, such as /dev/stdout, stand for what is open, even where they lead to a file. */
static int is_device_link(const char *path) { return strncmp(path, "/dev/", 5) == 0; }

int output_is_special(const char *path) {
    if (portable_kind_of(path) != PORTABLE_OTHER) return 0;
    portable_kind behind = portable_kind_behind(path);
    return behind == PORTABLE_OTHER || (behind == PORTABLE_FILE && is_device_link(path));
}

/* A file that is there must be one that can be written. */
static void check_existing(const output_set *set, const char *path) {
    if (portable_kind_of(path) == PORTABLE_NOTHING) return;
    portable_kind kind = portable_kind_behind(path);
    if (kind == PORTABLE_NOTHING) output_fail(set, path, "a link to a file that does not exist");
    if (kind == PORTABLE_FOLDER) output_fail(set, path, strerror(EISDIR));
    if (access(path, W_OK) != 0) output_fail(set, path, strerror(errno));
}

/* The file itself, where the path is a link to it. */
static char *follow(const output_set *set, const char *path) {
    char *target = NULL;
    if (portable_kind_of(path) == PORTABLE_OTHER) {
        target = portable_path_behind(path);
        if (!target) output_fail(set, path, strerror(errno));
        return target;
    }
    target = malloc(strlen(path) + 1);
    if (!target) output_fail(set, path, "out of memory");
    return strcpy(target, path);
}

/* Creates a file beside the path that did not exist before. */
static FILE *open_beside(const output_set *set, const char *path, char **name) {
    int folder = portable_folder_length(path);
    size_t room = (size_t)folder + 64;
    FILE *file;
    *name = malloc(room);
    if (!*name) output_fail(set, path, "out of memory");
    for (int i = 0; i < 100; i++) {
        snprintf(*name, room, "%.*s.algsurf-%ld-%d.part", folder, path, (long)getpid(), i);
        portable_remember(*name);
        file = portable_create(*name, path);
        if (file) return file;
        int why = errno;
        portable_forget(*name);
        errno = why;
        if (why != EEXIST) break;
    }
    output_fail(set, path, strerror(errno));
}

FILE *output_open(output_set *set, const char *path) {
    if (strcmp(path, "-") == 0) return stdout;
    output_file out = {path, NULL, NULL, NULL};
    check_existing(set, path);
    if (output_is_special(path)) {
        out.open = fopen(path, "wb");
        if (!out.open) output_fail(set, path, strerror(errno));
    } else {
        out.target = follow(set, path);
        out.open = open_beside(set, out.target, &out.temporary);
    }
    set->files[set->count++] = out;
    return out.open;
}

void output_close(output_set *set, const char *path, FILE *file) {
    if (fflush(file) != 0 || ferror(file)) output_fail(set, path, strerror(errno));
    if (file == stdout) return;
    set->files[set->count - 1].open = NULL;
    if (fclose(file) != 0) output_fail(set, path, strerror(errno));
}

static void check_one(const char *path) {
    output_set none = {.count = 0};
    check_existing(&none, path);
    if (output_is_special(path)) return;
    char *name, *target = follow(&none, path);
    fclose(open_beside(&none, target, &name));
    remove(name);
    portable_forget(name);
    free(name);
    free(target);
}

void output_check(const char *const *written, int count, const char *read) {
    for (int i = 0; i < count; i++) {
        const char *path = written[i];
        if (!path || strcmp(path, "-") == 0) continue;
        check_one(path);
        if (output_is_special(path)) continue;
        for (int j = 0; j < i; j++)
            if (written[j] && portable_is_same(path, written[j]))
                cli_fail(CLI_BAD_INPUT, "'%s' is to be written twice", cli_quote(path).text);
        if (read && portable_is_same(path, read))
            cli_fail(CLI_BAD_INPUT, "'%s' is read, and is to be written", cli_quote(path).text);
    }
}

void output_image(output_set *set, const char *path, image_format format, int width, int height,
                  const uint8_t *pixels) {
    FILE *file = output_open(set, path);
    const char *wrong = image_write(file, format, width, height, pixels);
    if (wrong) output_fail(set, path, wrong);
    output_close(set, path, file);
}

void output_alpha(output_set *set, const char *path, int width, int height, const uint8_t *pixels) {
    FILE *file = output_open(set, path);
    const char *wrong = image_write_alpha(file, width, height, pixels);
    if (wrong) output_fail(set, path, wrong);
    output_close(set, path, file);
}

void output_ppm(output_set *set, const char *path, const char *comment, int width, int height,
                const uint8_t *pixels) {
    FILE *file = output_open(set, path);
    image_write_ppm(file, comment, width, height, pixels);
    output_close(set, path, file);
}

void output_hits(output_set *set, const char *path, const double *hits, size_t count) {
    FILE *file = output_open(set, path);
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        uint8_t bytes[8];
        memcpy(&bits, &hits[i], sizeof bits);
        for (int b = 0; b < 8; b++) bytes[b] = (uint8_t)(bits >> 8 * b);
        fwrite(bytes, 1, sizeof bytes, file);
    }
    output_close(set, path, file);
}

void output_text(output_set *set, const char *path, const char *text) {
    FILE *file = output_open(set, path);
    fputs(text, file);
    output_close(set, path, file);
}

void output_commit(output_set *set) {
    for (int i = 0; i < set->count; i++) {
        output_file *out = &set->files[i];
        if (!out->temporary) continue;
        if (portable_rename(out->temporary, out->target) != 0) output_fail(set, out->path, strerror(errno));
        portable_forget(out->temporary);
        free(out->temporary);
        free(out->target);
        out->temporary = out->target = NULL;
    }
}
