/* jsurf_file.c - fuzzes the reader of SURFER's files in examples/.
 *
 * What is accepted has an equation, numbers in their ranges, and a camera whose axes are orthonormal; what is
 * refused is refused with one line without control characters, about a line that exists.
 */
#include "jsurf_file.h"
#include "cli.h"
#include "fuzz.h"

static void check_colour(const css_colour *c) { fuzz_check(c->given == 0 || c->given == 1); }

static void check(const jsurf_file *read) {
    double up = 0, back = 0, across = 0, number;
    fuzz_check(read->equation);
    for (int i = 0; i < 3; i++) {
        up += read->up[i] * read->up[i];
        back += read->back[i] * read->back[i];
        across += read->up[i] * read->back[i];
    }
    fuzz_check(fabs(up - 1) < 0.01 && fabs(back - 1) < 0.01 && fabs(across) < 0.01);
    fuzz_check(read->radius > 1e-100 && read->radius < 1e100);
    fuzz_check(read->fov > 0 && read->fov < 180 && read->height > 0 && isfinite(read->height));
    for (size_t i = 0; i < read->parameter_count; i++) {
        fuzz_check(cli_numbers(read->parameters[i].value, ',', 1, &number) || read->parameters[i].value[0]);
        for (size_t k = 0; k < i; k++)
            fuzz_check(strcmp(read->parameters[i].name, read->parameters[k].name) != 0);
    }
    check_colour(&read->front), check_colour(&read->inside), check_colour(&read->background);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size == 0) return 0; /* fmemopen may refuse it */
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "rb");
    fuzz_check(file);
    size_t lines = 1;
    for (size_t i = 0; i < size; i++) lines += data[i] == '\n';
    jsurf_file read;
    jsurf_error error;
    int result = jsurf_read(file, &read, &error);
    fclose(file);
    if (result == 0) {
        check(&read);
        jsurf_release(&read);
        return 0;
    }
    fuzz_check(result == -1 && !error.no_memory && error.message[0] && error.line <= lines);
    for (const char *c = error.message; *c; c++) fuzz_check((*c >= ' ' && *c != 0x7f) || *c < 0);
    return 0;
}
