/* degrees.h - code compiled for the most common degrees and for all others.
 *
 * The statement is compiled eight times.  So it should be in a function of its own that is called from one
 * place, and should hold nothing that is as fast without a constant degree.  The includer may define
 * COMMON_DEGREES: is there such code? */
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

/* A page loads what a module of WebAssembly holds: half as much.  There only pictures gain from a known
 * degree, 10 to 20 %; single rays and polynomials are as fast without. */
#if defined(__wasm__)
#define DEGREES_EVERYWHERE 0
#else
#define DEGREES_EVERYWHERE !INSTRUMENTED
#endif
#ifndef COMMON_DEGREES
#define COMMON_DEGREES DEGREES_EVERYWHERE
#endif

/* The statement with N = n, a constant for common degrees. */
#define FOR_DEGREE(n, statement) FOR_DEGREE_IF(COMMON_DEGREES, n, statement)
#define FOR_DEGREE_IF(common, n, statement)                                                                  \
    FOR_DEGREES(common, n, statement, FOR_ONE_DEGREE(8, statement) FOR_ONE_DEGREE(10, statement))
/* For what is used up to degree 7 only. */
#define FOR_LOW_DEGREE(n, statement) FOR_DEGREES(COMMON_DEGREES, n, statement, )
#define FOR_DEGREES(common, n, statement, higher)                                                            \
    switch ((common) ? (n) : 0) {                                                                            \
        FOR_ONE_DEGREE(2, statement)                                                                         \
        FOR_ONE_DEGREE(3, statement)                                                                         \
        FOR_ONE_DEGREE(4, statement)                                                                         \
        FOR_ONE_DEGREE(5, statement)                                                                         \
        FOR_ONE_DEGREE(6, statement)                                                                         \
        higher default : {                                                                                   \
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

#endif
