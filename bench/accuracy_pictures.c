/* accuracy_pictures.c - see accuracy.h.
 *
 * The picture is framed by the extent, whatever the distance.  Both tiers draw the same planes, bytes and t;
 * what they show is compared once, with states. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "accuracy.h"
#include "chart.h"
#include "must.h"
#include "rays.h"
#include "sheet.h"

static const double DEGREE = 57.29577951308232;

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

/* From where the catalogue looks, but at that distance. */
static algsurf_camera camera_at(const catalogue_entry *e, double distance) {
    double eye[3], length = 0, fov = 2 * atan(1.1 / distance) * DEGREE;
    algsurf_camera camera;
    for (int i = 0; i < 3; i++) length = hypot(length, e->eye[i] - e->extent.centre[i]);
    for (int i = 0; i < 3; i++)
        eye[i] =
            e->extent.centre[i] + distance * e->extent.size[0] * (e->eye[i] - e->extent.centre[i]) / length;
    must(algsurf_camera_pinhole(eye, e->extent.centre, e->up, fov, &camera), e->name);
    return camera;
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

static void run_size(const picture_record *r, const algsurf_surface *surface, const picture_size *size,
                     int repeat, measure_takes takes[TIERS]) {
    const size_t pixels = (size_t)size->width * (size_t)size->height;
    const algsurf_camera camera = camera_at(r->entry, size->distance);
    algsurf_scene *scene = rays_scene(surface, &r->entry->extent, &camera);
    planes sure = make_planes(pixels), other = make_planes(pixels);
    (void)draw(r, size, ALGSURF_TIER_CERTIFIED, 1, scene, &sure);
    (void)draw(r, size, ALGSURF_TIER_BOUNDED, 1, scene, &other);
    if (!is_same(pixels, &sure, &other))
        cli_fail(CLI_BROKEN, "%s: the picture of the bounded tier differs from the certified one",
                 r->entry->name);
    for (int turn = 0; turn < repeat; turn++)
        for (int tier = 0; tier < TIERS; tier++)
            measure_take(&takes[tier], draw(r, size, tier, 0, scene, &other));
    free_planes(&sure);
    free_planes(&other);
    algsurf_scene_free(scene);
}

void pictures_run(const catalogue_entry *entry, int quick, int repeat, picture_record *r) {
    static const picture_size all[SIZES] = {{256, 192, 4},   {512, 384, 4},    {1024, 768, 4},
                                            {2048, 1536, 4}, {1024, 768, 100}, {1024, 768, 1e4}};
    static const picture_size few[] = {{96, 72, 4}, {256, 192, 4}, {256, 192, 1e4}};
    algsurf_surface *surface = rays_surface(entry);
    *r = (picture_record){.entry = entry, .sizes = quick ? 3 : SIZES, .size = quick ? few : all};
    for (int i = 0; i < r->sizes; i++) run_size(r, surface, &r->size[i], repeat, r->takes[i]);
    algsurf_surface_free(surface);
}

/* ---- what is told ---- */

static const sheet_column columns[] = {
    {"", 0, "surface"},    {"", 0, "degree"},   {"size", -12, ""}, {"", 0, "width"},     {"", 0, "height"},
    {"distance", 9, NULL}, {"tier", -10, NULL}, {"", 0, "pixels"}, {"", 0, "ns_median"}, {"ns/pixel", 9, ""},
    {"", 0, "ns_min"},     {"", 0, "ns_max"},   {"times", 7, ""}};

static void add_row(sheet *s, const picture_record *r, const picture_size *size, int tier,
                    const measure_takes takes[TIERS]) {
    const int pixels = size->width * size->height;
    const double ns = 1e9 / pixels, median = ns * measure_taken(&takes[tier], 0.5);
    sheet_add(s, "%s\t%d\t%dx%d\t%d\t%d\t%g\t%s\t%d\t%.4g\t%.1f\t%.4g\t%.4g\t%.2fx", r->entry->name,
              r->entry->degree, size->width, size->height, size->width, size->height, size->distance,
              tier_names[tier], pixels, median, median, ns * measure_taken(&takes[tier], 0),
              ns * measure_taken(&takes[tier], 1),
              ns * measure_taken(&takes[ALGSURF_TIER_CERTIFIED], 0.5) / median);
}

/* Time against resolution, from the first distance: a line for each tier. */
static void draw_chart(chart *c, const picture_record *r) {
    c->plot.x = (plot_axis){.label = "width of the picture, pixels", .scale = PLOT_LOG};
    c->plot.y = (plot_axis){.label = "time a pixel, ns", .scale = PLOT_LOG};
    snprintf(c->title, sizeof c->title, "A picture by tier: %s (degree %d)", r->entry->name,
             r->entry->degree);
    for (int tier = 0; tier < TIERS; tier++) {
        chart_series(c, tier_names[tier], PLOT_BOTH);
        for (int i = 0; i < r->sizes; i++)
            if (r->size[i].distance == r->size[0].distance)
                chart_point(c, r->size[i].width,
                            1e9 * measure_taken(&r->takes[i][tier], 0.5) /
                                (r->size[i].width * r->size[i].height));
    }
    chart_margins(c, 1.2, 1.2);
}

void pictures_report(const picture_record *records, int count, const char *folder) {
    sheet table = SHEET(columns);
    chart *charts = must_allocate((size_t)count, sizeof *charts);
    for (int k = 0; k < count; k++) {
        const picture_record *r = &records[k];
        for (int i = 0; i < r->sizes; i++)
            for (int tier = 0; tier < TIERS; tier++) add_row(&table, r, &r->size[i], tier, r->takes[i]);
        printf("\n%s in whole pictures, shading included, beside the certified tier\n", r->entry->name);
        sheet_print(&table, 0);
        draw_chart(&charts[k], r);
    }
    sheet_write(&table, folder, "accuracy_pictures.csv");
    chart_write(charts, (size_t)count, folder, "accuracy_pictures.svg");
    free(charts);
    free(table.rows);
}
