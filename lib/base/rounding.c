/* rounding.c - the operands that tell how operations round.
 *
 * The answers are those of IEEE 754, worked out by hand.  Behind each stands what gives another one. */
#include "arithmetic.h"
#include "rounding.h"

#include <string.h>

static double sum(double a, double b) { return a + b; }
static double product(double a, double b) { return a * b; }
static double quotient(double a, double b) { return a / b; }
static double root(double a) { return sqrt(a); }
static double product_and_sum(double a, double b, double c) { return a * b + c; }

const algsurf_i_operations algsurf_i_operations_plain = {
    sum, product, quotient, root, product_and_sum, algsurf_multiply_add, algsurf_two_sum, algsurf_two_prod};

enum operation { SUM, PRODUCT, QUOTIENT, ROOT, PRODUCT_AND_SUM, FUSED, TWO_SUM, TWO_PRODUCT };

typedef struct example {
    enum operation operation;
    double a, b, c, hi, lo; /* hi, or hi + lo, is the answer */
} example;

static const example examples[] = {
    {SUM, 1, 0x1p-53, 0, 1, 0},                                   /* upward */
    {SUM, 1 + 0x1p-52, 0x1p-53, 0, 1 + 0x1p-51, 0},               /* downward, toward zero */
    {SUM, -1 - 0x1p-52, -0x1p-53, 0, -1 - 0x1p-51, 0},            /* upward, toward zero */
    {SUM, 1, 0x1.000001p-53, 0, 1 + 0x1p-52, 0},                  /* first to 64 bits: a tie */
    {SUM, 0x1p-1074, 0x1p-1074, 0, 0x1p-1073, 0},                 /* subnormal operands are zero */
    {SUM, 0x1.8p-1022, -0x1p-1022, 0, 0x1p-1023, 0},              /* subnormal results are zero */
    {PRODUCT, 1 + 0x1p-27, 1 - 0x1p-27, 0, 1, 0},                 /* downward */
    {PRODUCT, 0x1p-1022, 0x1p-1, 0, 0x1p-1023, 0},                /* subnormal results are zero */
    {PRODUCT, 0x1p-1074, 0x1p1000, 0, 0x1p-74, 0},                /* subnormal operands are zero */
    {QUOTIENT, 49, 49, 0, 1, 0},                                  /* 49 times the rounded 1/49 */
    {QUOTIENT, 1, 3, 0, 0x1.5555555555555p-2, 0},                 /* upward */
    {QUOTIENT, 0x1p-1022, 3, 0, 0x0.5555555555555p-1022, 0},      /* subnormal results are zero */
    {ROOT, 2, 0, 0, 0x1.6a09e667f3bcdp+0, 0},                     /* an approximation; downward */
    {ROOT, 3, 0, 0, 0x1.bb67ae8584caap+0, 0},                     /* an approximation; upward */
    {ROOT, 0x1p-1074, 0, 0, 0x1p-537, 0},                         /* subnormal operands are zero */
    {PRODUCT_AND_SUM, 1 + 0x1p-27, 1 - 0x1p-27, -1, 0, 0},        /* one rounding; more digits */
    {PRODUCT_AND_SUM, 1 + 0x1p-27, -1 + 0x1p-27, 1, 0, 0},        /* likewise */
    {FUSED, 1 + 0x1p-27, 1 - 0x1p-27, -1, -0x1p-54, 0},           /* two roundings */
    {FUSED, 1 + 0x1p-52, 1 + 0x1p-52, -1 - 0x1p-51, 0x1p-104, 0}, /* first to 64 bits */
    {TWO_SUM, 1, 0x1p-60, 0, 1, 0x1p-60},                         /* s - a is taken for b */
    {TWO_SUM, 0x1p-60, 1, 0, 1, 0x1p-60},                         /* likewise */
    {TWO_SUM, 1 + 0x1p-52, 0x1p-53, 0, 1 + 0x1p-51, -0x1p-53},    /* more digits */
    {TWO_PRODUCT, 1 + 0x1p-52, 1 + 0x1p-52, 0, 1 + 0x1p-51, 0x1p-104},
    {TWO_PRODUCT, 1 + 0x1p-27, 1 - 0x1p-27, 0, 1, -0x1p-54},
    {TWO_PRODUCT, 2 - 0x1p-52, 2 - 0x1p-52, 0, 4 - 0x1p-50, 0x1p-104},
};

static algsurf_dd answer(const algsurf_i_operations *o, const example *e) {
    if (e->operation == TWO_SUM) return o->two_sum(e->a, e->b);
    if (e->operation == TWO_PRODUCT) return o->two_product(e->a, e->b);
    return algsurf_dd_from(e->operation == SUM               ? o->sum(e->a, e->b)
                           : e->operation == PRODUCT         ? o->product(e->a, e->b)
                           : e->operation == QUOTIENT        ? o->quotient(e->a, e->b)
                           : e->operation == ROOT            ? o->root(e->a)
                           : e->operation == PRODUCT_AND_SUM ? o->product_and_sum(e->a, e->b, e->c)
                           : o->fused                        ? o->fused(e->a, e->b, e->c)
                                                             : e->hi);
}

/* Bits are compared: where numbers are, the compiler's mood has a say again. */
int algsurf_i_rounds(const algsurf_i_operations *o) {
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        algsurf_dd got = answer(o, examples + i), right = {examples[i].hi, examples[i].lo};
        if (memcmp(&got, &right, sizeof got) != 0) return 0;
    }
    return 1;
}
