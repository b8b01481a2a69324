/* progress.h - a bar with the time left, on standard error. */
#ifndef PROGRESS_H
#define PROGRESS_H

typedef enum progress_mode { PROGRESS_AUTO, PROGRESS_ALWAYS, PROGRESS_NEVER } progress_mode;

typedef struct progress {
    int shown; /* 0: nothing is printed */
    double start, last;
    int picture, pictures; /* which of how many is being drawn, from 1 */
} progress;

/* Starts the clock.  PROGRESS_AUTO: only when standard error is a terminal. */
void progress_begin(progress *bar, progress_mode mode, int pictures);

/* An algsurf_progress function: data is the progress.  Never cancels. */
int progress_rows(int rows_done, int rows_total, void *data);

/* Removes the bar. */
void progress_end(progress *bar);

#endif
