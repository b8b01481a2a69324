/* threads.c - the threads that draw a picture.
 *
 * Rows are handed out in order, to whoever asks, by a shared counter: one by one, or, where a row has use for
 * its neighbours, in batches, which begin at multiples of their length (complex_rows.c).  The calling thread
 * works like the others and is the only one that calls progress: after each of its rows, and ten times a
 * second while it waits for the others' last ones.  That wait is by the clock of the day, the only one that a
 * condition variable has on every system; if somebody sets this clock back meanwhile, progress is called
 * late, but a helper that leaves ends the wait.  Who draws a row changes nothing in it.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#define _DARWIN_C_SOURCE        /* POSIX alone hides _SC_NPROCESSORS_ONLN there */
#include "../base/arithmetic.h"
#include "impl.h"

#include <time.h>
#ifndef _WIN32
#include <unistd.h>
#endif

#include "../base/fpenv.h"

#define WAIT_NS 100000000L /* between two calls of progress while waiting */
#define SELECTIVE_BATCH 16 /* rows of a batch in a selective picture: the two beyond are drawn in vain */

typedef struct thread_pool {
    algsurf_i_picture *picture;
    const algsurf_render_options *options;
    atomic_int next_row, rows_done;
    pthread_mutex_t lock; /* guards what is below */
    pthread_cond_t left;  /* a helper has finished */
    int helpers_at_work;
    algsurf_status status; /* OK, or why no more rows are handed out */
} thread_pool;

static void stop_pool(thread_pool *pool, algsurf_status why) {
    pthread_mutex_lock(&pool->lock);
    if (pool->status == ALGSURF_OK) pool->status = why;
    pthread_mutex_unlock(&pool->lock);
    atomic_store_explicit(&pool->picture->stop, 1, memory_order_relaxed);
}

void algsurf_i_tally_add(algsurf_i_tally *total, const algsurf_i_tally *more) {
#define ADD(member) total->stats.member += more->stats.member
    ADD(rays), ADD(hits), ADD(undecided), ADD(thin), ADD(iterations);
    ADD(shadow_rays), ADD(single_rays), ADD(exact_rays), ADD(empty_rays), ADD(sheet_rays);
    ADD(tiles), ADD(empty_tiles), ADD(sheet_tiles), ADD(leaf_tiles);
    ADD(expand_s), ADD(solve_s), ADD(point_s), ADD(shadow_s), ADD(shade_s);
#undef ADD
    total->without_memory += more->without_memory;
}

/* Less than 1 if the system fails to tell. */
static long processors(void) {
#if defined(_WIN32)
    return pthread_num_processors_np();
#elif defined(_SC_NPROCESSORS_ONLN)
    return sysconf(_SC_NPROCESSORS_ONLN);
#else
    return 1;
#endif
}

int algsurf_i_thread_count(const algsurf_render_options *options) {
    long threads = options->threads > 0 ? options->threads : processors();
    int rows = options->row_end - options->row_begin;
    if (threads > ALGSURF_MAX_THREADS) threads = ALGSURF_MAX_THREADS;
    if (threads > rows) threads = rows;
    return threads < 1 ? 1 : (int)threads;
}

static int batch_of(const algsurf_i_picture *picture) {
    const algsurf_scene *scene = picture->scene;
    if (picture->tiled) return ALGSURF_I_TILES;
    if (picture->selective) return SELECTIVE_BATCH;
    return scene->complex && scene->coherence == ALGSURF_COHERENCE_NEIGHBOURS ? ALGSURF_I_BAND : 1;
}

/* Gives the worker rows when it has none left; returns 0 when there are none to give. */
static int take_rows(algsurf_i_worker *worker) {
    const algsurf_i_picture *picture = worker->picture;
    if (algsurf_i_stopped(picture)) return 0;
    if (worker->row < worker->row_end) return 1;
    int batch = batch_of(picture);
    int first = atomic_fetch_add_explicit(&worker->pool->next_row, batch, memory_order_relaxed);
    if (first >= picture->row_end) return 0;
    worker->row = first < picture->row_begin ? picture->row_begin : first;
    worker->row_end = batch < picture->row_end - first ? first + batch : picture->row_end;
    worker->predictor.row = -1;
    return 1;
}

