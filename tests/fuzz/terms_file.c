/* terms_file.c - fuzzes the reader of terms files in examples/.
 *
 * What is accepted must come out the same when it is written and read again; what is refused must be refused
 * with one line without control characters about a line that exists.
 */
#include "terms_file.h"
#include "fuzz.h"

static FILE *file_of(const void *bytes, size_t size) {
    FILE *file = fmemopen((void *)(uintptr_t)bytes, size, "rb");
    fuzz_check(file);
    return file;
}

static size_t lines_of(const uint8_t *data, size_t size) {
    size_t lines = 1;
    for (size_t i = 0; i < size; i++) lines += data[i] == '\n';
    return lines;
}

/* The surface's terms; to be freed. */
static algsurf_term *terms_of(const algsurf_surface *surface, size_t *count) {
    *count = algsurf_surface_term_count(surface);
    algsurf_term *terms = malloc(*count * sizeof *terms + 1);
    fuzz_check(terms && *count > 0);
    fuzz_check(algsurf_surface_terms(surface, terms) == ALGSURF_OK);
    return terms;
}

static void check_surface(const algsurf_surface *surface) {
    size_t count, again_count;
    algsurf_term *terms = terms_of(surface, &count);
    size_t room = count * 64, length = 0;
    char *text = malloc(room);
    fuzz_check(text);
    for (size_t i = 0; i < count; i++) {
        const algsurf_term *t = &terms[i];
        fuzz_check(isfinite(t->a) && t->a != 0);
        length += (size_t)snprintf(text + length, room - length, "%d %d %d %.17g\n", t->i, t->j, t->k, t->a);
    }
    algsurf_surface *again;
    terms_error error;
    FILE *file = file_of(text, length);
    fuzz_check(terms_read_surface(file, &again, &error) == 0);
    fclose(file);
    algsurf_term *same = terms_of(again, &again_count);
    fuzz_check(again_count == count);
    for (size_t i = 0; i < count; i++)
        fuzz_check(terms[i].i == same[i].i && terms[i].j == same[i].j && terms[i].k == same[i].k &&
                   terms[i].a == same[i].a);
    algsurf_surface_free(again);
    free(same), free(text), free(terms);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size == 0) return 0; /* fmemopen may refuse it */
    FILE *file = file_of(data, size);
    algsurf_surface *const untouched = (algsurf_surface *)(void *)&file, *surface = untouched;
    terms_error error;
    int result = terms_read_surface(file, &surface, &error);
    fclose(file);
    if (result == 0) {
        check_surface(surface);
        algsurf_surface_free(surface);
        return 0;
    }
    fuzz_check(result == -1 && surface == untouched && !error.no_memory);
    fuzz_check(error.message[0] && error.line <= lines_of(data, size));
    for (const char *c = error.message; *c; c++) fuzz_check((*c >= ' ' && *c != 0x7f) || *c < 0);
    return 0;
}
