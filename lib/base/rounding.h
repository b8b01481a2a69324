/* base/rounding.h - do the operations of a file round as the proofs need?
 *
 * Every bound in this library counts roundings: + - * / and the square root round once each, to the nearest
 * double, ties to even, down to the smallest subnormal one.  A compiler that was told to may fuse a * b + c
 * into one rounding, keep more digits in a register, flush what is subnormal, or reorder sums, file by file.
 * So each file in question has a function for each operation, compiled with the file's options, and these are
 * tried on a few operands for which another rounding gives another result. */
#ifndef ALGSURF_ROUNDING_H
#define ALGSURF_ROUNDING_H
#include "eft.h"

/* What a file computes with. */
typedef struct algsurf_i_operations {
    double (*sum)(double a, double b);
    double (*product)(double a, double b);
    double (*quotient)(double a, double b);
    double (*root)(double a);
    double (*product_and_sum)(double a, double b, double c); /* a * b + c, two roundings */
    double (*fused)(double a, double b, double c);           /* the same, one; null: not used */
    algsurf_dd (*two_sum)(double a, double b);
    algsurf_dd (*two_product)(double a, double b);
} algsurf_i_operations;

/* 1 if they round as they should in the floating-point environment that is set, as far as the operands chosen
 * in rounding.c tell. */
int algsurf_i_rounds(const algsurf_i_operations *o);

/* Those of eft.h and of C, as compiled in rounding.c. */
extern const algsurf_i_operations algsurf_i_operations_plain;

#endif
