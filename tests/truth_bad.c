/* truth_bad.c - malformed and borderline rays and terms files.
 *
 *     truth_bad DATA_FOLDER
 *
 * What must be refused is refused with its outputs untouched; what must be accepted gives the exact
 * answer; for the rest a clean return is enough, unless the answer is a certificate that is false.
 * Catches: NaN taken for a miss, an exponent that wraps around, an overflow that hides a hit.
 */
#include "terms_file.h"
#include "truth_corpus.h"

enum { ID, TARGET, EXPECT, WHAT, CHECK, PAYLOAD, COLUMNS };

static int violations;

static void wrong(char *const *row, const char *what) {
    violations++;
    printf("WRONG %s (%s, %s): %s\n", row[ID], row[TARGET], row[WHAT], what);
}

static void refused_ray(char *const *row, const algsurf_surface *s, const algsurf_ray *ray) {
    algsurf_hit hit = {.state = 77}, hits[ALGSURF_MAX_DEGREE] = {{.state = 77}};
    int occluded = 1;
    int count = 77;
    if (algsurf_intersect_first(s, NULL, ray, NULL, &hit) >= 0) wrong(row, "first hit: not refused");
    if (algsurf_intersect_all(s, NULL, ray, NULL, hits, ALGSURF_MAX_DEGREE, &count) >= 0)
        wrong(row, "all hits: not refused");
    if (algsurf_occluded(s, NULL, ray, NULL, &occluded) >= 0) wrong(row, "occluded: not refused");
    if (hit.state != 77 || hits[0].state != 77 || count != 77 || occluded != 1)
        wrong(row, "refused, but an output was written");
}

/* The rows marked `any` all meet the surface, by construction of their lines, but for the one whose
 * denormal direction does not get anywhere: 1e300 * 2^-1074 is 5e-24. */
static int any_meets(char *const *row) { return strcmp(row[WHAT], "denormal direction") != 0; }

static void accepted_ray(char *const *row, const algsurf_surface *s, const algsurf_ray *ray) {
    const int any = !strcmp(row[EXPECT], "any");
    algsurf_hit hit, hits[ALGSURF_MAX_DEGREE];
    int occluded;
    int count;
    algsurf_status first = algsurf_intersect_first(s, NULL, ray, NULL, &hit);
    algsurf_status all = algsurf_intersect_all(s, NULL, ray, NULL, hits, ALGSURF_MAX_DEGREE, &count);
    algsurf_status blocked = algsurf_occluded(s, NULL, ray, NULL, &occluded);
    if (any && (first < 0 || all < 0 || blocked < 0)) return;
    if (first != ALGSURF_OK || all != ALGSURF_OK || blocked != ALGSURF_OK) {
        wrong(row, "refused");
        return;
    }
    int meets = any ? any_meets(row) : !strcmp(row[EXPECT], "ok");
    int false_state = meets ? ALGSURF_STATE_MISS : ALGSURF_STATE_HIT;
    if (hit.state == false_state) wrong(row, "first hit: a false certificate");
    if ((int)occluded == false_state) wrong(row, "occluded: a false certificate");
    if (meets ? count == 0 : count > 0 && hits[0].state == ALGSURF_STATE_HIT)
        wrong(row, "all hits: a false certificate");
    if (!strcmp(row[EXPECT], "empty") &&
        (hit.state != ALGSURF_STATE_MISS || count || occluded != ALGSURF_STATE_MISS))
        wrong(row, "an empty ray does not miss");
    if (!strcmp(row[EXPECT], "ok") && count != (int)truth_number(row[CHECK]))
        wrong(row, "the number of hits");
}

static void judge_ray(const char *folder, char *const *row) {
    char text[512], *field[9], *next = text;
    snprintf(text, sizeof text, "%s", row[PAYLOAD]);
    for (int i = 0; i < 9; i++) {
        field[i] = next;
        next += strcspn(next, " ");
        if (*next) *next++ = '\0';
    }
    const algsurf_surface *s = truth_surface(folder, field[0]);
    algsurf_ray ray = truth_ray(field + 1);
    if (!strcmp(row[EXPECT], "error"))
        refused_ray(row, s, &ray);
    else
        accepted_ray(row, s, &ray);
}

static void judge_terms(const char *folder, char *const *row) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, row[PAYLOAD]);
    FILE *file = fopen(path, "rb");
    if (!file) {
        wrong(row, "the file is missing");
        return;
    }
    algsurf_surface *s = NULL;
    terms_error error = {0};
    int read = terms_read_surface(file, &s, &error);
    fclose(file);
    if (read != 0 && (s || !error.message[0] || strchr(error.message, '\n')))
        wrong(row, "refused, but not with one line and no surface");
    if (strcmp(row[EXPECT], "any") != 0 && (read != 0) != !strcmp(row[EXPECT], "error"))
        wrong(row, read ? error.message : "not refused");
    if (read != 0) return;
    if (!strcmp(row[EXPECT], "empty") && algsurf_surface_degree(s) != 0) wrong(row, "not a constant");
    if (!strcmp(row[EXPECT], "ok")) {
        const double point[3] = {0.5, 0.25, 2};
        double value, bound, expected = truth_number(row[CHECK]);
        if (algsurf_surface_value(s, point, &value, &bound) != ALGSURF_OK ||
            !(fabs(value - expected) <= bound) || !(bound <= 1e-12 * fabs(expected)))
            wrong(row, "the value at (0.5, 0.25, 2)");
    }
    algsurf_surface_free(s);
}

int main(int argc, char **argv) {
    const char *folder = truth_folder(argc, argv);
    truth_table cases = truth_read(folder, "bad.tsv", COLUMNS);
    for (size_t i = 0; i < cases.rows; i++) {
        char **row = &cases.cell[i * cases.columns];
        if (!strcmp(row[TARGET], "ray"))
            judge_ray(folder, row);
        else if (!strcmp(row[TARGET], "terms"))
            judge_terms(folder, row);
        else
            wrong(row, "no such target");
    }
    printf("%zu cases, %d violations\n", cases.rows, violations);
    truth_surface(folder, NULL);
    truth_free(&cases);
    return violations ? 1 : 0;
}
