/* test_terms_file.c - the reader of terms files; tests/data/bad has more cases (truth_bad).
 *
 * Breaks that were tried and are caught: exponents added up digit by digit without a check for overflow,
 * a coefficient that strtod reads in part, infinite ones, a fifth field, a line number off by one, a
 * comment that hides the field before it, text after a NUL byte dropped, a byte order mark or a CR kept.
 */

#include "catalogue.h"
#include "scenes.h"
#include "terms_file.h"

static FILE *file_of(const char *text, size_t length) {
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, length, file), length);
    rewind(file);
    return file;
}

static void accepts(const char *text, const algsurf_term *expected, size_t count) {
    FILE *file = file_of(text, strlen(text));
    algsurf_surface *surface = NULL;
    terms_error error;
    if (terms_read_surface(file, &surface, &error) != 0) fail_msg("'%s': %s", text, error.message);
    fclose(file);
    algsurf_term terms[8];
    assert_int_equal(algsurf_surface_term_count(surface), count);
    assert_true(count <= 8);
    assert_ok(algsurf_surface_terms(surface, terms));
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(terms[i].i, expected[i].i);
        assert_int_equal(terms[i].j, expected[i].j);
        assert_int_equal(terms[i].k, expected[i].k);
        assert_true(terms[i].a == expected[i].a);
    }
    algsurf_surface_free(surface);
}

/* Refused at that line, with one printable line that holds `part`. */
static void refuses_bytes(const char *text, size_t length, size_t line, const char *part) {
    FILE *file = file_of(text, length);
    algsurf_surface *const untouched = (algsurf_surface *)(void *)&file, *surface = untouched;
    terms_error error;
    assert_int_equal(terms_read_surface(file, &surface, &error), -1);
    fclose(file);
    assert_ptr_equal(surface, untouched);
    assert_int_equal(error.line, line);
    assert_int_equal(error.no_memory, 0);
    if (!strstr(error.message, part)) fail_msg("'%s': '%s' lacks '%s'", text, error.message, part);
    for (const char *c = error.message; *c; c++) assert_true((*c >= ' ' && *c != 0x7f) || *c < 0);
}

static void refuses(const char *text, size_t line, const char *part) {
    refuses_bytes(text, strlen(text), line, part);
}

TEST(test_accepted) {
    static const algsurf_term sphere[] = {{0, 0, 2, 1}, {0, 2, 0, 1}, {2, 0, 0, 1}, {0, 0, 0, -1}};
    static const algsurf_term line[] = {{1, 0, 0, 1.5}};
    accepts("2 0 0 1\n0 2 0 1\n0 0 2 1\n0 0 0 -1\n",
            (algsurf_term[]){sphere[0], sphere[1], sphere[2], sphere[3]}, 4);
    accepts("# sphere\r\n\r\n 2\t0  0 1 # x\r\n0 2 0 0x1p0\r\n0 0 2 +1.0e0\r\n0 0 0 -1", sphere, 4);
    accepts("\xef\xbb\xbf"
            "1 0 0 1.5",
            line, 1);
    accepts("1 0 0 1\n1 0 0 0.5\n0 0 3 0\n", line, 1);
    accepts("001 0 00 1.5#", line, 1);
    accepts("1 0 0 1e-999\n1 0 0 1.5\n", line, 1);
}

TEST(test_fields) {
    refuses("", 0, "no terms");
    refuses("# nothing\n\n", 0, "no terms");
    refuses("1 0 0 0\n", 0, "zero");
    refuses("1 0 0 1\n1 0 0 -1\n", 0, "zero");
    refuses("1 0 0 1\n\n# comment\n1 0 0\n", 4, "got 3");
    refuses("1 0 0 1 2", 1, "got 5");
    refuses("1 0 0 #1", 1, "got 3");
    refuses("1,0,0,1", 1, "got 1");
    refuses("\r1 0 0 1", 1, "exponent"); /* CR ends a line only before LF */
    refuses_bytes("1 0 0 1\n0 0\0 0 1\n", 17, 2, "NUL");
    refuses_bytes("\0", 1, 1, "NUL");
}

TEST(test_exponents) {
    static const char *const bad[] = {
        "-1",         "+3",         "0x2",         "1.0",
        "2e0",        "x",          "1a",          "65",
        "2147483648", "4294967296", "4294967298",  "18446744073709551618",
        "1_0",        "\xc3\xa9",   "-2147483648", "99999999999999999999999999999"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int field = 0; field < 3; field++) {
            char text[128];
            snprintf(text, sizeof text, "1 0 0 1\n%s %s %s 1\n", field == 0 ? bad[i] : "0",
                     field == 1 ? bad[i] : "0", field == 2 ? bad[i] : "0");
            refuses(text, 2, "exponent");
        }
    refuses("64 0 1 1", 1, "degree 65");
    refuses("64 64 64 1", 1, "degree 192");
}

TEST(test_coefficients) {
    static const char *const bad[] = {"nan", "NaN", "inf", "-infinity", "1e400", "-0x1p1024", "nan(1)"};
    static const char *const no_numbers[] = {"x",     "1x",  "0x",  "0x1p", "1e",
                                             "1.2.3", "--1", "1,5", "/",    "1\v"};
    char text[64];
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        snprintf(text, sizeof text, "\n1 0 0 %s", bad[i]);
        refuses(text, 2, "finite");
    }
    for (size_t i = 0; i < sizeof no_numbers / sizeof *no_numbers; i++) {
        snprintf(text, sizeof text, "1 0 0 %s", no_numbers[i]);
        refuses(text, 1, "number");
    }
}

/* Lines of many megabytes take no longer than their bytes do. */
TEST(test_long_lines) {
    const size_t length = (size_t)8 << 20;
    char *text = malloc(length + 16);
    assert_non_null(text);
    double start = unit_seconds();
    memset(text, ' ', length);
    memcpy(text + length, "1 0 0 1.5\n", 11);
    accepts(text, (algsurf_term[]){{1, 0, 0, 1.5}}, 1);
    text[length] = '\0';
    for (size_t i = 0; i < length; i++) text[i] = i % 2 ? ' ' : '1';
    refuses(text, 1, "fields");
    memset(text, '9', length);
    refuses(text, 1, "fields");
    memcpy(text, "1 0 0 ", 6);
    strcpy(text + length, "e-8388600");
    FILE *file = file_of(text, strlen(text));
    algsurf_surface *surface = NULL;
    terms_error error;
    (void)terms_read_surface(file, &surface, &error); /* any answer, but soon */
    fclose(file);
    algsurf_surface_free(surface);
    assert_true(unit_seconds() - start < 5);
    free(text);
}

/* Every catalogued equation is what its degree says, and its default view is a camera. */
TEST(test_catalogue) {
    assert_null(catalogue_find(""));
    assert_null(catalogue_find("Sphere"));
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        algsurf_camera camera;
        assert_ptr_equal(catalogue_find(entry->name), entry);
        algsurf_surface *surface = surface_of(entry->equation);
        assert_int_equal(algsurf_surface_degree(surface), entry->degree);
        assert_ok(algsurf_camera_pinhole(entry->eye, entry->look_at, entry->up, entry->fov, &camera));
    }
}
