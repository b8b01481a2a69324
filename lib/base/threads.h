/* threads.h - POSIX threads; where there are none, the part of their interface that this library uses.
 *
 * WebAssembly's system interface, WASI, has one thread without -pthread, and no <pthread.h>.  There a lock
 * does nothing, and starting a thread fails, as it may on any system: the caller's thread then does all the
 * work.
 */
#ifndef ALGSURF_THREADS_H
#define ALGSURF_THREADS_H

#if !defined(__wasi__) || defined(_REENTRANT)
#include <pthread.h>
#else
#include <errno.h>
#include <time.h>

typedef struct algsurf_no_thread {
    char unused;
} pthread_t, pthread_mutex_t, pthread_cond_t;

static inline int pthread_mutex_init(pthread_mutex_t *lock, const void *attributes) {
    (void)lock, (void)attributes;
    return 0;
}
static inline int pthread_mutex_lock(pthread_mutex_t *lock) { return (void)lock, 0; }
static inline int pthread_mutex_unlock(pthread_mutex_t *lock) { return (void)lock, 0; }
static inline int pthread_mutex_destroy(pthread_mutex_t *lock) { return (void)lock, 0; }
static inline int pthread_cond_init(pthread_cond_t *condition, const void *attributes) {
    (void)condition, (void)attributes;
    return 0;
}
static inline int pthread_cond_signal(pthread_cond_t *condition) { return (void)condition, 0; }
static inline int pthread_cond_timedwait(pthread_cond_t *condition, pthread_mutex_t *lock,
                                         const struct timespec *until) {
    (void)condition, (void)lock, (void)until;
    return ETIMEDOUT;
}
static inline int pthread_cond_destroy(pthread_cond_t *condition) { return (void)condition, 0; }
static inline int pthread_create(pthread_t *thread, const void *attributes, void *(*run)(void *),
                                 void *data) {
    (void)thread, (void)attributes, (void)run, (void)data;
    return EAGAIN;
}
static inline int pthread_join(pthread_t thread, void **result) { return (void)thread, (void)result, 0; }
#endif
#endif
