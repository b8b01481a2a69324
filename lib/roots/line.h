/* line.h - the real roots of one polynomial in an interval of the line, by whatever decides them first. */
#ifndef ALGSURF_LINE_H
#define ALGSURF_LINE_H
#include "algsurf/isolate.h"
#include "coefficients.h"
#include "watch.h"

enum { ALGSURF_I_ALL, ALGSURF_I_FIRST, ALGSURF_I_NUMBER };

/* What is asked: of p, exact and checked, the roots in [lo,hi], lo <= hi, ends infinite or not. */
typedef struct algsurf_i_line {
    algsurf_i_coefficients p;
    const algsurf_integer *z; /* not null: these are the coefficients, and p.c is null */
    double lo, hi;
    int wanted;                   /* all; the first; or how many, without places, on the whole line */
    int refined;                  /* 1: between neighbouring doubles; 0: isolated, multiple ones refined */
    const algsurf_i_watch *watch; /* null: nobody looks */
    int wide;                     /* 1: isolated, the wider the better */
} algsurf_i_line;

/* roots, in order, with room for as many as the degree says, at least one: lo = hi is a root, else there is
 * one in (lo,hi), the sign of p at lo being that before it; members are those of algsurf_real_root, .root
 * only where refined.  Returns OK or E_NO_MEMORY. */
algsurf_status algsurf_i_line_solve(const algsurf_i_line *line, algsurf_real_root *roots, int *count);

#endif
