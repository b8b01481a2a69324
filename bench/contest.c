/* contest.c - see contest.h: who solves how many, and how long that takes. */
#include "contest.h"

#include <stdlib.h>

#include "cli.h"

void contest_add(contest_table *table, const contest_row *row) {
    if (table->count == table->room) {
        table->room = 2 * table->room + 64;
        table->row = realloc(table->row, table->room * sizeof *table->row);
        if (!table->row) cli_no_memory();
    }
    table->row[table->count++] = *row;
}

void contest_warm_up(contestant *contestants, size_t count, size_t items, double budget) {
    for (contestant *c = contestants; c < contestants + count; c++) {
        double begun = measure_cpu();
        size_t size = 1;
        for (c->items = 0; c->items < items && measure_cpu() - begun < budget; size *= 2) {
            size_t end = c->items + size < items ? c->items + size : items;
            c->solve(c->self, c->items, end);
            c->row.count = c->items = end;
        }
    }
}

void contest_run(contestant *contestants, size_t count, int takes, contest_table *table) {
    for (int take = 0; take < takes; take++)
        for (contestant *c = contestants; c < contestants + count; c++) {
            double begun = measure_cpu();
            size_t rounds = 0;
            do {
                c->solve(c->self, 0, c->items);
                rounds++;
            } while (measure_cpu() - begun < 2e-3);
            measure_take(&c->row.takes, (measure_cpu() - begun) / (double)(rounds * c->items));
        }
    for (size_t k = 0; k < count; k++) contest_add(table, &contestants[k].row);
}
