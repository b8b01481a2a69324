/* contest.h - programs that do the same tasks in turn, and the table of how they did. */
#ifndef CONTEST_H
#define CONTEST_H
#include <stddef.h>

enum { CONTEST_MOST_TAKES = 16 };

/* Somebody who solves the items begin..end-1 of a set, each at any time as often as asked. */
typedef struct contestant {
    const char *program;
    void (*solve)(void *self, size_t begin, size_t end);
    void *self;
    size_t count;                       /* of items from the start of the set; see contest_warm_up */
    double seconds[CONTEST_MOST_TAKES]; /* for each item */
} contestant;

/* Lets each solve as many of the items as it can in the budget of CPU seconds, at least one: its count. */
void contest_warm_up(contestant *contestants, size_t count, size_t items, double budget);

/* One line of the table: how a program did on one task. */
typedef struct contest_row {
    const char *section, *task;
    int degree;
    const char *program, *unit;
    double median, least, most;  /* time, in the unit */
    size_t count, missed, extra; /* see the section's chapter */
    double error;
} contest_row;

typedef struct contest_table {
    contest_row *row;
    size_t count, room;
} contest_table;

void contest_add(contest_table *table, const contest_row *row);

/* Sorts the seconds, and puts median and spread in the unit into the row. */
void contest_tell_time(contest_row *row, double *seconds, size_t count, double units_a_second);

/* Times each on its items, in turn, so many takes; adds the rows, one of each, with the times. */
void contest_run(contestant *contestants, contest_row *row, size_t count, int takes, double units_a_second,
                 contest_table *table);

/* What is told of a section: times are in units of the median of the program "algsurf". */
typedef struct contest_chapter {
    const char *section, *title;                       /* some lines, above the table */
    const char *unit, *count, *missed, *extra, *error; /* heads of columns */
    double most_error;                                 /* more is marked; 0: nothing is */
    const char *caption, *subtitle;                    /* of the chart */
} contest_chapter;

/* The head of a report: who is compared, how, and where. */
void contest_head(const char *others, int takes);

/* Each chapter that has rows, on standard output. */
void contest_print(const contest_chapter *chapters, size_t count, const contest_table *table);

/* NAME.csv and NAME.svg in the folder. */
void contest_write(const contest_chapter *chapters, size_t count, const contest_table *table,
                   const char *folder, const char *name);

#endif
