/* accuracy_report.c - see accuracy_report.h: what is printed. */
#include "accuracy_report.h"

#include <math.h>
#include <stdio.h>

#include "measure.h"

const double accuracy_tolerances[TOLERANCES] = {1e-1, 1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,
                                                1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 0};

enum { SHOWN = 4, CELL = 16, ALL_DIGITS = TOLERANCES - 1, COARSE = 2 };

/* The tolerances that the table shows: 1e-3, 1e-6, 1e-12, 0. */
static const int shown[SHOWN] = {COARSE, 5, 11, ALL_DIGITS};

double line_ns(const line *l, int tolerance, double share) {
    return 1e9 * measure_quantile(l->seconds[tolerance], l->taken, share);
}

const line *record_line(const record *r, way w, int method, int tier) {
    const line *l = r->line;
    while (l->setting.way != w || l->setting.method != method || l->setting.tier != tier) l++;
    return l;
}

/* ---- the table ---- */

static const char *tolerance_text(char text[CELL], double tolerance) {
    snprintf(text, CELL, tolerance > 0 ? "1e%.0f" : "0", tolerance > 0 ? log10(tolerance) : 0.0);
    return text;
}

static void print_titles(void) {
    char text[CELL];
    printf("%-8s%-13s%-9s", "", "", "");
    printf("  %-*s  %-*s  %-9s\n", 8 * SHOWN - 1, " ns a ray, at tolerance", 9 * SHOWN - 1,
           "99.9 % error of t, at tolerance", " largest");
    printf("%-8s%-13s%-9s ", "way", "method", "tier");
    for (int i = 0; i < SHOWN; i++) printf("%8s", tolerance_text(text, accuracy_tolerances[shown[i]]));
    printf(" ");
    for (int i = 0; i < SHOWN; i++) printf("%9s", tolerance_text(text, accuracy_tolerances[shown[i]]));
    printf("%10s%7s%7s%10s%9s\n", "at 0", "spread", "wrong", "undecided", "settled");
}

/* The most of all tolerances. */
static size_t most_wrong(const line *l) {
    size_t most = 0;
    for (int k = 0; k < TOLERANCES; k++) most = l->verdict[k].wrong > most ? l->verdict[k].wrong : most;
    return most;
}

/* Longest less shortest time over the median, median of all tolerances. */
static double spread(const line *l) {
    double each[TOLERANCES];
    for (int k = 0; k < TOLERANCES; k++) each[k] = (line_ns(l, k, 1) - line_ns(l, k, 0)) / line_ns(l, k, 0.5);
    measure_sort(each, TOLERANCES);
    return measure_quantile(each, TOLERANCES, 0.5);
}

static void print_line(const line *l) {
    char text[CELL];
    printf("%-8s%-13s%-9s ", way_name(l->setting.way), method_name(l->setting.method),
           tier_name(l->setting.tier));
    for (int i = 0; i < SHOWN; i++) printf("%8.1f", line_ns(l, shown[i], 0.5));
    printf(" ");
    for (int i = 0; i < SHOWN; i++) printf("%9.1e", l->verdict[shown[i]].usual);
    printf("%10.1e%6.0f%%%7zu", l->verdict[ALL_DIGITS].largest, 100 * spread(l), most_wrong(l));
    printf("%10zu%9s\n", l->verdict[ALL_DIGITS].undecided,
           l->settled < 0 ? "-" : tolerance_text(text, accuracy_tolerances[l->settled]));
}

void report_table(const record *r) {
    printf("\n%s, degree %d: %zu rays, %zu hit, %zu undecided; the reference is known to %.0e\n",
           r->entry->name, r->entry->degree, r->rays, r->hits, r->open, r->worst);
    print_titles();
    for (const line *l = r->line; l < r->line + LINES; l++) print_line(l);
}

/* ---- advice ---- */

/* The least and the largest of a number over all surfaces. */
typedef struct range {
    double lo, hi;
} range;

/* Time of one setting in units of another's. */
typedef struct ratio {
    way way, unit_way;
    int method, unit_method;
    int tier, unit_tier;
    int tolerance, unit_tolerance;
} ratio;

static range over_all(const record *records, int count, const ratio *q) {
    range all = {INFINITY, 0};
    for (const record *r = records; r < records + count; r++) {
        const line *l = record_line(r, q->way, q->method, q->tier),
                   *unit = record_line(r, q->unit_way, q->unit_method, q->unit_tier);
        double times = line_ns(l, q->tolerance, 0.5) / line_ns(unit, q->unit_tolerance, 0.5);
        all.lo = fmin(all.lo, times);
        all.hi = fmax(all.hi, times);
    }
    return all;
}

static void print_ratio(const record *records, int count, const char *text, const ratio *q) {
    range all = over_all(records, count, q);
    printf("    %-66s %5.2f .. %.2f\n", text, all.lo, all.hi);
}

