/* progress.h - a bar with the time left, or how many lines were read, on standard error. */
#ifndef PROGRESS_H
#define PROGRESS_H
#include <stddef.h>

typedef enum progress_mode { PROGRESS_AUTO, PROGRESS_ALWAYS, PROGRESS_NEVER } progress_mode;

typedef struct progress {
    int shown; /* 0: nothing is printed */
    double start, last;
    int picture, pictures; /* which of how many is being drawn, from 1 */
    double done;           /* of all of them, 0 to 1 */
} progress;

/* Starts the clock, and shows an empty bar.  PROGRESS_AUTO: only when standard error is a terminal. */
void progress_begin(progress *bar, progress_mode mode, int pictures);

/* An algsurf_progress function: data is the progress.  Never cancels. */
int progress_rows(int rows_done, int rows_total, void *data);

/* What is being done, in place of the time left, until the next row. */
void progress_say(progress *bar, const char *what);

/* For a program that reads lines: a count of them, when standard error is a terminal and nobody types or
 * reads them; twice a second, from the first second on. */
void progress_begin_lines(progress *bar);
void progress_lines(progress *bar, size_t lines);

/* Removes the bar, or the count. */
void progress_end(progress *bar);

#endif
