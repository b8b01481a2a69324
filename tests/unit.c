/* unit.c - the list of a program's tests, in the order in which they stand. */
#include "unit.h"

enum { MOST = 64 };

static struct CMUnitTest list[MOST];
static int lines[MOST], count;

void unit_add(const char *name, CMUnitTestFunction test, int line) {
    int i = count++;
    if (i == MOST) abort();
    for (; i > 0 && lines[i - 1] > line; i--) list[i] = list[i - 1], lines[i] = lines[i - 1];
    list[i] = (struct CMUnitTest){name, test, NULL, NULL, NULL}, lines[i] = line;
}

int unit_run(const char *group) { return cmocka_run_group_tests_name(group, list, NULL, NULL); }
