/* kernel.h - the instruction sets that the packet code is compiled for, and which of them this machine has.
 *
 * A kernel is one of them.  The packet code itself is one text for each room, X_template.h, instantiated by
 * X_avx512.c, X_avx2.c and X_baseline.c; each room keeps a table of what they offer, in the order of
 * algsurf_i_kernel.index.
 *
 * All kernels give the same bits: each lane is rounded as a double alone would be, and no result depends on
 * how many lanes there are.  None of them decides a sign inside its error bound; a lane that would have to
 * reports it as undecided.  To be called in the standard floating-point environment. */
#ifndef ALGSURF_KERNEL_H
#define ALGSURF_KERNEL_H

/* Answers of a lane. */
enum { ALGSURF_LANE_MISS = 0, ALGSURF_LANE_HIT = 1, ALGSURF_LANE_UNDECIDED = 2 };

/* The initializer of a table by index: what is named for each kernel, without those that the processor's
 * family does not have, or that ALGSURF_NO_AVX512, ALGSURF_NO_AVX2 leave out. */
enum { ALGSURF_AVX512, ALGSURF_AVX2, ALGSURF_BASELINE, ALGSURF_KERNELS };
#if defined(__x86_64__) && !defined(ALGSURF_NO_AVX512)
#define ALGSURF_OF_AVX512(name) name##_avx512
#else
#define ALGSURF_OF_AVX512(name) 0
#endif
#if defined(__x86_64__) && !defined(ALGSURF_NO_AVX2)
#define ALGSURF_OF_AVX2(name) name##_avx2
#else
#define ALGSURF_OF_AVX2(name) 0
#endif
#define ALGSURF_KERNEL_TABLE(name)                                                                           \
    { ALGSURF_OF_AVX512(name), ALGSURF_OF_AVX2(name), name##_baseline }

typedef struct algsurf_i_kernel {
    const char *name;
    int index; /* in tables */
} algsurf_i_kernel;

/* A room's tables, algsurf_i_room_kernel for each kernel, and which of them is a kernel's: a header of the
 * room declares them, one file defines the choice. */
#define ALGSURF_KERNEL_TABLES(room)                                                                          \
    extern const algsurf_i_##room##_kernel algsurf_i_##room##_avx512, algsurf_i_##room##_avx2,               \
        algsurf_i_##room##_baseline;                                                                         \
    const algsurf_i_##room##_kernel *algsurf_i_##room##_kernel_for(const algsurf_i_kernel *kernel)
#define ALGSURF_KERNEL_CHOICE(room)                                                                          \
    const algsurf_i_##room##_kernel *algsurf_i_##room##_kernel_for(const algsurf_i_kernel *kernel) {         \
        static const algsurf_i_##room##_kernel *const table[ALGSURF_KERNELS] =                               \
            ALGSURF_KERNEL_TABLE(&algsurf_i_##room);                                                         \
        return table[kernel->index];                                                                         \
    }

/* The kernels this processor and operating system can run, the fastest first; null beyond the last. */
const algsurf_i_kernel *algsurf_i_kernel_at(int index);

/* The kernel of that name, or the fastest one for null, if this processor and operating system can run it;
 * null otherwise. */
const algsurf_i_kernel *algsurf_i_kernel_find(const char *name);

#endif
