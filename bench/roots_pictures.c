/* roots_pictures.c - what all complex roots cost in a picture of complex space: each pixel takes those of its
 * ray, in lanes, and shows the least in a sector.
 *
 * By each kernel, and without the roots of the row above to start from (Sanjuan-Estrada, Casado, Garcia,
 * section 3): the pictures must be the same byte for byte; if not there is no table. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "must.h"
#include "rays.h"
#include "roots.h"

enum { WIDTH = 640, HEIGHT = 480, BYTES = 3 * WIDTH * HEIGHT, MOST_MANNERS = 4 };

/* A way to draw. */
typedef struct manner {
    const char *program;
    const char *kernel; /* null: the fastest */
    algsurf_coherence coherence;
    algsurf_scene *scene;
    uint8_t *pixels;
    algsurf_render_stats stats;
} manner;

static void solve(void *self, size_t begin, size_t end) {
    manner *m = self;
    const algsurf_render_options options = {
        .size = sizeof options, .width = WIDTH, .height = HEIGHT, .threads = 1};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = m->pixels};
    (void)begin, (void)end; /* one picture */
    m->stats.size = sizeof m->stats;
    must(algsurf_render(m->scene, &options, &picture, &m->stats), m->program);
}

static int list_manners(manner *m) {
    static char name[MOST_MANNERS][32];
    int count = 0;
    m[count++] = (manner){"algsurf", NULL, ALGSURF_COHERENCE_NEIGHBOURS, NULL, NULL, {0}};
    m[count++] = (manner){"every pixel by itself", NULL, ALGSURF_COHERENCE_NONE, NULL, NULL, {0}};
    for (int i = 1; count < MOST_MANNERS && algsurf_kernel_name(i); i++) {
        const char *kernel = algsurf_kernel_name(i);
        snprintf(name[count], sizeof name[count], "algsurf %s", kernel);
        m[count] = (manner){name[count], kernel, ALGSURF_COHERENCE_NEIGHBOURS, NULL, NULL, {0}};
        count++;
    }
    return count;
}

static void set_scene(manner *m, const algsurf_surface *surface, const catalogue_entry *entry) {
    const algsurf_complex_space space = {.size = sizeof space, .sector = {0, 0.1}};
    const algsurf_intersect_options intersect = {.size = sizeof intersect, .kernel = m->kernel};
    const algsurf_camera camera = rays_camera(&entry->extent);
    m->scene = rays_scene(surface, &entry->extent, &camera);
    must(algsurf_scene_set_intersect_options(m->scene, &intersect), entry->name);
    must(algsurf_scene_set_complex_space(m->scene, &space), entry->name);
    must(algsurf_scene_set_coherence(m->scene, m->coherence), entry->name);
    m->pixels = must_allocate(BYTES, 1);
}

static void contend(const catalogue_entry *entry, const roots_effort *effort, contest_table *table) {
    manner m[MOST_MANNERS];
    contestant contestants[MOST_MANNERS];
    algsurf_surface *surface = rays_surface(entry);
    int count = list_manners(m);
    for (int i = 0; i < count; i++) {
        set_scene(&m[i], surface, entry);
        contestants[i] = (contestant){.row = {.section = "complex pictures",
                                              .task = entry->name,
                                              .degree = entry->degree,
                                              .program = m[i].program,
                                              .unit = "ms"},
                                      .solve = solve,
                                      .self = &m[i]};
    }
    contest_warm_up(contestants, (size_t)count, 1, 1);
    for (int i = 0; i < count; i++) {
        const algsurf_render_stats *stats = &m[i].stats;
        contest_row *row = &contestants[i].row;
        if (memcmp(m[0].pixels, m[i].pixels, BYTES) != 0)
            cli_fail(CLI_BROKEN, "%s: not the same picture by %s", entry->name, m[i].program);
        row->count = stats->hits;
        row->missed = stats->single_rays;
        row->extra = stats->undecided;
        row->error = (double)stats->iterations / (WIDTH * HEIGHT) / entry->degree;
    }
    contest_run(contestants, (size_t)count, effort->takes, table);
    for (int i = 0; i < count; i++) {
        algsurf_scene_free(m[i].scene);
        free(m[i].pixels);
    }
    algsurf_surface_free(surface);
}

void roots_pictures(const roots_effort *effort, contest_table *table) {
    static const char *const names[] = {"tangle", "boy", "barth", "barth-decic"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        contend(catalogue_find(names[i]), effort, table);
}
