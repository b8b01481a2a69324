/* degrees.h - code compiled for common degrees and for all others, where it pays.
 *
 * The statement is compiled once for each degree.  So it should be in a function of its own that is called
 * from one place, and should hold nothing that is as fast without a constant degree.  Where it pays, by the
 * time of the task without / with it (bench/pictures, bench/roots):
 *
 *     function                                       degrees          task
 *     pixels: expansion, walk, root; tiles           2 to 6, 8, 10    pictures 1.23
 *     segments: P about points, along rays           2 to 10          full quality 1.56
 *     rays: P at nodes, for packets                  2 3 4 6 8 10     packets 1.35
 *     first and all roots of batches                 2 to 6, 8, 10    batches 1.33
 *     walk of a single polynomial or ray             2 to 6, 8, 10    isolation 1.18, rays 1.10
 *     complex rows                                   2 3 4 6          complex space 1.20
 *     complex boxes                                  3 4              batches 1.13
 *     complex boxes of one polynomial                3 4 6 10         its roots 1.34, 6 and 10 1.20
 *
 * It does not in the search of tiles, and on x86's baseline, which processors before 2013 have need of. */
#ifndef ALGSURF_DEGREES_H
#define ALGSURF_DEGREES_H

/* A sanitizer needs minutes for the code of each degree; there the code for all of them must do. */
#if defined(__SANITIZE_ADDRESS__)
#define INSTRUMENTED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define INSTRUMENTED 1
#endif
#endif
#ifndef INSTRUMENTED
#define INSTRUMENTED 0
#endif

#if INSTRUMENTED || (defined(__x86_64__) && LANES == 2 && !defined(PACKETS_OF_TWO))
#define DEGREES_PAY 0
#else
#define DEGREES_PAY 1
#endif

/* A page loads what a module of WebAssembly holds: half as much.  There only pictures gain from a known
 * degree, 10 to 20 %, and say so by COMMON_DEGREES. */
#if defined(__wasm__)
#define DEGREES_OF_ROOTS 0
#else
#define DEGREES_OF_ROOTS DEGREES_PAY
#endif
#ifndef COMMON_DEGREES
#define COMMON_DEGREES DEGREES_OF_ROOTS
#endif

/* The statement with N = n, a constant for degrees that the list names if `known`. */
#define FOR_DEGREES(known, n, statement, list)                                                               \
    switch ((known) ? (n) : 0) {                                                                             \
        list default : {                                                                                     \
            const int N = (n);                                                                               \
            if (N < 1) __builtin_unreachable();                                                              \
            statement;                                                                                       \
        }                                                                                                    \
    }
#define FOR_ONE_DEGREE(n, statement)                                                                         \
    case n: {                                                                                                \
        enum { N = n };                                                                                      \
        statement;                                                                                           \
        break;                                                                                               \
    }
#define DEGREES_2_TO_4(statement)                                                                            \
    FOR_ONE_DEGREE(2, statement) FOR_ONE_DEGREE(3, statement) FOR_ONE_DEGREE(4, statement)

/* For most: 2 to 6, 8 and 10. */
#define FOR_DEGREE(n, statement) FOR_DEGREE_IF(COMMON_DEGREES, n, statement)
#define FOR_DEGREE_IF(known, n, statement)                                                                   \
    FOR_DEGREES(known, n, statement,                                                                         \
                DEGREES_2_TO_4(statement) FOR_ONE_DEGREE(5, statement) FOR_ONE_DEGREE(6, statement)          \
                    FOR_ONE_DEGREE(8, statement) FOR_ONE_DEGREE(10, statement))

#endif
