/* measure.h - what every benchmark shares: time, order statistics, random numbers, heads of reports. */
#ifndef MEASURE_H
#define MEASURE_H
#include <stddef.h>
#include <stdint.h>

/* CPU seconds that all threads of this process have used; never goes back. */
double measure_cpu(void);

/* CPU seconds of one call of work(data), averaged over as many calls as the clock needs to tell. */
double measure_call(void (*work)(void *data), void *data);

/* Into increasing order; no value may be NaN. */
void measure_sort(double *values, size_t count);

/* The least of the values, in any order, that at least that share of them does not exceed: share 0 is the
 * minimum, 0.5 the median (the lower one of two), 1 the maximum.  NaN if there are none. */
double measure_quantile(const double *values, size_t count, double share);

/* How long one thing took, again and again. */
enum { MEASURE_MOST_TAKES = 100 };
typedef struct measure_takes {
    size_t count;
    double seconds[MEASURE_MOST_TAKES];
} measure_takes;

void measure_take(measure_takes *to, double seconds);
double measure_taken(const measure_takes *t, double share); /* the quantile */

/* A generator of random numbers; any seed will do. */
typedef struct measure_random {
    uint64_t state;
} measure_random;

uint64_t measure_bits(measure_random *random);
double measure_uniform(measure_random *random, double lo, double hi); /* in [lo, hi] */

/* Processor, number of cores, compiler and flags of this build, in one line without its end. */
void measure_machine(char *line, size_t size);

/* The head of a report on standard output: the lines of some texts, a null behind the last, and "machine: "
 * with that line.  The mark comes before each: "# " where programs are to read the report, else "". */
void measure_head(const char *mark, const char *const *texts);

#endif
