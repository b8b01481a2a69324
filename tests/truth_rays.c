/* truth_rays.c - the library's hits against certified ones.
 *
 *     truth_rays DATA_FOLDER
 *
 * Every ray of truth/rays.tsv is asked for its first hit and all its hits, whether it is blocked at all, and
 * once more by the calls for packets.  In the certified tier every ray must be decided, and rightly, with the
 * multiplicity; an enclosure must enclose the exact root, and t must be as good as the inputs' last digits
 * allow.  The bounded tier must be right where it decides, and decide nearly all rays but those that doubles
 * cannot see through: roots together, at an end, or on a chord far longer than the surface.
 *
 * Prints a table for each query, a line for each violation, and fails if there is one.  Catches: a
 * second root taken for the first, a root lost at an end of the ray, an enclosure off by one ulp, a
 * sign believed inside its error bound, digits lost to a far eye, and a solver that hides behind
 * "undecided".
 */
#include "base/eft.h"
#include "packet_case.h"
#include "truth_corpus.h"

enum { ID, KIND, NOTE, SURFACE, RAY, N_ROOTS = 12, KABS = 21, ACOND, RAY_COLUMNS = 27 };
enum { ROOT_ID, ROOT_K, ROOT_MULT, ROOT_HI = 4, ROOT_LO, ROOT_COLUMNS };
enum { FIRST, FIRST_BOUNDED, ALL, OCCLUDED, FIRST_PACKET, OCCLUDED_PACKET, QUERIES };
enum { KINDS = 16 };

static const char *const query_name[QUERIES] = {"first hit", "first hit, bounded", "all hits",
                                                "occluded",  "first hit, packet",  "occluded, packet"};

typedef struct exact_root {
    algsurf_dd t; /* to 2^-104, and exactly t.hi when t.lo is 0 */
    int mult;
} exact_root;

typedef struct truth {
    const char *id, *kind, *note;
    algsurf_ray ray;
    int in_surface; /* the ray lies in the surface: every t is a root */
    int n;
    exact_root root[ALGSURF_MAX_DEGREE];
    double kabs, acond;
} truth;

typedef struct tally {
    const char *kind;
    int rows, hits, misses, undecided, wrong;
    double worst; /* error of t in units of u acond + ulp(t)/2 */
} tally;

static tally tallies[QUERIES][KINDS];
static int violations;

static tally *tally_of(int query, const truth *r) {
    tally *y = tallies[query];
    while (y->kind && strcmp(y->kind, r->kind) != 0) y++;
    y->kind = r->kind;
    return y;
}

static void wrong(int query, const truth *r, const char *what, const algsurf_hit *hit) {
    violations++;
    tally_of(query, r)->wrong++;
    printf("WRONG %s %s %s: %s: %s", r->id, r->kind, r->note, query_name[query], what);
    if (hit) printf(" (state %d, t %a, [%a, %a])", hit->state, hit->t, hit->t_lo, hit->t_hi);
    if (r->n)
        printf(" (roots: %d, first %a%+a x%d)", r->n, r->root[0].t.hi, r->root[0].t.lo, r->root[0].mult);
    printf("\n");
}

static void count_state(int query, const truth *r, int state) {
    tally *y = tally_of(query, r);
    y->rows++;
    if (state == ALGSURF_STATE_HIT) y->hits++;
    if (state == ALGSURF_STATE_MISS) y->misses++;
    if (state == ALGSURF_STATE_UNDECIDED) y->undecided++;
}

static int at_least(algsurf_dd t, double lo) { return lo < t.hi || (lo == t.hi && t.lo >= 0); }
static int at_most(algsurf_dd t, double hi) { return hi > t.hi || (hi == t.hi && t.lo <= 0); }

static double ulp(double t) { return nextafter(fabs(t), INFINITY) - fabs(t); }

static double error_of(double t, algsurf_dd exact) {
    algsurf_dd d = algsurf_two_sum(t, -exact.hi);
    return fabs(d.hi + (d.lo - exact.lo));
}

/* The error of the first root's t against what its condition allows. */
static void judge_error(int query, const truth *r, const algsurf_hit *hit) {
    const exact_root *e = &r->root[0];
    double error = error_of(hit->t, e->t);
    if (e->mult == 1) {
        double unit = ALGSURF_U * r->acond + ulp(e->t.hi) / 2;
        tally *y = tally_of(query, r);
        if (!(error <= 4 * unit)) wrong(query, r, "t is too far from the root", hit);
        if (!(error / unit <= y->worst)) y->worst = error / unit;
    } else if (!(error <= 4 * pow(ALGSURF_U * r->kabs, 1.0 / e->mult) + 2 * ulp(e->t.hi))) {
        wrong(query, r, "t is too far from the multiple root", hit);
    }
}

