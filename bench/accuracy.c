/* accuracy.c - what accuracy costs: method, tolerance and tier, single rays and packets: accuracy --help.
 *
 * Every setting answers the same rays of a surface's view, and is judged by roots that are proved to far more
 * digits than double has (accuracy_truth.c).  All settings of all surfaces are judged before any is timed,
 * and one that contradicts what it promises ends the program without a table.  Then they take turns, so that
 * what else runs on the machine hits them alike.  Whole pictures of each tier follow, small and large, from
 * near and from afar (accuracy_pictures.c).
 */
#include <stdlib.h>
#include <string.h>

#include "accuracy.h"
#include "must.h"
#include "results.h"
#include "surfaces.h"

/* Regula falsi may be wrong, but if it is at more than one in FEW_WRONG of the hits, at tolerance 0,
 * something is broken: it is at one in 80, on boy. */
enum { FEW_WRONG = 20 };

typedef struct bench_options {
    const char *output;
    int repeat, quick;
    surface_list surfaces;
} bench_options;

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--surface", "NAME", "a surface of the catalogue (repeatable), default tangle, boy, barth, barth-decic",
     surfaces_set, FIELD(surfaces), 0, 0},
    {"--repeat", "N", "times taken of which the median is reported, default 3", cli_set_int, FIELD(repeat), 1,
     20},
    {"--output", "FOLDER", "all numbers as CSV and charts as SVG go there; made if there is none",
     cli_set_text, FIELD(output), 0, 0},
    {"--quick", NULL, "fewer rays: seconds instead of a minute", cli_set_flag, FIELD(quick), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "accuracy",
    .synopsis = "[options]",
    .about = "Answers the rays of surfaces with every method, tolerance and tier, one by one, in\n"
             "packets and in pictures; checks the answers against roots that are proved, then prints\n"
             "time and error of each.  An answer that contradicts what its setting promises: one line\n"
             "on standard error, no table, exit status 1.",
    .options = options_table,
};

static const char legend[] =
    "Time a ray takes, and how far its first hit is off.\n"
    "  way        single: algsurf_intersect_first; packet: algsurf_intersect_packet; picture:\n"
    "             algsurf_render, its share of intersections, positions and normals, one thread.\n"
    "             Packets and pictures solve rays side by side by the default method only\n"
    "  tolerance  wanted error of t, in units of space; 0: all that a double can tell\n"
    "  ns         CPU time for each ray that meets the extent, median\n"
    "  error      |t - exact| over the hits; 99.9 % do not exceed the number told (of fewer than 1000\n"
    "             hits: none does)\n"
    "  spread     longest less shortest time, in units of the median; median over tolerances\n"
    "  wrong      rays with another state than the truth, or t off by more than tolerance and rounding,\n"
    "             at the tolerance with most of them; undecided: so told, at tolerance 0\n"
    "  settled    the largest tolerance from which on the picture's bytes, standard quality, do not\n"
    "             change any more; of other methods than the default, it is drawn ray by ray\n"
    "  distance   of the eye, in radii of the extent\n"
    "  times      how many times as fast as the certified tier\n";

typedef struct size {
    int width, height, rows;
} size;

static size size_of(const bench_options *o) { return o->quick ? (size){96, 72, 12} : (size){256, 192, 24}; }

/* ---- the settings ---- */

static void make_lines(record *r) {
    line *l = r->line;
    for (int method = 0; method < METHODS; method++)
        for (int tier = 0; tier < TIERS; tier++)
            (l++)->setting = (setting){WAY_SINGLE, (int)method, (int)tier, 0};
    for (int w = WAY_PACKET; w <= WAY_PICTURE; w++)
        for (int tier = 0; tier < TIERS; tier++)
            (l++)->setting = (setting){(way)w, ALGSURF_METHOD_DEFAULT, (int)tier, 0};
}

static setting setting_at(const line *l, int tolerance) {
    setting s = l->setting;
    s.tolerance = accuracy_tolerances[tolerance];
    return s;
}

/* ---- a surface ---- */

