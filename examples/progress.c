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

static void print_time(double seconds) {
    long s = (long)(seconds + 0.5);
    if (s >= 3600)
        fprintf(stderr, "%ld:%02ld:%02ld left", s / 3600, s / 60 % 60, s % 60);
    else
        fprintf(stderr, "%ld:%02ld left", s / 60, s % 60);
}

/* The bar, and the number of the picture. */
static void print_bar(const progress *bar) {
    static const char full[] = "########################################";
    int filled = (int)(bar->done * BAR);
    fprintf(stderr, "\r[%-*.*s] %3d %%  ", BAR, filled, full, (int)(100 * bar->done));
    if (bar->pictures > 1) fprintf(stderr, "picture %d of %d  ", bar->picture, bar->pictures);
}

void progress_begin(progress *bar, progress_mode mode, int pictures) {
    bar->shown = mode == PROGRESS_ALWAYS || (mode == PROGRESS_AUTO && isatty(STDERR_FILENO));
    bar->start = bar->last = now();
    bar->picture = 1;
    bar->pictures = pictures;
    bar->done = 0;
    progress_say(bar, "");
}

int progress_rows(int rows_done, int rows_total, void *data) {
    progress *bar = data;
    double time = now();
    if (!bar->shown || (rows_done < rows_total && time - bar->last < BETWEEN)) return 0;
    bar->last = time;
    bar->done = (bar->picture - 1 + (double)rows_done / rows_total) / bar->pictures;
    print_bar(bar);
    if (bar->done > 0) print_time((time - bar->start) * (1 - bar->done) / bar->done);
    fputs("   ", stderr);
    fflush(stderr);
    return 0;
}

void progress_say(progress *bar, const char *what) {
    if (!bar->shown) return;
    print_bar(bar);
    fprintf(stderr, "%-14s", what); /* as long as a time left may be */
    fflush(stderr);
}

void progress_begin_lines(progress *bar) {
    bar->shown = isatty(STDERR_FILENO) && !isatty(STDIN_FILENO) && !isatty(STDOUT_FILENO);
    bar->start = bar->last = now();
}

void progress_lines(progress *bar, size_t lines) {
    if (!bar->shown) return;
    double time = now();
    if (time - bar->start < 1 || time - bar->last < 5 * BETWEEN) return;
    bar->last = time;
    fprintf(stderr, "\r%zu lines, %.0f a second ", lines, (double)lines / (time - bar->start));
    fflush(stderr);
}

void progress_end(progress *bar) {
    if (bar->shown) fprintf(stderr, "\r%*s\r", 2 * BAR + 10, "");
}
