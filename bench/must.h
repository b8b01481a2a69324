/* must.h - what a benchmark cannot do without: or the end of the program, with a line that says why. */
#ifndef MUST_H
#define MUST_H
#include <stdlib.h>

#include "algsurf/status.h"
#include "cli.h"

/* The call succeeded. */
static inline void must(algsurf_status status, const char *what) {
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "%s: %s", what, algsurf_status_text(status));
}

/* The call succeeded, or is honestly undecided. */
static inline void must_answer(algsurf_status status, const char *what) {
    if (status < 0) must(status, what);
}

/* Memory for so many, all zero. */
static inline void *must_allocate(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) cli_no_memory();
    return memory;
}

#endif
