/* unit.h - cmocka, what it wants included before it, and tests that list themselves:
 *
 *     TEST(what_is_tested) { assert_true(...); }
 *
 * They run in the order in which they stand, by unit_main.c or a main of the program's own.
 */
#ifndef UNIT_H
#define UNIT_H
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

/* The call says ALGSURF_OK. */
#define assert_ok(status) assert_int_equal(status, 0)

/* Processor time of this program in seconds of the library as it ships, for bounds of time: sanitizers and
 * missing optimisation make the same work take several times as long, and a machine that others use doubles
 * that.
 */
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define UNIT_SLOWER 8.0
#endif
#endif
#if !defined(UNIT_SLOWER) &&                                                                                 \
    (defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__))
#define UNIT_SLOWER 8.0
#elif !defined(UNIT_SLOWER)
#define UNIT_SLOWER 1.0
#endif

static inline double unit_seconds(void) { return (double)clock() / CLOCKS_PER_SEC / UNIT_SLOWER; }

/* Adds a test; runs those of the program (0: all passed). */
void unit_add(const char *name, CMUnitTestFunction test, int line);
int unit_run(const char *group);
int unit_main(int argc, char **argv);

/* A number that the i-th argument of the program sets, i from 1 on. */
void unit_argument(int i, void (*set)(const char *text));
#define ARGUMENT(i, type, name, usual)                                                                       \
    static type name = usual;                                                                                \
    static void unit_set_##name(const char *text) { name = (type)strtoull(text, NULL, 0); }                  \
    __attribute__((constructor)) static void unit_take_##name(void) { unit_argument(i, unit_set_##name); }

/* What is made for a test is released when the test ends, the last first; returns what was made. */
void *unit_keep(void *made, void (*release)(void *made));
void unit_release(void);

/* A test; it enters the list before main begins. */
#define TEST(name)                                                                                           \
    static void name(void **);                                                                               \
    __attribute__((constructor)) static void unit_add_##name(void) { unit_add(#name, name, __LINE__); }      \
    static void name(void **unit_state __attribute__((unused)))

#endif
