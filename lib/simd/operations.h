/* operations.h - what each kernel computes with, for base/rounding.h. */
#ifndef ALGSURF_OPERATIONS_H
#define ALGSURF_OPERATIONS_H
#include "../base/rounding.h"
#include "kernel.h"

extern const algsurf_i_operations algsurf_i_operations_avx512, algsurf_i_operations_avx2,
    algsurf_i_operations_baseline;

const algsurf_i_operations *algsurf_i_operations_of(const algsurf_i_kernel *kernel);

#endif