/* Draws the worker's next row; returns 0 when there was none left to take. */
static int draw_next(algsurf_i_worker *worker) {
    algsurf_status status;
    if (!take_rows(worker)) return 0;
    ALGSURF_STANDARD(status = algsurf_i_render_row(worker, worker->row++));
    if (status == ALGSURF_OK)
        atomic_fetch_add_explicit(&worker->pool->rows_done, 1, memory_order_relaxed);
    else
        stop_pool(worker->pool, status);
    return 1;
}

static void *help(void *data) {
    algsurf_i_worker *helper = data;
    thread_pool *pool = helper->pool;
    while (draw_next(helper)) {
    }
    pthread_mutex_lock(&pool->lock);
    pool->helpers_at_work--;
    pthread_cond_signal(&pool->left);
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

static void report(thread_pool *pool) {
    const algsurf_render_options *o = pool->options;
    if (!o->progress || algsurf_i_stopped(pool->picture)) return;
    int done = atomic_load_explicit(&pool->rows_done, memory_order_relaxed);
    int total = pool->picture->row_end - pool->picture->row_begin;
    if (o->progress(done, total, o->progress_data) != 0) stop_pool(pool, ALGSURF_CANCELLED);
}

/* Waits until a helper leaves, or for WAIT_NS; returns how many are still at work. */
static int wait_for_helpers(thread_pool *pool) {
    struct timespec until = {0, 0};
    (void)clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += WAIT_NS;
    if (until.tv_nsec >= 1000000000L) {
        until.tv_nsec -= 1000000000L;
        until.tv_sec++;
    }
    pthread_mutex_lock(&pool->lock);
    if (pool->helpers_at_work > 0) (void)pthread_cond_timedwait(&pool->left, &pool->lock, &until);
    int at_work = pool->helpers_at_work;
    pthread_mutex_unlock(&pool->lock);
    return at_work;
}

static int init_sync(thread_pool *pool) {
    if (pthread_cond_init(&pool->left, NULL) != 0) return 0;
    if (pthread_mutex_init(&pool->lock, NULL) == 0) return 1;
    (void)pthread_cond_destroy(&pool->left);
    return 0;
}

/* Starts up to `wanted` helpers, fewer when the system refuses one, and returns how many.  None leaves before
 * all are counted. */
static int start_helpers(thread_pool *pool, algsurf_i_worker *helpers, int wanted) {
    int started = 0;
    pthread_mutex_lock(&pool->lock);
    while (started < wanted && pthread_create(&helpers[started].thread, NULL, help, &helpers[started]) == 0)
        started++;
    pool->helpers_at_work = started;
    pthread_mutex_unlock(&pool->lock);
    return started;
}

algsurf_status algsurf_i_render_threads(algsurf_i_picture *picture, const algsurf_render_options *options,
                                        int threads, algsurf_i_worker *workers, algsurf_i_tally *total) {
    thread_pool pool = {.picture = picture, .options = options};
    atomic_init(&pool.next_row, picture->row_begin - picture->row_begin % batch_of(picture));
    atomic_init(&pool.rows_done, 0);
    if (!init_sync(&pool)) return ALGSURF_E_THREAD;
    for (int i = 0; i < threads; i++) {
        workers[i].pool = &pool;
        workers[i].picture = picture;
        workers[i].line.end = picture->width;
        workers[i].tally = &workers[i].all;
    }
    int started = start_helpers(&pool, workers + 1, threads - 1);
    while (draw_next(workers)) report(&pool);
    if (started > 0)
        while (wait_for_helpers(&pool) > 0) report(&pool);
    for (int i = 1; i <= started; i++) (void)pthread_join(workers[i].thread, NULL);
    if (started > 0) report(&pool);
    (void)pthread_mutex_destroy(&pool.lock);
    (void)pthread_cond_destroy(&pool.left);
    for (int i = 0; i <= started; i++) algsurf_i_tally_add(total, &workers[i].all);
    total->stats.threads = started + 1;
    return pool.status;
}
