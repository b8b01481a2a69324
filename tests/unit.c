/* unit.c - the list of a program's tests, as they stand, and of what the one that runs has made. */
#include "unit.h"

enum { MOST = 64 };

static struct CMUnitTest list[MOST];
static int lines[MOST], count;

static void (*setters[4])(const char *text);

void unit_argument(int i, void (*set)(const char *text)) { setters[i] = set; }

int unit_main(int argc, char **argv) {
    for (int i = 1; i < argc && i < 4; i++)
        if (setters[i]) setters[i](argv[i]);
    return unit_run(argc > 0 ? argv[0] : "tests");
}

static struct kept {
    void *made;
    void (*release)(void *made);
} *kept;
static size_t kept_count, kept_room;

void *unit_keep(void *made, void (*release)(void *made)) {
    if (kept_count == kept_room) {
        kept_room = 2 * kept_room + 16;
        kept = realloc(kept, kept_room * sizeof *kept);
        if (!kept) abort();
    }
    kept[kept_count++] = (struct kept){made, release};
    return made;
}

void unit_release(void) {
    while (kept_count > 0) kept_count--, kept[kept_count].release(kept[kept_count].made);
    free(kept);
    kept = NULL, kept_room = 0;
}

static int after_test(void **state) {
    (void)state;
    unit_release();
    return 0;
}

void unit_add(const char *name, CMUnitTestFunction test, int line) {
    int i = count++;
    if (i == MOST) abort();
    for (; i > 0 && lines[i - 1] > line; i--) list[i] = list[i - 1], lines[i] = lines[i - 1];
    list[i] = (struct CMUnitTest){name, test, NULL, after_test, NULL}, lines[i] = line;
}

int unit_run(const char *group) { return cmocka_run_group_tests_name(group, list, NULL, NULL); }