static void judge_first_hit(int query, const truth *r, const algsurf_hit *hit) {
    count_state(query, r, hit->state);
    if (hit->state == ALGSURF_STATE_MISS) {
        if (r->n || r->in_surface) wrong(query, r, "a miss is told, there is a root", hit);
        if (!(hit->t == INFINITY && hit->t_lo == INFINITY && hit->t_hi == INFINITY))
            wrong(query, r, "a miss with a finite t", hit);
    } else if (hit->state == ALGSURF_STATE_HIT) {
        if (r->in_surface) {
            if (hit->multiplicity != 0) wrong(query, r, "a ray in the surface with a multiplicity", hit);
            return;
        }
        if (!r->n) {
            wrong(query, r, "a hit is told, there is no root", hit);
            return;
        }
        if (!at_least(r->root[0].t, hit->t_lo) || !at_most(r->root[0].t, hit->t_hi))
            wrong(query, r, "the first root is not enclosed", hit);
        judge_error(query, r, hit);
        if (hit->multiplicity != r->root[0].mult) wrong(query, r, "another multiplicity", hit);
    } else {
        if (query != FIRST_BOUNDED) wrong(query, r, "undecided, but decidable", hit);
        if (hit->reason <= ALGSURF_OK) wrong(query, r, "undecided for no reason", hit);
        if (r->n && !at_least(r->root[0].t, hit->t_lo))
            wrong(query, r, "a root before the undecided place", hit);
    }
}

static const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};

static void judge_first(int query, const algsurf_surface *s, const truth *r) {
    algsurf_hit hit;
    const algsurf_intersect_options *o = query == FIRST_BOUNDED ? &bounded : NULL;
    if (algsurf_intersect_first(s, NULL, &r->ray, o, &hit) != ALGSURF_OK)
        wrong(query, r, "refused", NULL);
    else
        judge_first_hit(query, r, &hit);
}

static int covers(const algsurf_hit *h, const exact_root *root) {
    return at_least(root->t, h->t_lo) && at_most(root->t, h->t_hi);
}

/* Each hit holds a root of its own, in order, and no root lies outside the entries. */
static void pair_off(int query, const truth *r, const algsurf_hit *hits, int count) {
    int next = 0;
    for (int i = 0; i < count; i++) {
        if (hits[i].state != ALGSURF_STATE_HIT) continue;
        while (next < r->n && !covers(&hits[i], &r->root[next])) next++;
        if (next == r->n) wrong(query, r, "a hit encloses no further root", &hits[i]);
        if (next < r->n && hits[i].multiplicity != r->root[next].mult)
            wrong(query, r, "another multiplicity", &hits[i]);
        if (next < r->n) next++;
    }
    for (int k = 0; k < r->n; k++) {
        int covered = 0;
        for (int i = 0; i < count; i++) covered |= covers(&hits[i], &r->root[k]);
        if (!covered) wrong(query, r, "a root is missing", count ? &hits[0] : NULL);
    }
}

static void judge_all(const algsurf_surface *s, const truth *r) {
    const int query = ALL;
    algsurf_hit hits[ALGSURF_MAX_DEGREE];
    int count, open = 0;
    if (algsurf_intersect_all(s, NULL, &r->ray, NULL, hits, ALGSURF_MAX_DEGREE, &count) != ALGSURF_OK) {
        wrong(query, r, "refused", NULL);
        return;
    }
    for (int i = 0; i < count; i++) {
        open |= hits[i].state == ALGSURF_STATE_UNDECIDED;
        if (i > 0 && !(hits[i].t_lo >= hits[i - 1].t_lo))
            wrong(query, r, "not in increasing order", &hits[i]);
    }
    count_state(query, r, open ? ALGSURF_STATE_UNDECIDED : count ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS);
    if (!r->in_surface) pair_off(query, r, hits, count);
    if (r->in_surface && !count) wrong(query, r, "the ray lies in the surface, and nothing is told", NULL);
    if (!open && !r->in_surface && count != r->n) wrong(query, r, "the number of hits", NULL);
    if (open) wrong(query, r, "undecided, but decidable", &hits[0]);
}

static void judge_whether(int query, const truth *r, int state) {
    count_state(query, r, state);
    if (state == ALGSURF_STATE_MISS && (r->n || r->in_surface)) wrong(query, r, "told free", NULL);
    if (state == ALGSURF_STATE_HIT && !r->n && !r->in_surface) wrong(query, r, "told occluded", NULL);
    if (state == ALGSURF_STATE_UNDECIDED) wrong(query, r, "undecided, but decidable", NULL);
}

static void judge_occluded(const algsurf_surface *s, const truth *r) {
    int state;
    if (algsurf_occluded(s, NULL, &r->ray, NULL, &state) != ALGSURF_OK)
        wrong(OCCLUDED, r, "refused", NULL);
    else
        judge_whether(OCCLUDED, r, (int)state);
}

