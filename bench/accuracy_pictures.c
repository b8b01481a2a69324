/* accuracy_pictures.c - see accuracy_pictures.h.
 *
 * The picture is framed by the extent, whatever the distance.  Both tiers draw the same planes, bytes and t;
 * what they show is compared once, with states. */
#include "accuracy_pictures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "measure.h"
#include "must.h"
#include "results.h"

static const double DEGREE = 57.29577951308232;
static const char *const csv_head =
    "surface,degree,width,height,distance,tier,pixels,ns_median,ns_min,ns_max\n";

typedef struct planes {
    uint8_t *pixels, *state;
    double *t;
} planes;

static planes make_planes(size_t pixels) {
    return (planes){must_allocate(pixels, 3), must_allocate(pixels, 1),
                    must_allocate(pixels, sizeof(double))};
}

static void free_planes(planes *p) {
    free(p->pixels);
    free(p->state);
    free(p->t);
}

static void place_camera(const picture_record *r, double distance, algsurf_scene *scene) {
    const catalogue_entry *e = r->entry;
    double eye[3], length = 0, fov = 2 * atan(1.1 / distance) * DEGREE;
    algsurf_camera camera;
    for (int i = 0; i < 3; i++) length = hypot(length, e->eye[i] - e->extent.centre[i]);
    for (int i = 0; i < 3; i++)
        eye[i] =
            e->extent.centre[i] + distance * e->extent.size[0] * (e->eye[i] - e->extent.centre[i]) / length;
    must(algsurf_camera_pinhole(eye, e->extent.centre, e->up, fov, &camera), r->entry->name);
    must(algsurf_scene_set_camera(scene, &camera), r->entry->name);
}

/* CPU seconds.  With all planes, or those that are timed. */
static double draw(const picture_record *r, const picture_size *size, int tier, int all, algsurf_scene *scene,
                   const planes *to) {
    const algsurf_intersect_options how = {.size = sizeof how, .tier = tier};
    const algsurf_render_options options = {
        .size = sizeof options, .width = size->width, .height = size->height, .threads = 1};
    const algsurf_picture picture = {
        .size = sizeof picture, .pixels = to->pixels, .t = to->t, .state = all ? to->state : NULL};
    must(algsurf_scene_set_intersect_options(scene, &how), r->entry->name);
    double begun = measure_cpu();
    must(algsurf_render(scene, &options, &picture, NULL), r->entry->name);
    return measure_cpu() - begun;
}

/* Where both are decided: the same states, and t to the last bit. */
static int is_same(size_t pixels, const planes *a, const planes *b) {
    for (size_t i = 0; i < pixels; i++) {
        if (a->state[i] == ALGSURF_STATE_UNDECIDED || b->state[i] == ALGSURF_STATE_UNDECIDED) continue;
        if (a->state[i] != b->state[i] || memcmp(&a->t[i], &b->t[i], sizeof a->t[i]) != 0) return 0;
    }
    return 1;
}

static void run_size(const picture_record *r, const picture_size *size, algsurf_scene *scene,
                     picture_line *lines) {
    size_t pixels = (size_t)size->width * (size_t)size->height;
    planes sure = make_planes(pixels), other = make_planes(pixels);
    place_camera(r, size->distance, scene);
    (void)draw(r, size, ALGSURF_TIER_CERTIFIED, 1, scene, &sure);
    (void)draw(r, size, ALGSURF_TIER_BOUNDED, 1, scene, &other);
    if (!is_same(pixels, &sure, &other))
        cli_fail(CLI_BROKEN, "%s: the picture of the bounded tier differs from the certified one",
                 r->entry->name);
    for (int turn = 0; turn < r->repeat; turn++)
        for (int tier = 0; tier < TIERS; tier++)
            lines[tier].ns[turn] = draw(r, size, tier, 0, scene, &other) * 1e9 / (double)pixels;
    for (int tier = 0; tier < TIERS; tier++) measure_sort(lines[tier].ns, (size_t)r->repeat);
    free_planes(&sure);
    free_planes(&other);
}

