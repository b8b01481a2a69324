/* progress.c - see progress.h. */
#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { BAR = 40 };
static const double BETWEEN = 0.1; /* seconds from one update to the next */

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void progress_begin(progress *bar, progress_mode mode, int pictures) {
    bar->shown = mode == PROGRESS_ALWAYS || (mode == PROGRESS_AUTO && isatty(STDERR_FILENO));
    bar->start = bar->last = now();
    bar->picture = 1;
    bar->pictures = pictures;
}

static void print_time(double seconds) {
    long s = (long)(seconds + 0.5);
    if (s >= 3600)
        fprintf(stderr, "%ld:%02ld:%02ld left", s / 3600, s / 60 % 60, s % 60);
    else
        fprintf(stderr, "%ld:%02ld left", s / 60, s % 60);
}

int progress_rows(int rows_done, int rows_total, void *data) {
    progress *bar = data;
    double time = now();
    if (!bar->shown || (rows_done < rows_total && time - bar->last < BETWEEN)) return 0;
    bar->last = time;
    double done = (bar->picture - 1 + (double)rows_done / rows_total) / bar->pictures;
    int filled = (int)(done * BAR);
    static const char full[] = "########################################";
    fprintf(stderr, "\r[%-*.*s] %3d %%  ", BAR, filled, full, (int)(100 * done));
    if (bar->pictures > 1) fprintf(stderr, "picture %d of %d  ", bar->picture, bar->pictures);
    if (done > 0) print_time((time - bar->start) * (1 - done) / done);
    fputs("   ", stderr);
    fflush(stderr);
    return 0;
}

void progress_end(progress *bar) {
    if (bar->shown) fprintf(stderr, "\r%*s\r", 2 * BAR + 10, "");
}