/* Packets of one ray: their answers do not depend on others. */
static void judge_packets(const algsurf_surface *s, const truth *r) {
    static packet_case p;
    packet_put(&p, 0, &r->ray);
    if (packet_ask(&p, 0, 1, s, NULL, NULL) != ALGSURF_OK) {
        wrong(FIRST_PACKET, r, "refused", NULL);
        return;
    }
    algsurf_hit hit = packet_hit(&p, 0);
    hit.reason = ALGSURF_UNDECIDED_MULTIPLE; /* packets do not tell */
    judge_first_hit(FIRST_PACKET, r, &hit);
    judge_whether(OCCLUDED_PACKET, r, p.occluded[0]);
}

static double number_or(const char *text, double otherwise) {
    return strcmp(text, "-") == 0 ? otherwise : truth_number(text);
}

/* Row i of the table; its roots start at *next in the table of roots. */
static truth truth_of(const truth_table *rays, const truth_table *roots, size_t i, size_t *next) {
    char **c = &rays->cell[i * rays->columns];
    truth r = {.id = c[ID], .kind = c[KIND], .note = c[NOTE], .ray = truth_ray(c + RAY)};
    r.in_surface = !strcmp(c[N_ROOTS], "all");
    r.n = r.in_surface ? 0 : (int)truth_number(c[N_ROOTS]);
    for (int k = 0; k < r.n; k++, ++*next) {
        char **d = &roots->cell[*next * roots->columns];
        if (*next >= roots->rows || strcmp(d[ROOT_ID], r.id) != 0) {
            fprintf(stderr, "truth_rays: %s: root %d is not in its place\n", r.id, k);
            exit(2);
        }
        r.root[k].t = (algsurf_dd){truth_number(d[ROOT_HI]), truth_number(d[ROOT_LO])};
        r.root[k].mult = (int)truth_number(d[ROOT_MULT]);
    }
    r.kabs = number_or(c[KABS], 0);
    r.acond = number_or(c[ACOND], 0);
    return r;
}

/* A tier that leaves everything undecided is never wrong: percent of a kind that it may.  Of rays that end at
 * a root, or a few digits beside it, all are: no rounded value shows on which side the root is. */
static void judge_bounded(void) {
    static const struct {
        const char *kind;
        int percent;
    } most[] = {{"generic", 1}, {"grazing", 40},   {"far", 28},      {"scale", 0},
                {"axis", 7},    {"unnorm", 0},     {"tangent", 77},  {"onsurf", 85},
                {"inside", 0},  {"endpoint", 100}, {"singular", 43}, {"degenerate", 75}};
    for (const tally *y = tallies[FIRST_BOUNDED]; y->kind; y++) {
        size_t i = 0;
        while (i < sizeof most / sizeof *most && strcmp(y->kind, most[i].kind) != 0) i++;
        if (i < sizeof most / sizeof *most && y->undecided * 100 <= y->rows * most[i].percent) continue;
        fprintf(stderr, "truth_rays: the bounded tier leaves %d of %d rays undecided: %s\n", y->undecided,
                y->rows, y->kind);
        violations++;
    }
}

static void print_tables(void) {
    for (int q = 0; q < QUERIES; q++) {
        printf("\n%-20s %6s %6s %6s %9s %6s %10s\n", query_name[q], "rows", "hit", "miss", "undecided",
               "wrong", "worst");
        for (const tally *y = tallies[q]; y->kind; y++)
            printf("  %-18s %6d %6d %6d %9d %6d %10.3g\n", y->kind, y->rows, y->hits, y->misses, y->undecided,
                   y->wrong, y->worst);
    }
    printf("\nworst: error of t for a simple first root, in units of u acond + ulp/2\n");
}

int main(int argc, char **argv) {
    const char *folder = truth_folder(argc, argv);
    truth_table rays = truth_read(folder, "rays.tsv", RAY_COLUMNS);
    truth_table roots = truth_read(folder, "ray_roots.tsv", ROOT_COLUMNS);
    size_t next = 0;
    for (size_t i = 0; i < rays.rows; i++) {
        truth r = truth_of(&rays, &roots, i, &next);
        const algsurf_surface *s = truth_surface(folder, truth_cell(&rays, i, SURFACE));
        judge_first(FIRST, s, &r);
        judge_first(FIRST_BOUNDED, s, &r);
        judge_all(s, &r);
        judge_occluded(s, &r);
        judge_packets(s, &r);
    }
    print_tables();
    judge_bounded();
    printf("%zu rays, %zu roots, %d violations\n", rays.rows, next, violations);
    truth_surface(folder, NULL);
    truth_free(&rays);
    truth_free(&roots);
    return violations ? 1 : 0;
}
