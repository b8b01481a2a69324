/* algsurf/status.h - outcomes, limits, version, and the words guarantees are stated in.
 *
 * Vocabulary.  Every comment of this library uses these words in one sense only:
 *   encloses     the exact value lies in the returned interval;
 *   isolates     the interval holds exactly one root, counted without multiplicity;
 *   verified     proved: in floating point with every rounding accounted for, or in integers;
 *   approximate  nothing is proved: the value is what a careful computation in double gives.
 *
 * Outcomes.  Every function that can fail returns an algsurf_status:
 *   negative     refused: outputs are untouched, unless the comment says otherwise;
 *   zero         done, as promised;
 *   positive     undecided, or stopped early: outputs hold what is known, unless the comment says otherwise,
 *                and the number of the status says why.
 *
 * Conventions common to all functions, unless their comment says otherwise.
 *   names           comments leave the prefix of a status out: OK, E_RANGE, UNDECIDED_END.  u is 2^-53, the
 *                   largest relative error of one rounding;
 *   sizes           structs that begin with their own size (algsurf.h): E_SIZE if that is less than the
 *                   struct had in 1.0, or above 4096 bytes, or if an input has bytes that are not 0 beyond
 *                   what this version knows;
 *   parameters      pointers are required where null is not said to be allowed: E_ARGUMENT.  Outputs stand
 *                   last; the last parameter of a callback is its data;
 *   numbers         E_NOT_FINITE if one is NaN, or infinite where it must be finite; E_ARGUMENT if it is not
 *                   in its range;
 *   callbacks       must return: neither longjmp nor an exception may leave one through the library;
 *   threads         reentrant; no mutable globals; const objects may be shared by any number of threads;
 *   floating point  results do not depend on the caller's rounding mode or flush-to-zero bits, which are
 *                   saved and restored;
 *   side effects    none: nothing prints, exits, aborts or reads an environment variable;
 *   stack           a call takes 8 KiB at most, unless its comment gives another number (x86-64, optimised by
 *                   gcc).  A thread of 64 KiB suffices for what a renderer calls, one of 128 KiB for all.
 */
#ifndef ALGSURF_STATUS_H
#define ALGSURF_STATUS_H

/* The version compiled against; algsurf_version returns that of the library that runs.  ALGSURF_VERSION is
 * one number that grows: #if ALGSURF_VERSION >= 10200 asks for 1.2.0. */
#define ALGSURF_VERSION_MAJOR 1
#define ALGSURF_VERSION_MINOR 0
#define ALGSURF_VERSION_PATCH 0
#define ALGSURF_VERSION (ALGSURF_VERSION_MAJOR * 10000 + ALGSURF_VERSION_MINOR * 100 + ALGSURF_VERSION_PATCH)

/* Largest total degree of a surface, hence of the polynomial along a ray. */
#define ALGSURF_MAX_DEGREE 64
/* Largest degree of a polynomial handed to the root finders directly. */
#define ALGSURF_MAX_POLY_DEGREE 512

/* On Windows, ALGSURF_DLL tells the compiler that the library is a DLL, which saves each call a jump;
 * programs work without it, and it must not be defined with the static library. */
#if defined(_WIN32) && defined(ALGSURF_DLL)
#define ALGSURF_API __declspec(dllimport)
#elif defined(_WIN32)
#define ALGSURF_API
#elif defined(__GNUC__) || defined(__clang__)
#define ALGSURF_API __attribute__((visibility("default")))
#else
#define ALGSURF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* X(name, number, text).  Numbers are part of the ABI: appended, never reused. */
#define ALGSURF_STATUS_LIST(X)                                                                               \
    X(ALGSURF_E_ARGUMENT, -1, "an argument is null, or out of its range")                                    \
    X(ALGSURF_E_NOT_FINITE, -2, "a number is not finite")                                                    \
    X(ALGSURF_E_NO_MEMORY, -3, "out of memory")                                                              \
    X(ALGSURF_E_DEGREE, -4, "degree above the limit")                                                        \
    X(ALGSURF_E_SYNTAX, -5, "text is not a polynomial equation in x, y, z")                                  \
    X(ALGSURF_E_ZERO, -6, "polynomial is identically zero")                                                  \
    X(ALGSURF_E_RANGE, -7, "overflow, or no result")                                                         \
    X(ALGSURF_E_THREAD, -8, "a lock could not be made")                                                      \
    X(ALGSURF_E_BUILD, -9, "this build of the library does not compute as its proofs need")                  \
    X(ALGSURF_E_NAME, -10, "a name in the equation has no value")                                            \
    X(ALGSURF_E_SIZE, -11, "a struct's size is not set, or it asks for what this version does not know")     \
    X(ALGSURF_E_CAPACITY, -12, "no room for the whole answer")                                               \
    X(ALGSURF_OK, 0, "done")                                                                                 \
    X(ALGSURF_UNDECIDED_MULTIPLE, 1, "a multiple root, or roots too close to be told apart")                 \
    X(ALGSURF_UNDECIDED_END, 2, "a root at, or too close to, an end of the interval")                        \
    X(ALGSURF_UNDECIDED_ZERO, 3, "the polynomial vanishes, or cannot be told from zero")                     \
    X(ALGSURF_UNDECIDED_RANGE, 4, "overflow or underflow hides the answer")                                  \
    X(ALGSURF_NOT_CONVERGED, 5, "the iteration limit was reached")                                           \
    X(ALGSURF_CANCELLED, 6, "cancelled by the caller")                                                       \
    X(ALGSURF_NOT_VERIFIED, 7, "an inclusion could not be verified")

/* What became of a call. */
typedef enum algsurf_status {
#define ALGSURF_STATUS_ENUM(name, number, text) name = number,
    ALGSURF_STATUS_LIST(ALGSURF_STATUS_ENUM)
#undef ALGSURF_STATUS_ENUM
} algsurf_status;

/* A short English text for a status, static, never null ("unknown status" for a number not listed).
 * Cost: constant.  Since 1.0. */
ALGSURF_API const char *algsurf_status_text(algsurf_status status);

/* The name of a status as written in the source, ALGSURF_OK, static, never null ("unknown" for a number not
 * listed).  Since 1.0. */
ALGSURF_API const char *algsurf_status_name(algsurf_status status);

/* The version of the library that runs (the macros give the one compiled against), as
 * "major.minor.patch", static.  Since 1.0. */
ALGSURF_API const char *algsurf_version(void);

/* The same as a number, of the library that runs: major * 10000 + minor * 100 + patch.  Since 1.0. */
ALGSURF_API int algsurf_version_number(void);

/* Does the library, as it was built and on the processor it runs on, compute as its proofs need?  Every bound
 * counts roundings, and a compiler may have been told to change them: to fuse a product and a sum, to keep
 * more digits, to flush small numbers to zero, to reorder sums.  For packagers, and for programs that start;
 * the library never calls it.
 *
 * Two things are tried: single operations, on operands that show such changes, as compiled for each kernel
 * that runs here (algsurf_kernel_name); and a few polynomials, rays and pixels, for which all kernels must
 * return equal bits.
 *
 * Guarantee: E_BUILD means that something failed.  OK means that nothing failed of what was tried: it is a
 * test, not a proof.  Errors: E_BUILD, E_NO_MEMORY.  Cost: 150 microseconds for each kernel; allocates 100 KB
 * at most.  60 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_self_test(void);

#ifdef __cplusplus
}
#endif
#endif
