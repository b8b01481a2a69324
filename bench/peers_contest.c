/* peers_contest.c - see peers.h: who solves how many, and how long that takes. */
#include <stdlib.h>

#include "cli.h"
#include "measure.h"
#include "peers.h"
#include "peers_solver.h"

#include <math.h>

void peers_add(peers_table *table, const peers_row *row) {
    if (table->count == table->room) {
        table->room = 2 * table->room + 64;
        table->row = realloc(table->row, table->room * sizeof *table->row);
        if (!table->row) cli_no_memory();
    }
    table->row[table->count++] = *row;
}

void peers_tell_time(peers_row *row, double *seconds, size_t count, double units_a_second) {
    measure_sort(seconds, count);
    row->median = units_a_second * measure_quantile(seconds, count, 0.5);
    row->least = units_a_second * seconds[0];
    row->most = units_a_second * seconds[count - 1];
}

void peers_warm_up(peers_contestant *contestant, size_t contestants, size_t polynomials, double budget) {
    for (peers_contestant *c = contestant; c < contestant + contestants; c++) {
        double begun = measure_cpu();
        size_t size = 1;
        for (c->count = 0; c->count < polynomials && measure_cpu() - begun < budget; size *= 2) {
            size_t end = c->count + size < polynomials ? c->count + size : polynomials;
            c->solve(c->self, c->count, end);
            c->count = end;
        }
    }
}

void peers_contend(peers_contestant *contestant, size_t contestants, int takes) {
    for (int take = 0; take < takes; take++)
        for (peers_contestant *c = contestant; c < contestant + contestants; c++) {
            double begun = measure_cpu();
            c->solve(c->self, 0, c->count);
            c->seconds[take] = (measure_cpu() - begun) / (double)c->count;
        }
}

double peer_least(const peer_root *roots, int count) {
    double least = NAN;
    for (int i = 0; i < count; i++)
        if (roots[i].im == 0 && fabs(roots[i].re) <= 1 && !(roots[i].re >= least)) least = roots[i].re;
    return least;
}
