/* operations.c - the table of kernels' operations. */
#include "../base/arithmetic.h"
#include "operations.h"

const algsurf_i_operations *algsurf_i_operations_of(const algsurf_i_kernel *kernel) {
    static const algsurf_i_operations *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_operations);
    return table[kernel->index];
}