void pictures_run(const catalogue_entry *entry, int quick, int repeat, picture_record *r) {
    static const picture_size all[SIZES] = {{256, 192, 4},   {512, 384, 4},    {1024, 768, 4},
                                            {2048, 1536, 4}, {1024, 768, 100}, {1024, 768, 1e4}};
    static const picture_size few[] = {{96, 72, 4}, {256, 192, 4}, {256, 192, 1e4}};
    algsurf_surface *surface;
    algsurf_scene *scene;
    *r = (picture_record){.entry = entry, .repeat = repeat, .sizes = quick ? 3 : SIZES};
    for (int i = 0; i < r->sizes; i++) r->size[i] = quick ? few[i] : all[i];
    must(algsurf_surface_from_equation(entry->equation, NULL, 0, &surface, NULL), r->entry->name);
    must(algsurf_scene_create(surface, &scene), r->entry->name);
    must(algsurf_scene_set_extent(scene, &entry->extent), r->entry->name);
    for (int i = 0; i < r->sizes; i++) run_size(r, &r->size[i], scene, r->line[i]);
    algsurf_scene_free(scene);
    algsurf_surface_free(surface);
}

/* ---- what is told ---- */

static double median(const picture_record *r, int size, int tier) {
    return measure_quantile(r->line[size][tier].ns, (size_t)r->repeat, 0.5);
}

void pictures_table(const picture_record *r) {
    printf("\n%s in whole pictures, shading included, beside the certified tier\n", r->entry->name);
    printf("%-12s%9s  %-10s%9s%8s\n", "size", "distance", "tier", "ns/pixel", "times");
    for (int i = 0; i < r->sizes; i++)
        for (int tier = 0; tier < TIERS; tier++) {
            char size[32];
            snprintf(size, sizeof size, "%dx%d", r->size[i].width, r->size[i].height);
            printf("%-12s%9g  %-10s%9.1f%7.2fx\n", size, r->size[i].distance, tier_name(tier),
                   median(r, i, tier), median(r, i, ALGSURF_TIER_CERTIFIED) / median(r, i, tier));
        }
}

static void write_csv(const picture_record *records, int count, const char *folder) {
    FILE *file = results_create(folder, "accuracy_pictures.csv");
    fputs(csv_head, file);
    for (const picture_record *r = records; r < records + count; r++)
        for (int i = 0; i < r->sizes; i++)
            for (int tier = 0; tier < TIERS; tier++) {
                const picture_line *l = &r->line[i][tier];
                fprintf(file, "%s,%d,%d,%d,%g,%s,%d,%.4g,%.4g,%.4g\n", r->entry->name, r->entry->degree,
                        r->size[i].width, r->size[i].height, r->size[i].distance, tier_name(tier),
                        r->size[i].width * r->size[i].height, median(r, i, tier), l->ns[0],
                        l->ns[r->repeat - 1]);
            }
    results_finish(file, folder, "accuracy_pictures.csv");
}

/* Time against resolution, from the first distance: a panel for each surface, a line for each tier. */
typedef struct panel {
    char title[128];
    double x[SIZES], y[TIERS][SIZES];
    plot_series series[TIERS];
} panel;

static plot panel_of(const picture_record *r, panel *p) {
    plot_axis time = {.label = "time a pixel, ns", .scale = PLOT_LOG, .lo = INFINITY};
    size_t points = 0;
    for (int i = 0; i < r->sizes; i++) {
        if (r->size[i].distance != r->size[0].distance) continue;
        p->x[points] = r->size[i].width;
        for (int tier = 0; tier < TIERS; tier++) {
            p->y[tier][points] = median(r, i, tier);
            time.lo = fmin(time.lo, median(r, i, tier) / 1.2);
            time.hi = fmax(time.hi, median(r, i, tier) * 1.2);
        }
        points++;
    }
    for (int tier = 0; tier < TIERS; tier++)
        p->series[tier] = (plot_series){tier_name(tier), PLOT_BOTH, p->x, p->y[tier], points};
    snprintf(p->title, sizeof p->title, "A picture by tier: %s (degree %d)", r->entry->name,
             r->entry->degree);
    return (plot){.title = p->title,
                  .x = {.label = "width of the picture, pixels",
                        .scale = PLOT_LOG,
                        .lo = p->x[0] / 1.2,
                        .hi = p->x[points - 1] * 1.2},
                  .y = time,
                  .series = p->series,
                  .count = TIERS};
}

void pictures_files(const picture_record *records, int count, const char *folder) {
    panel *panels = must_allocate((size_t)count, sizeof *panels);
    plot *plots = must_allocate((size_t)count, sizeof *plots);
    write_csv(records, count, folder);
    for (int i = 0; i < count; i++) plots[i] = panel_of(&records[i], &panels[i]);
    results_plot(plots, (size_t)count, folder, "accuracy_pictures.svg");
    free(panels);
    free(plots);
}
