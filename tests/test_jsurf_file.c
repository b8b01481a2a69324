/* test_jsurf_file.c - files of IMAGINARY's SURFER.  The files here were written for this test.
 *
 * Catches: an escape or a joined line that is not undone, a value of another key, a rotation by rows instead
 * of columns, a file that is none and passes. */
#include "jsurf_file.h"
#include "unit.h"

static int read_text(const char *text, jsurf_file *read, jsurf_error *error) {
    FILE *file = tmpfile();
    assert_non_null(file);
    fwrite(text, 1, strlen(text), file);
    rewind(file);
    int result = jsurf_read(file, read, error);
    fclose(file);
    return result;
}

static jsurf_file reads(const char *text) {
    jsurf_file read;
    jsurf_error error;
    if (read_text(text, &read, &error) != 0) fail_msg("%s: line %zu: %s", text, error.line, error.message);
    return read;
}

static void equation_of(const char *text, const char *expected) {
    jsurf_file read = reads(text);
    assert_string_equal(read.equation, expected);
    jsurf_release(&read);
}

static void near(double got, double expected) {
    if (!(fabs(got - expected) <= 1e-6)) fail_msg("%.17g, not %.17g", got, expected);
}

TEST(test_lines) {
    equation_of("surface_equation=x^2+y^2-1\n", "x^2+y^2-1");
    equation_of("surface_equation = x^2+y^2-1  ", "x^2+y^2-1");
    equation_of("  surface_equation:x", "x");
    equation_of("surface_equation x + y\r\n", "x + y");
    equation_of("#surface_equation=y\n!surface_equation=y\n\nsurface_equation=x\n", "x");
    equation_of("surface_equation=y\nsurface_equation=x\n", "x");
    equation_of("surface_equation=x^2 \\\n   + y^2 \\\n\t-1\nother=2\n", "x^2 + y^2 -1");
    equation_of("surface_equation=x\\\\\nscale_factor=0\n", "x\\");
    equation_of("surface_equation=x\\=1\\:2\\#\n", "x=1:2#");
    equation_of("surface_equation=x\\u00b2\\u22121", "x\u00b2\u22121");
    equation_of("surface_equation=x\\u12", "xu12");
    equation_of("surface_equation=x\xb2", "x\u00b2");     /* ISO 8859-1 */
    equation_of("surface_equation=x\xc2\xb2", "x\u00b2"); /* UTF-8 */
    equation_of("surface_equation=x\\", "x");
    equation_of("key=\nother\nsurface_equation=x", "x");
}

/* Catches: a light that is off, or numbered 8, or lit by another's line. */
TEST(test_lights) {
    jsurf_file read = reads("surface_equation=x\nlight_status_0=ON\nlight_position_0=-100.0 100.0 99\n"
                            "light_intensity_0=0.5\nlight_color_0=1.0 0.5 0.0\nlight_status_1=OFF\n"
                            "light_position_7=1 2 3\nlight_status_7=ON\nlight_status_8=ON\nlight_status_=?\n"
                            "light_type_0=POINT\nlight_status_2=ON\nlight_color_17=x\n");
    const jsurf_light *light = read.lights;
    assert_true(light[0].on && light[0].placed && !light[1].on && light[2].on && !light[2].placed);
    assert_true(light[7].on && light[7].placed && light[7].intensity == 1 && light[7].colour.srgb[2] == 255);
    near(light[0].place[2], 99), near(light[7].place[1], 2), near(light[0].intensity, 0.5);
    assert_int_equal(light[0].colour.srgb[1], 128);
    jsurf_release(&read);
    static const char *const bad[] = {"light_status_0=on", "light_intensity_0=-1", "light_position_1=1 2",
                                      "light_position_1=1 2 1e7", "light_color_0=red"};
    for (size_t c = 0; c < sizeof bad / sizeof *bad; c++) {
        char text[128];
        jsurf_error error;
        sprintf(text, "surface_equation=x\n%s\n", bad[c]);
        if (read_text(text, &read, &error) == 0) fail_msg("%s", bad[c]);
        assert_int_equal(error.line, 2);
    }
}

