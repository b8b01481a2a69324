/* render_crew.c - the threads that draw a picture.
 *
 * Rows are handed out in order, to whoever asks: one by one, or, where a row starts from the one above, in
 * batches; the first row of a batch has none above, so that what a row starts from does not depend on the
 * threads.  The calling thread works like the others and is the only one that calls progress: after each
 * of its rows, and ten times a second while it waits for the others' last ones.  Who draws a row changes
 * nothing in it.
 */
#define _POSIX_C_SOURCE 200809L /* pthread_condattr_setclock */
#include "render_impl.h"

#include <pthread.h>
#include <time.h>

#include "fpenv.h"

#define WAIT_NS 100000000L /* between two calls of progress while waiting */
#define BATCH 8            /* rows: one in eight has none above; few enough to keep many threads busy */

typedef struct crew {
    algsurf_i_picture *picture;
    const algsurf_render_options *options;
    pthread_mutex_t lock; /* guards everything below */
    pthread_cond_t left;  /* a helper has finished */
    int next_row, rows_done, helpers_at_work;
    algsurf_status status; /* OK, or why no more rows are handed out */
    algsurf_i_tally total;
} crew;

typedef struct helper {
    crew *team;
    algsurf_i_worker *worker;
    pthread_t thread;
} helper;

static void stop_crew(crew *team, algsurf_status why) {
    if (team->status == ALGSURF_OK) team->status = why;
    atomic_store_explicit(&team->picture->stop, 1, memory_order_relaxed);
}

static void add_tally(algsurf_i_tally *total, const algsurf_i_tally *more) {
    total->rays += more->rays;
    total->hits += more->hits;
    total->uncertain += more->uncertain;
    total->shadow_rays += more->shadow_rays;
    total->iterations += more->iterations;
    total->single_rays += more->single_rays;
    total->expand_s += more->expand_s;
    total->solve_s += more->solve_s;
    total->point_s += more->point_s;
    total->shadow_s += more->shadow_s;
    total->shade_s += more->shade_s;
}

/* Gives the worker rows when it has none left; returns 0 when there are none to give.  Has the lock. */
static int take_rows(crew *team, algsurf_i_worker *worker) {
    const algsurf_i_picture *picture = team->picture;
    if (team->status != ALGSURF_OK) return 0;
    if (worker->row < worker->row_end) return 1;
    if (team->next_row >= picture->row_end) return 0;
    int batch =
        picture->scene->complex && picture->scene->coherence == ALGSURF_COHERENCE_NEIGHBOURS ? BATCH : 1;
    worker->row = team->next_row;
    worker->row_end = worker->row + batch;
    if (worker->row_end > picture->row_end) worker->row_end = picture->row_end;
    worker->trail.has_above = 0;
    team->next_row = worker->row_end;
    return 1;
}

/* Draws the worker's next row; returns 0 when there was none left to take. */
static int draw_next(crew *team, algsurf_i_worker *worker) {
    algsurf_i_tally tally = {0};
    algsurf_fpenv saved;
    pthread_mutex_lock(&team->lock);
    int taken = take_rows(team, worker);
    pthread_mutex_unlock(&team->lock);
    if (!taken) return 0;

    algsurf_fpenv_enter(&saved);
    algsurf_status status = algsurf_i_render_row(team->picture, worker->row++, worker, &tally);
    algsurf_fpenv_leave(&saved);

    pthread_mutex_lock(&team->lock);
    add_tally(&team->total, &tally);
    if (status == ALGSURF_OK)
        team->rows_done++;
    else
        stop_crew(team, status);
    pthread_mutex_unlock(&team->lock);
    return 1;
}

static void *help(void *data) {
    const helper *me = data;
    crew *team = me->team;
    while (draw_next(team, me->worker)) {
    }
    pthread_mutex_lock(&team->lock);
    team->helpers_at_work--;
    pthread_cond_signal(&team->left);
    pthread_mutex_unlock(&team->lock);
    return NULL;
}

/* Calls progress, without the lock: it may take its time. */
static void report(crew *team) {
    if (!team->options->progress) return;
    pthread_mutex_lock(&team->lock);
    int done = team->rows_done, go_on = team->status == ALGSURF_OK;
    pthread_mutex_unlock(&team->lock);
    int total = team->picture->row_end - team->picture->row_begin;
    if (!go_on || team->options->progress(done, total, team->options->progress_data) == 0) return;
    pthread_mutex_lock(&team->lock);
    stop_crew(team, ALGSURF_CANCELLED);
    pthread_mutex_unlock(&team->lock);
}

/* Waits until a helper leaves, or for WAIT_NS; returns how many are still at work. */
static int wait_for_helpers(crew *team) {
    struct timespec until = {0, 0};
    (void)clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_nsec += WAIT_NS;
    if (until.tv_nsec >= 1000000000L) {
        until.tv_nsec -= 1000000000L;
        until.tv_sec++;
    }
    pthread_mutex_lock(&team->lock);
    if (team->helpers_at_work > 0) (void)pthread_cond_timedwait(&team->left, &team->lock, &until);
    int at_work = team->helpers_at_work;
    pthread_mutex_unlock(&team->lock);
    return at_work;
}

static int init_sync(crew *team) {
    pthread_condattr_t monotonic;
    if (pthread_condattr_init(&monotonic) != 0) return 0;
    int ready = pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC) == 0 &&
                pthread_cond_init(&team->left, &monotonic) == 0;
    (void)pthread_condattr_destroy(&monotonic);
    if (!ready) return 0;
    if (pthread_mutex_init(&team->lock, NULL) == 0) return 1;
    (void)pthread_cond_destroy(&team->left);
    return 0;
}

/* Starts up to `wanted` helpers, fewer when the system refuses one, and returns how many. */
static int start_helpers(crew *team, helper *helpers, int wanted, algsurf_i_worker *workers) {
    int started = 0;
    for (; started < wanted; started++) {
        helper *next = &helpers[started];
        next->team = team;
        next->worker = &workers[started];
        pthread_mutex_lock(&team->lock);
        team->helpers_at_work++;
        pthread_mutex_unlock(&team->lock);
        if (pthread_create(&next->thread, NULL, help, next) != 0) break;
    }
    if (started < wanted) {
        pthread_mutex_lock(&team->lock);
        team->helpers_at_work--;
        pthread_mutex_unlock(&team->lock);
    }
    return started;
}

algsurf_status algsurf_i_render_crew(algsurf_i_picture *picture, const algsurf_render_options *options,
                                     int threads, algsurf_i_worker *workers, algsurf_i_tally *total,
                                     int *threads_used) {
    crew team = {.picture = picture, .options = options, .next_row = picture->row_begin};
    helper helpers[ALGSURF_MAX_THREADS];
    if (!init_sync(&team)) return ALGSURF_E_THREAD;
    int started = start_helpers(&team, helpers, threads - 1, workers + 1);
    while (draw_next(&team, workers)) report(&team);
    if (started > 0)
        while (wait_for_helpers(&team) > 0) report(&team);
    for (int i = 0; i < started; i++) (void)pthread_join(helpers[i].thread, NULL);
    if (started > 0) report(&team);
    (void)pthread_mutex_destroy(&team.lock);
    (void)pthread_cond_destroy(&team.left);
    *total = team.total;
    *threads_used = started + 1;
    return team.status;
}
