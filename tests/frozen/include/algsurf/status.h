#ifndef ALGSURF_STATUS_H
#define ALGSURF_STATUS_H
#define ALGSURF_VERSION_MAJOR 1
#define ALGSURF_VERSION_MINOR 0
#define ALGSURF_VERSION_PATCH 0
#define ALGSURF_VERSION (ALGSURF_VERSION_MAJOR * 10000 + ALGSURF_VERSION_MINOR * 100 + ALGSURF_VERSION_PATCH)
#define ALGSURF_MAX_DEGREE 64
#define ALGSURF_MAX_POLY_DEGREE 512
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
#define ALGSURF_STATUS_LIST(X) \
    X(ALGSURF_E_ARGUMENT, -1, "an argument is null, or out of its range") \
    X(ALGSURF_E_NOT_FINITE, -2, "a number is not finite") \
    X(ALGSURF_E_NO_MEMORY, -3, "out of memory") \
    X(ALGSURF_E_DEGREE, -4, "degree above the limit") \
    X(ALGSURF_E_SYNTAX, -5, "text is not a polynomial equation in x, y, z") \
    X(ALGSURF_E_ZERO, -6, "polynomial is identically zero") \
    X(ALGSURF_E_RANGE, -7, "overflow, or no result") \
    X(ALGSURF_E_THREAD, -8, "a lock could not be made") \
    X(ALGSURF_E_BUILD, -9, "this build of the library does not compute as its proofs need") \
    X(ALGSURF_E_NAME, -10, "a name in the equation has no value") \
    X(ALGSURF_E_SIZE, -11, "a struct's size is not set, or it asks for what this version does not know") \
    X(ALGSURF_E_CAPACITY, -12, "no room for the whole answer") \
    X(ALGSURF_OK, 0, "done") \
    X(ALGSURF_UNDECIDED_MULTIPLE, 1, "a multiple root, or roots too close to be told apart") \
    X(ALGSURF_UNDECIDED_END, 2, "a root at, or too close to, an end of the interval") \
    X(ALGSURF_UNDECIDED_ZERO, 3, "the polynomial vanishes, or cannot be told from zero") \
    X(ALGSURF_UNDECIDED_RANGE, 4, "overflow or underflow hides the answer") \
    X(ALGSURF_NOT_CONVERGED, 5, "the iteration limit was reached") \
    X(ALGSURF_CANCELLED, 6, "cancelled by the caller") \
    X(ALGSURF_NOT_VERIFIED, 7, "an inclusion could not be verified")
typedef enum algsurf_status {
#define ALGSURF_STATUS_ENUM(name,number,text) name = number,
    ALGSURF_STATUS_LIST(ALGSURF_STATUS_ENUM)
#undef ALGSURF_STATUS_ENUM
} algsurf_status;
ALGSURF_API const char *algsurf_status_text(algsurf_status status);
ALGSURF_API const char *algsurf_status_name(algsurf_status status);
ALGSURF_API const char *algsurf_version(void);
ALGSURF_API int algsurf_version_number(void);
ALGSURF_API algsurf_status algsurf_self_test(void);
#ifdef __cplusplus
}
#endif
#endif
