/* output.h - files that are whole or not there.
 *
 * A regular file is written beside its target under another name, and renamed when all files of its
 * set are complete; whatever goes wrong before, an interruption too, it is removed and the target is as it
 * was.  A target that exists keeps its permissions; links are followed, but for those that lead nowhere.  A
 * target that is no regular file (a device, a pipe) is written directly, "-" is standard output.  Every
 * function here ends the program, status 1, with one line when it cannot do its work.
 */
#ifndef OUTPUT_H
#define OUTPUT_H
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "image.h"

typedef struct output_file {
    const char *path;
    char *temporary; /* null: written directly */
    char *target;    /* the path, its links followed; null with temporary */
    FILE *open;      /* null once it is closed */
} output_file;

/* The files of one picture; starts with all zero. */
typedef struct output_set {
    output_file files[4];
    int count;
} output_set;

/* Whether the path is, or leads to, a device or a pipe: there, but neither a regular file nor a folder. */
int output_is_special(const char *path);

/* Tells early whether the files of one command can be written: tries, and leaves nothing behind.  Two that
 * are the same, or one that is read, too, are refused, but for devices.  Null: none. */
void output_check(const char *const *written, int count, const char *read);

void output_image(output_set *set, const char *path, image_format format, int width, int height,
                  const uint8_t *pixels);
void output_alpha(output_set *set, const char *path, int width, int height, const uint8_t *pixels);
void output_ppm(output_set *set, const char *path, const char *comment, int width, int height,
                const uint8_t *pixels);
void output_hits(output_set *set, const char *path, const double *hits, size_t count);
void output_text(output_set *set, const char *path, const char *text);

/* For what a program writes itself: a file of the set to write to, and to close before the next one; or the
 * end of the program, with one line, after which none of the set's files is there. */
FILE *output_open(output_set *set, const char *path);
void output_close(output_set *set, const char *path, FILE *file);
_Noreturn void output_fail(const output_set *set, const char *path, const char *why);

/* Gives all files of the set their names. */
void output_commit(output_set *set);

#endif
