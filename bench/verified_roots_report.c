/* verified_roots_report.c - see verified_roots_report.h: what is printed. */
#include "verified_roots_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "measure.h"

static const char legend[] =
    "Boxes proved to enclose all complex roots of a polynomial, and what they cost.\n"
    "  surface    along rays of random pixels of its view in the catalogue, re-centred, the chord inside\n"
    "             its extent scaled to [-1,1]; random-N: coefficients uniform in [-1,1] x [-1,1] i.\n"
    "             Coefficients count as exact.\n"
    "  solver     robust: algsurf_complex_solver_run; paper: algsurf_paper_zeros\n"
    "  start      cold: its own (robust), 0 + i (paper); near: the roots of the ray a pixel to the left\n"
    "  complete%  polynomials with all roots in verified boxes that are disjoint\n"
    "  simple%    roots verified to be simple and alone in their box, each counted once\n"
    "  ulps50%    width of verified boxes, median: real or imaginary part, whichever is wider, in units\n"
    "             in the last place of that part of the value (of the other part if the box straddles\n"
    "             an axis; a part that is exact counts 0)\n"
    "  ulps99%    the width that 99 of 100 boxes do not exceed\n"
    "  us50%      CPU time for all roots of a polynomial, microseconds, median\n";

static const char more_legend[] =
    "  degree-N   as random-N; near: the roots of one whose coefficients differ by up to a thousandth\n"
    "  cluster-K-GAP  degree 12, roots in the unit disc, K of them on a circle, GAP from one to the next;\n"
    "             the coefficients are rounded, which spreads K roots to about (1e-16)^(1/K); GAP 0: one\n"
    "             root K times, exactly\n";

enum { COLUMNS = 10, CELL = 24 };

static const struct column {
    const char *title;
    int width; /* negative: flush left */
} columns[COLUMNS] = {{"surface", -15}, {"degree", 6},  {"polynomials", 11}, {"solver", -6}, {"start", -5},
                      {"complete%", 9}, {"simple%", 8}, {"ulps50%", 9},      {"ulps99%", 9}, {"us50%", 9}};

static void put_width(char *cell, double ulps) {
    if (isnan(ulps))
        snprintf(cell, CELL, "-");
    else
        snprintf(cell, CELL, "%.3g", ulps);
}

static void print_cell(int k, const char *text, int tsv) {
    if (tsv)
        printf("%s%s", k > 0 ? "\t" : "", text);
    else
        printf("%s%*s", k > 0 ? "  " : "", columns[k].width, text);
}

static void print_row(const row *r, int tsv) {
    char cell[COLUMNS][CELL];
    snprintf(cell[0], CELL, "%s", r->family);
    snprintf(cell[1], CELL, "%d", r->degree);
    snprintf(cell[2], CELL, "%zu", r->polynomials);
    snprintf(cell[3], CELL, "%s", r->solver);
    snprintf(cell[4], CELL, "%s", r->start);
    snprintf(cell[5], CELL, "%.2f", r->complete);
    snprintf(cell[6], CELL, "%.2f", r->simple);
    put_width(cell[7], r->ulps50);
    put_width(cell[8], r->ulps99);
    snprintf(cell[9], CELL, "%.2f", r->us);
    for (int k = 0; k < COLUMNS; k++) print_cell(k, cell[k], tsv);
    putchar('\n');
}

void report_table(const row *rows, int count, int seed, int tsv) {
    const char *mark = tsv ? "# " : "";
    measure_print_lines(legend, mark);
    if (rows[count - 1].cluster > 0) measure_print_lines(more_legend, mark);
    measure_print_machine(mark);
    printf("%sseed: %d\n%s", mark, seed, tsv ? "#" : "\n");
    for (int k = 0; k < COLUMNS; k++) print_cell(k, columns[k].title, tsv);
    putchar('\n');
    for (int i = 0; i < count; i++) print_row(&rows[i], tsv);
}