TEST(test_values) {
    jsurf_file read =
        reads("#a comment\n"
              "surface_equation=x^2+a*y^2+b\n"
              "surface_parameter_b=-0.25\n#0.5\nsurface_parameter_a=1\nsurface_parameter_a=0.75\n"
              "scale_factor=0.30102999566398120\n"
              "rotation_matrix=0.0 0.0 1.0 0.0 1.0 0.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 0.0 0.0 1.0\n"
              "camera_type=PERSPECTIVE_CAMERA\ncamera_fov_y=45.0\n"
              "front_material_color=1.0 0.5 0.0\nback_material_color=0 0 1\n"
              "background_color=0.2 0.2 1.5\nlight_kind_0=nonsense\n");
    assert_int_equal(read.parameter_count, 2);
    assert_string_equal(read.parameters[0].name, "b");
    assert_string_equal(read.parameters[0].value, "-0.25");
    assert_string_equal(read.parameters[1].name, "a");
    assert_string_equal(read.parameters[1].value, "0.75");
    near(read.radius, 2);
    near(read.back[0], 1), near(read.back[1], 0), near(read.back[2], 0);
    near(read.up[0], 0), near(read.up[1], 0), near(read.up[2], 1);
    assert_true(read.perspective && read.fov == 45);
    const uint8_t colours[3][3] = {{255, 128, 0}, {0, 0, 255}, {51, 51, 255}};
    assert_memory_equal(read.front.srgb, colours[0], 3);
    assert_memory_equal(read.inside.srgb, colours[1], 3);
    assert_memory_equal(read.background.srgb, colours[2], 3);
    jsurf_release(&read);

    read = reads("surface_equation=x\n");
    assert_true(!read.perspective && !read.front.given && read.parameter_count == 0);
    near(read.radius, 1), near(read.height, 2), near(read.back[2], 1), near(read.up[1], 1);
    jsurf_release(&read);

    read = reads("surface_equation=x\n" /* as newer programs write it */
                 "transform_matrix=0 -1 0 0  1 0 0 0  0 0 1 0  0 0 0 1\n"
                 "surface_transform_matrix=3 0 0 0  0 3 0 0  0 0 3 0  0 0 0 1\n");
    near(read.radius, 3), near(read.up[0], -1), near(read.up[1], 0), near(read.back[2], 1);
    jsurf_release(&read);
}

TEST(test_refused) {
    static const struct {
        const char *text;
        size_t line;
        const char *why;
    } cases[] = {
        {"", 0, "no surface_equation"},
        {"\x89PNG\r\n", 0, "no surface_equation"},
        {"surface_equation=x\nscale_factor=big\n", 2, "scale_factor"},
        {"surface_equation=x\nscale_factor=nan\n", 2, "scale_factor"},
        {"surface_equation=x\nscale_factor=1 2\n", 2, "scale_factor"},
        {"surface_equation=x\nscale_factor=99.9\nsurface_transform_matrix=1e9 0 0 0 0 1e9 0 0 0 0 1e9 0 0 0 "
         "0 1\n",
         0, "scale_factor"},
        {"surface_equation=x\nsurface_parameter_a=b\n", 2, "a number"},
        {"surface_equation=x\n\n#\nrotation_matrix=1 0 0\n", 4, "16 numbers"},
        {"surface_equation=x\nrotation_matrix=1 0 0 0 0 1 0 0 0 0 0 0 0 0 0 1\n", 0, "a rotation"},
        {"surface_equation=x\nrotation_matrix=2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1\n", 0, "a rotation"},
        {"surface_equation=x\nrotation_matrix=1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1\n", 0, "a rotation"},
        {"surface_equation=x\nrotation_matrix=1 0.5 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n", 0, "a rotation"},
        {"surface_equation=x\nsurface_transform_matrix=1 0 0 0 0 2 0 0 0 0 1 0 0 0 0 1\n", 0, "a scale"},
        {"surface_equation=x\ncamera_type=FISHEYE\n", 2, "PERSPECTIVE_CAMERA"},
        {"surface_equation=x\ncamera_fov_y=180\n", 2, "camera_fov_y"},
        {"surface_equation=x\ncamera_height=0\n", 2, "camera_height"},
        {"surface_equation=x\nback_material_color=1 1\n", 2, "red, green and blue"},
        {"surface_equation=x\nbackground_color=1 1 inf\n", 2, "red, green and blue"},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        jsurf_file read;
        jsurf_error error;
        if (read_text(cases[c].text, &read, &error) != -1) fail_msg("accepted: %s", cases[c].text);
        if (error.line != cases[c].line || !strstr(error.message, cases[c].why) || error.no_memory)
            fail_msg("%s: line %zu: %s", cases[c].text, error.line, error.message);
    }
}

TEST(test_names) {
    assert_true(jsurf_is_name("a.jsurf") && jsurf_is_name("b/c.JSurf") && jsurf_is_name("a.b.jsurf"));
    assert_false(jsurf_is_name(".jsurf") || jsurf_is_name("jsurf") || jsurf_is_name("a.jsurf2") ||
                 jsurf_is_name("") || jsurf_is_name("a.surf"));
}
