/* test_status.c - texts, names, version.  Breaks caught: a code missing from a switch, a name or text of
 * another code, a version that differs from the header's.  check_layout holds the numbers. */
#include "algsurf/status.h"
#include "unit.h"

/* Every code of the list has its name and text, and no text occurs twice. */
TEST(test_names_and_texts) {
#define ENTRY(name, number, text) {name, #name, text},
    static const struct {
        algsurf_status status;
        const char *name, *text;
    } list[] = {ALGSURF_STATUS_LIST(ENTRY)};
#undef ENTRY
    assert_true(sizeof list / sizeof list[0] >= 20);
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        assert_string_equal(algsurf_status_name(list[i].status), list[i].name);
        assert_string_equal(algsurf_status_text(list[i].status), list[i].text);
        assert_true(strlen(list[i].text) > 0);
        for (size_t j = 0; j < i; j++) assert_string_not_equal(list[i].text, list[j].text);
    }
}

TEST(test_unknown) {
    static const int numbers[] = {-13, -100, 8, 1000};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        assert_string_equal(algsurf_status_text((algsurf_status)numbers[i]), "unknown status");
        assert_string_equal(algsurf_status_name((algsurf_status)numbers[i]), "unknown");
    }
}

TEST(test_version) {
    char expected[64];
    (void)snprintf(expected, sizeof expected, "%d.%d.%d", ALGSURF_VERSION_MAJOR, ALGSURF_VERSION_MINOR,
                   ALGSURF_VERSION_PATCH);
    assert_string_equal(algsurf_version(), expected);
#if ALGSURF_VERSION < 10000 || ALGSURF_VERSION >= 10000 * (ALGSURF_VERSION_MAJOR + 1)
    fail_msg("ALGSURF_VERSION is %d", ALGSURF_VERSION);
#endif
    int major, minor, patch, number = algsurf_version_number();
    assert_int_equal(sscanf(algsurf_version(), "%d.%d.%d", &major, &minor, &patch), 3);
    assert_int_equal(number, ALGSURF_VERSION);
    assert_int_equal(number / 10000, major);
    assert_int_equal(number / 100 % 100, minor);
    assert_int_equal(number % 100, patch);
}
