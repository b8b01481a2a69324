/* results.c - see results.h. */
#define _POSIX_C_SOURCE 200809L /* mkdir, stat */
#include "results.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "cli.h"

typedef struct path {
    char text[4096];
} path;

static path join(const char *folder, const char *name) {
    path p;
    if (snprintf(p.text, sizeof p.text, "%s/%s", folder, name) >= (int)sizeof p.text)
        cli_fail(CLI_BAD_INPUT, "--output: the name is too long");
    return p;
}

_Noreturn static void fail(const char *name) {
    cli_fail(CLI_BROKEN, "cannot write %s: %s", cli_quote(name).text, strerror(errno));
}

void results_folder(const char *folder) {
    struct stat about;
    if (mkdir(folder, 0777) == 0) return;
    int why = errno;
    if (stat(folder, &about) == 0 && S_ISDIR(about.st_mode)) return;
    errno = why;
    fail(folder);
}

FILE *results_create(const char *folder, const char *name) {
    FILE *file = fopen(join(folder, name).text, "wb");
    if (!file) fail(name);
    return file;
}

void results_finish(FILE *file, const char *folder, const char *name) {
    int written = fflush(file) == 0 && !ferror(file);
    if (fclose(file) == 0 && written) return;
    (void)remove(join(folder, name).text);
    fail(name);
}

void results_plot(const plot *plots, size_t count, const char *folder, const char *name) {
    if (plot_write_column(plots, count, join(folder, name).text) != 0) fail(name);
}
