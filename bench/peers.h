/* peers.h - what the parts of the comparison with other software share: a contest, and its table. */
#ifndef PEERS_H
#define PEERS_H
#include <stddef.h>

enum { PEERS_MOST_TAKES = 16 };

/* One line of the table: how a program did on one task. */
typedef struct peers_row {
    const char *section, *task; /* section: "pictures", "first root", "all roots" */
    int degree;
    const char *program, *unit;
    double median, least, most;  /* time, in the unit */
    size_t count, missed, extra; /* pictures: hits, pixels lacking and too many; roots: polynomials, roots */
    double error; /* pictures: of the number of hits, per cent; roots: largest, of right ones */
} peers_row;

typedef struct peers_table {
    peers_row *row;
    size_t count, room;
} peers_table;

void peers_add(peers_table *table, const peers_row *row);

/* Sorts the seconds, and puts median and spread in the unit into the row. */
void peers_tell_time(peers_row *row, double *seconds, size_t count, double units_a_second);

/* Somebody who solves the polynomials begin..end-1 of a set, each at any time as often as asked. */
typedef struct peers_contestant {
    const char *program;
    void (*solve)(void *self, size_t begin, size_t end);
    void *self;
    size_t count; /* of polynomials from the start of the set; takes the time budget, or is all of them */
    double seconds[PEERS_MOST_TAKES]; /* for each polynomial */
} peers_contestant;

/* Lets each solve as many of the polynomials as it can in the budget of CPU seconds, at least one. */
void peers_warm_up(peers_contestant *contestant, size_t contestants, size_t polynomials, double budget);

/* Times each on its polynomials, in turn, so many takes. */
void peers_contend(peers_contestant *contestant, size_t contestants, int takes);

/* How much is done. */
typedef struct peers_effort {
    int takes;
    size_t real, complex;        /* polynomials in a set */
    double budget;               /* seconds that a take of one contestant may last, more or less */
    int most_degree;             /* of random polynomials */
    const char *const *surfaces; /* for pictures; ends with a null */
} peers_effort;

void peers_first_roots(const peers_effort *effort, peers_table *table);
void peers_all_roots(const peers_effort *effort, peers_table *table);

/* Where the programs are; null: not here. */
typedef struct peers_programs {
    const char *povray, *surf;
    const char *work; /* a folder to work in */
} peers_programs;

void peers_pictures(const peers_effort *effort, const peers_programs *programs, peers_table *table);

#endif
