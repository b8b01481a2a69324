/* contest.c - see contest.h: who solves how many, and how long that takes. */
#include "contest.h"

#include <stdlib.h>

#include "cli.h"
#include "measure.h"

void contest_add(contest_table *table, const contest_row *row) {
    if (table->count == table->room) {
        table->room = 2 * table->room + 64;
        table->row = realloc(table->row, table->room * sizeof *table->row);
        if (!table->row) cli_no_memory();
    }
    table->row[table->count++] = *row;
}

void contest_tell_time(contest_row *row, double *seconds, size_t count, double units_a_second) {
    measure_sort(seconds, count);
    row->median = units_a_second * measure_quantile(seconds, count, 0.5);
    row->least = units_a_second * seconds[0];
    row->most = units_a_second * seconds[count - 1];
}

void contest_warm_up(contestant *contestants, size_t count, size_t items, double budget) {
    for (contestant *c = contestants; c < contestants + count; c++) {
        double begun = measure_cpu();
        size_t size = 1;
        for (c->count = 0; c->count < items && measure_cpu() - begun < budget; size *= 2) {
            size_t end = c->count + size < items ? c->count + size : items;
            c->solve(c->self, c->count, end);
            c->count = end;
        }
    }
}

void contest_run(contestant *contestants, contest_row *row, size_t count, int takes, double units_a_second,
                 contest_table *table) {
    for (int take = 0; take < takes; take++)
        for (contestant *c = contestants; c < contestants + count; c++) {
            double begun = measure_cpu();
            size_t rounds = 0;
            do {
                c->solve(c->self, 0, c->count);
                rounds++;
            } while (measure_cpu() - begun < 2e-3);
            c->seconds[take] = (measure_cpu() - begun) / (double)(rounds * c->count);
        }
    for (size_t k = 0; k < count; k++) {
        contest_tell_time(&row[k], contestants[k].seconds, (size_t)takes, units_a_second);
        contest_add(table, &row[k]);
    }
}
