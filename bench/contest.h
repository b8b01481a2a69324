/* contest.h - programs that do the same tasks in turn, and the table of how they did. */
#ifndef CONTEST_H
#define CONTEST_H
#include <stddef.h>

#include "measure.h"

/* One line of the table: how a program did on one task. */
typedef struct contest_row {
    const char *section, *task;
    int degree;
    const char *program, *unit;
    measure_takes takes;
    size_t count, missed, extra; /* see the section's chapter */
    double error;
} contest_row;

typedef struct contest_table {
    contest_row *row;
    size_t count, room;
} contest_table;

void contest_add(contest_table *table, const contest_row *row);

/* Somebody who solves the items begin..end-1 of a set, each at any time as often as asked. */
typedef struct contestant {
    contest_row row;
    void (*solve)(void *self, size_t begin, size_t end);
    void *self;
    size_t items; /* from the start of the set; see contest_warm_up */
} contestant;

/* Lets each solve as many of the items as it can in the budget of CPU seconds, at least one; the rows count
 * them. */
void contest_warm_up(contestant *contestants, size_t count, size_t items, double budget);

/* Times each on its items, in turn, so many takes; adds the rows. */
void contest_run(contestant *contestants, size_t count, int takes, contest_table *table);

/* What is told of a section: times are in units of the median of the program "algsurf". */
typedef struct contest_chapter {
    const char *section, *title;    /* some lines, above the table */
    const char *heads[4];           /* of the columns count, missed, extra, error */
    double most_error;              /* more is marked; 0: nothing is */
    const char *caption, *subtitle; /* of the chart */
} contest_chapter;

/* On standard output who is compared, how, and where, and each chapter that has rows; into the folder, unless
 * it is null, NAME.csv and NAME.svg. */
void contest_report(const char *others, int takes, const contest_chapter *chapters, size_t count,
                    const contest_table *table, const char *folder, const char *name);

#endif