#define DEFAULT .method = ALGSURF_METHOD_DEFAULT, .unit_method = ALGSURF_METHOD_DEFAULT
#define AT_0 .tolerance = ALL_DIGITS, .unit_tolerance = ALL_DIGITS

static const struct {
    const char *text;
    ratio ratio;
} ratios[] = {
    {"single call, all digits instead of 1e-3", {DEFAULT, .tolerance = ALL_DIGITS, .unit_tolerance = COARSE}},
    {"picture, all digits instead of 1e-3",
     {.way = WAY_PICTURE,
      .unit_way = WAY_PICTURE,
      DEFAULT,
      .tolerance = ALL_DIGITS,
      .unit_tolerance = COARSE}},
    {"single call instead of a packet", {.unit_way = WAY_PACKET, DEFAULT, AT_0}},
    {"single call instead of a picture", {.unit_way = WAY_PICTURE, DEFAULT, AT_0}},
    {"single call, certified instead of bounded", {.unit_tier = ALGSURF_TIER_BOUNDED, DEFAULT, AT_0}},
    {"picture, certified instead of bounded",
     {.way = WAY_PICTURE, .unit_way = WAY_PICTURE, .unit_tier = ALGSURF_TIER_BOUNDED, DEFAULT, AT_0}},
    {"single call, Brent instead of default", {.method = ALGSURF_METHOD_BRENT, AT_0}},
    {"single call, bisection instead of default", {.method = ALGSURF_METHOD_BISECTION, AT_0}},
    {"single call, regula falsi instead of default", {.method = ALGSURF_METHOD_REGULA_FALSI, AT_0}}};

/* Wrong answers, regula falsi's, added up over tolerances and surfaces. */
static size_t wrong_of(const record *records, int count) {
    size_t wrong = 0;
    for (const record *r = records; r < records + count; r++)
        for (const line *l = r->line; l < r->line + LINES; l++)
            for (int k = 0; k < TOLERANCES; k++) wrong += l->verdict[k].wrong;
    return wrong;
}

/* Rays, and of them those that doubles leave open. */
static size_t rays_of(const record *records, int count) {
    size_t rays = 0;
    for (const record *r = records; r < records + count; r++) rays += r->rays;
    return rays;
}

static size_t undecided_of(const record *records, int count) {
    size_t undecided = 0;
    for (const record *r = records; r < records + count; r++)
        undecided += record_line(r, WAY_SINGLE, ALGSURF_METHOD_DEFAULT, ALGSURF_TIER_BOUNDED)
                         ->verdict[ALL_DIGITS]
                         .undecided;
    return undecided;
}

/* The least tolerance from which on pictures do not change, over all surfaces. */
static double settled(const record *records, int count, int method) {
    int most = 0;
    way w = method == ALGSURF_METHOD_DEFAULT ? WAY_PICTURE : WAY_SINGLE;
    for (const record *r = records; r < records + count; r++) {
        const line *l = record_line(r, w, method, ALGSURF_TIER_CERTIFIED);
        most = l->settled > most ? l->settled : most;
    }
    return accuracy_tolerances[most];
}

void report_advice(const record *records, int count) {
    char at_default[CELL], at_brent[CELL], at_bisection[CELL];
    printf("\nWhat a choice costs, as a ratio of times, over the surfaces above:\n");
    for (size_t i = 0; i < sizeof ratios / sizeof *ratios; i++)
        print_ratio(records, count, ratios[i].text, &ratios[i].ratio);
    printf("\nWhich setting to choose:\n"
           "  - Rays that come in numbers: a packet, or a picture; no tolerance or method costs or saves as "
           "much\n    as solving rays side by side.\n"
           "  - A picture: the default method, certified tier, tolerance 0.  Its bytes no longer change "
           "below\n    tolerance %s (Brent: %s, bisection: %s); what a coarser one saves is in the second "
           "ratio.\n",
           tolerance_text(at_default, settled(records, count, ALGSURF_METHOD_DEFAULT)),
           tolerance_text(at_brent, settled(records, count, ALGSURF_METHOD_BRENT)),
           tolerance_text(at_bisection, settled(records, count, ALGSURF_METHOD_BISECTION)));
    printf(
        "  - Certified decides every ray; only what doubles leave open, here %zu of %zu rays, goes to\n"
        "    integers.  Bounded leaves that undecided, for hosts that need a bounded time for every ray.\n",
        undecided_of(records, count), rays_of(records, count));
    printf("  - Brent and bisection find the same roots, at the ratios above: partly the method's own (the\n"
           "    seed comparison tells which part), mostly that only the default has packet code, which a\n"
           "    single call uses, too.  Regula falsi is for comparison only: wrong %zu times, in all\n"
           "    tolerances and tiers.\n",
           wrong_of(records, count));
}
