/* measure.c - see measure.h.
 *
 * CPU time instead of wall time: what else runs on the machine then counts only by what it leaves in the
 * caches.  Random numbers: splitmix64 (Steele, Lea, Flood, Fast splittable pseudorandom number generators,
 * 2014), whose stream is good from any seed.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "measure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "must.h"
#include "portable.h"

#ifndef MEASURE_FLAGS
#define MEASURE_FLAGS "unknown"
#endif

#define LEAST_SECONDS 50e-6   /* reading the clock is a system call of up to half a microsecond: 1 % */
#define MOST_CALLS (1L << 16) /* ends the search on a clock that stands still */

double measure_cpu(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double measure_call(void (*work)(void *data), void *data) {
    for (long calls = 1;; calls *= 2) {
        double begin = measure_cpu();
        for (long i = 0; i < calls; i++) work(data);
        double seconds = measure_cpu() - begin;
        if (seconds >= LEAST_SECONDS || calls >= MOST_CALLS) return seconds / (double)calls;
    }
}

static int compare(const void *left, const void *right) {
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

void measure_sort(double *values, size_t count) { qsort(values, count, sizeof *values, compare); }

double measure_quantile(const double *values, size_t count, double share) {
    double rank = ceil(share * (double)count), *sorted = must_allocate(count, sizeof *sorted);
    for (size_t i = 0; i < count; i++) sorted[i] = values[i];
    measure_sort(sorted, count);
    double quantile = count > 0 ? sorted[rank < 1 ? 0 : (size_t)rank - 1] : NAN;
    free(sorted);
    return quantile;
}

void measure_take(measure_takes *to, double seconds) { to->seconds[to->count++] = seconds; }

double measure_taken(const measure_takes *t, double share) {
    return measure_quantile(t->seconds, t->count, share);
}

uint64_t measure_bits(measure_random *random) {
    uint64_t z = random->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double measure_uniform(measure_random *random, double lo, double hi) {
    double unit = (double)(measure_bits(random) >> 11) * 0x1p-53;
    return lo + (hi - lo) * unit;
}

/* What /proc/cpuinfo calls the processor, where there is such a file and it has a name. */
static void processor_name(char *name, int size) {
    char line[256];
    snprintf(name, (size_t)size, "unknown processor");
    FILE *file = fopen("/proc/cpuinfo", "r");
    if (!file) return;
    while (fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !colon) continue;
        colon += 1 + strspn(colon + 1, " \t");
        snprintf(name, (size_t)size, "%.*s", (int)strcspn(colon, "\n"), colon);
        break;
    }
    fclose(file);
}

void measure_machine(char *line, size_t size) {
#ifdef __clang__
    const char *family = "";
#else
    const char *family = "gcc "; /* clang's version names itself */
#endif
    char name[128];
    long cores = portable_processors();
    processor_name(name, sizeof name);
    snprintf(line, size, "%s, %ld core%s; %s%s; %s", name, cores, cores == 1 ? "" : "s", family, __VERSION__,
             MEASURE_FLAGS);
}

void measure_head(const char *mark, const char *const *texts) {
    char machine[512];
    for (; *texts; texts++)
        for (const char *line = *texts; *line; line += strcspn(line, "\n") + 1)
            printf("%s%.*s\n", mark, (int)strcspn(line, "\n"), line);
    measure_machine(machine, sizeof machine);
    printf("%smachine: %s\n", mark, machine);
}
