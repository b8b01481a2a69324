/* mesh_threads.c - see mesh_threads.h. */
#include "mesh_threads.h"

#if defined(__wasi__)
/* WebAssembly's system interface has no threads. */
void mesh_threads_run(void (*job)(int index, void *job_data), int count, void *job_data, void *data) {
    (void)data;
    for (int i = 0; i < count; i++) job(i, job_data);
}
#else
#include <pthread.h>

enum { MOST = 256 };

typedef struct work {
    void (*job)(int index, void *data);
    void *data;
    int next, count;
    pthread_mutex_t lock;
} work;

static int take(work *w) {
    pthread_mutex_lock(&w->lock);
    const int index = w->next < w->count ? w->next++ : -1;
    pthread_mutex_unlock(&w->lock);
    return index;
}

static void *do_jobs(void *data) {
    work *w = data;
    for (int index; (index = take(w)) >= 0;) w->job(index, w->data);
    return NULL;
}

void mesh_threads_run(void (*job)(int index, void *job_data), int count, void *job_data, void *data) {
    work w = {.job = job, .data = job_data, .count = count, .lock = PTHREAD_MUTEX_INITIALIZER};
    const int asked = *(const int *)data, wanted = asked < count ? asked : count;
    pthread_t thread[MOST];
    int started = 1; /* this one */
    while (started < wanted && started < MOST && pthread_create(&thread[started], NULL, do_jobs, &w) == 0)
        started++;
    (void)do_jobs(&w);
    for (int i = 1; i < started; i++) pthread_join(thread[i], NULL);
}
#endif
