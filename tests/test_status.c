/* test_status.c - texts, names, version.  Breaks caught: a code missing from a switch, a name or text of
 * another code, a number that moved (they are ABI), a version that differs from the header's. */
#include "algsurf/status.h"
#include "unit.h"

static const struct {
    algsurf_status status;
    int number;
    const char *name;
} released[] = {
    /* the numbers of release 1.0, written out: never to be changed */
    {ALGSURF_E_ARGUMENT, -1, "ALGSURF_E_ARGUMENT"},
    {ALGSURF_E_NOT_FINITE, -2, "ALGSURF_E_NOT_FINITE"},
    {ALGSURF_E_NO_MEMORY, -3, "ALGSURF_E_NO_MEMORY"},
    {ALGSURF_E_DEGREE, -4, "ALGSURF_E_DEGREE"},
    {ALGSURF_E_SYNTAX, -5, "ALGSURF_E_SYNTAX"},
    {ALGSURF_E_ZERO, -6, "ALGSURF_E_ZERO"},
    {ALGSURF_E_RANGE, -7, "ALGSURF_E_RANGE"},
    {ALGSURF_E_THREAD, -8, "ALGSURF_E_THREAD"},
    {ALGSURF_E_BUILD, -9, "ALGSURF_E_BUILD"},
    {ALGSURF_E_NAME, -10, "ALGSURF_E_NAME"},
    {ALGSURF_E_SIZE, -11, "ALGSURF_E_SIZE"},
    {ALGSURF_E_CAPACITY, -12, "ALGSURF_E_CAPACITY"},
    {ALGSURF_OK, 0, "ALGSURF_OK"},
    {ALGSURF_UNDECIDED_MULTIPLE, 1, "ALGSURF_UNDECIDED_MULTIPLE"},
    {ALGSURF_UNDECIDED_END, 2, "ALGSURF_UNDECIDED_END"},
    {ALGSURF_UNDECIDED_ZERO, 3, "ALGSURF_UNDECIDED_ZERO"},
    {ALGSURF_UNDECIDED_RANGE, 4, "ALGSURF_UNDECIDED_RANGE"},
    {ALGSURF_NOT_CONVERGED, 5, "ALGSURF_NOT_CONVERGED"},
    {ALGSURF_CANCELLED, 6, "ALGSURF_CANCELLED"},
    {ALGSURF_NOT_VERIFIED, 7, "ALGSURF_NOT_VERIFIED"},
};
#define RELEASED (sizeof released / sizeof released[0])

TEST(test_numbers_and_names) {
    for (size_t i = 0; i < RELEASED; i++) {
        assert_int_equal((int)released[i].status, released[i].number);
        assert_string_equal(algsurf_status_name(released[i].status), released[i].name);
    }
}

/* Every code of the list is known here, has the text of the list, and no text occurs twice. */
TEST(test_texts) {
#define ENTRY(name, number, text) {name, text},
    static const struct {
        algsurf_status status;
        const char *text;
    } list[] = {ALGSURF_STATUS_LIST(ENTRY)};
#undef ENTRY
    assert_int_equal(sizeof list / sizeof list[0], RELEASED);
    for (size_t i = 0; i < RELEASED; i++) {
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