static _Noreturn void refuse(const view *v, const setting *s, const char *what, size_t at) {
    size_t width = (size_t)v->width;
    cli_fail(CLI_BROKEN, "%s, %s, %s, %s, tolerance %g: pixel %zu,%zu of %dx%d: %s", v->entry->name,
             way_names[s->way], method_names[s->method], tier_names[s->tier], s->tolerance, at % width,
             at / width, v->width, v->height, what);
}

static void judge_line(const view *v, ways *w, line *l) {
    for (int k = 0; k < TOLERANCES; k++) {
        setting s = setting_at(l, k);
        (void)ways_run(w, &s);
        l->verdict[k] = ways_judge(w, &s);
        if (l->verdict[k].breach) refuse(v, &s, l->verdict[k].breach, l->verdict[k].at);
        if (s.tolerance == 0 && l->verdict[k].wrong > v->hits / FEW_WRONG)
            refuse(v, &s, "too many hits are wrong, the first of them this one", l->verdict[k].first_wrong);
    }
}

static void judge(const view *v, ways *w, record *r) {
    *r = (record){.entry = v->entry, .rays = v->count, .hits = v->hits, .open = v->open, .worst = v->worst};
    make_lines(r);
    for (line *l = r->line; l < r->line + LINES; l++) judge_line(v, w, l);
}

static void clock_all(ways *w, record *r) {
    for (line *l = r->line; l < r->line + LINES; l++)
        for (int k = 0; k < TOLERANCES; k++) {
            setting s = setting_at(l, k);
            measure_take(&l->takes[k], ways_run(w, &s));
        }
}

static void settle(ways *w, record *r) {
    for (line *l = r->line; l < r->line + LINES; l++) {
        int drawn_so = (l->setting.way == WAY_PICTURE) == (l->setting.method == ALGSURF_METHOD_DEFAULT);
        l->settled = drawn_so ? ways_settled(w, &l->setting, accuracy_tolerances, TOLERANCES) : -1;
    }
}

/* ---- the run ---- */

static void print_head(const bench_options *o) {
    size pixels = size_of(o);
    measure_head("", (const char *const[]){legend, NULL});
    printf("kernel: %s\nrays: of the pixels of %d rows of a picture of %dx%d, view of the "
           "catalogue\nrepeat: %d\n",
           algsurf_kernel_name(0), pixels.rows, pixels.width, pixels.height, o->repeat);
}

static void run_all(const bench_options *o, record *records) {
    size_t count = (size_t)o->surfaces.count;
    size pixels = size_of(o);
    view **v = must_allocate(count, sizeof *v);
    ways **w = must_allocate(count, sizeof *w);
    for (size_t i = 0; i < count; i++) {
        v[i] = view_open(o->surfaces.entry[i], pixels.width, pixels.height, pixels.rows);
        w[i] = ways_open(v[i]);
        judge(v[i], w[i], &records[i]);
    }
    for (int turn = 0; turn < o->repeat; turn++)
        for (size_t i = 0; i < count; i++) clock_all(w[i], &records[i]);
    for (size_t i = 0; i < count; i++) {
        settle(w[i], &records[i]);
        ways_close(w[i]);
        view_close(v[i]);
    }
    free(v);
    free(w);
}

int main(int argc, char **argv) {
    static const char *const usual[] = {"tangle", "boy", "barth", "barth-decic"};
    bench_options o = {.repeat = 3, .surfaces = {.most = SURFACES_ROOM}};
    results_begin(&program, argc, argv, &o, &o.output);
    const int count = o.surfaces.count > 0 ? o.surfaces.count : 4;
    if (o.surfaces.count == 0) surfaces_add_named(&o.surfaces, usual, 4);
    record *records = must_allocate((size_t)count, sizeof *records);
    picture_record *pictures = must_allocate((size_t)count, sizeof *pictures);
    run_all(&o, records);
    for (int i = 0; i < count; i++) pictures_run(o.surfaces.entry[i], o.quick, o.repeat, &pictures[i]);
    print_head(&o);
    for (int i = 0; i < count; i++) report_table(&records[i]);
    pictures_report(pictures, count, o.output);
    report_advice(records, count);
    cli_finish_output();
    report_files(records, count, o.output);
    free(pictures);
    free(records);
    return 0;
}
