/* processors.c - how many processors the system has for threads; 1 where it does not say. */
#define _POSIX_C_SOURCE 200809L
#define _DARWIN_C_SOURCE /* POSIX alone hides _SC_NPROCESSORS_ONLN there */
#include "../base/arithmetic.h"
#include "impl.h"

#ifdef _WIN32
#include <pthread.h>
long algsurf_i_processors(void) { return pthread_num_processors_np(); }
#else
#include <unistd.h>
long algsurf_i_processors(void) {
#ifdef _SC_NPROCESSORS_ONLN
    return sysconf(_SC_NPROCESSORS_ONLN);
#else
    return 1;
#endif
}
#endif
