/* value.h - the values that expressions take: polynomials that know how they were made.
 *
 * Multiplying by (x+y+z+1)^32 term by term is 6545 steps for each term of the other factor; multiplying 32
 * times by x+y+z+1 is 128.  So a value with many more terms than its text has keeps its factors and summands.
 */
#ifndef ALGSURF_EQUATION_VALUE_H
#define ALGSURF_EQUATION_VALUE_H
#include "poly.h"

typedef struct algsurf_i_value {
    algsurf_i_tripoly p;
    struct algsurf_i_way *way; /* how it was made; null: by nothing shorter */
} algsurf_i_value;

void algsurf_i_value_free(algsurf_i_value *v);
void algsurf_i_value_negate(algsurf_i_value *v);

/* Functions below that return a status fail as those of poly.h do; then the values that they change are
 * freed. */

/* *left *= right, which is taken over.  Cost: at most the steps by which right was made of constants and
 * variables, exponents counted as repetitions, times the terms of the results. */
algsurf_status algsurf_i_value_multiply(algsurf_i_value *left, algsurf_i_value *right);

/* *v /= b, not zero, or v^n, n >= 0. */
algsurf_status algsurf_i_value_divide(algsurf_i_value *v, const algsurf_i_monomial *b);
algsurf_status algsurf_i_value_raise(algsurf_i_value *v, int n);

/* A sum of many values, all 0 at first. */
typedef struct algsurf_i_value_sum {
    algsurf_i_sum plain;       /* of values without a way */
    struct algsurf_i_way *way; /* of the others */
} algsurf_i_value_sum;

/* Adds v and takes it over. */
algsurf_status algsurf_i_value_sum_add(algsurf_i_value_sum *sum, algsurf_i_value *v);

/* Moves the total to *out unless there was a failure already; the sum is empty then in any case. */
algsurf_status algsurf_i_value_sum_finish(algsurf_i_value_sum *sum, algsurf_status status,
                                          algsurf_i_value *out);

#endif
