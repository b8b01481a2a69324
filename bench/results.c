/* results.c - see results.h. */
#include "results.h"

#include <errno.h>
#include <string.h>

#include "portable.h"

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

void results_begin(const cli_program *program, int argc, char **argv, void *options,
                   const char *const *folder) {
    if (cli_parse_files(program, argc, argv, options) > 0)
        cli_fail(CLI_BAD_INPUT, "unexpected '%s'", cli_quote(argv[1]).text);
    if (!*folder || portable_make_folder(*folder) == 0) return;
    int why = errno;
    if (portable_kind_of(join(*folder, ".").text) == PORTABLE_FOLDER) return;
    errno = why;
    fail(*folder);
}

FILE *results_open(const char *folder, const char *name, const char *mode) {
    FILE *file = fopen(join(folder, name).text, mode);
    if (!file) fail(name);
    return file;
}

void results_finish(FILE *file, const char *folder, const char *name) {
    int written = fflush(file) == 0 && !ferror(file);
    if (fclose(file) == 0 && written) return;
    (void)remove(join(folder, name).text);
    fail(name);
}
