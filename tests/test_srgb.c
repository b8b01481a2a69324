/* test_srgb.c - the bytes of linear light, against the definition of sRGB.
 *
 * Breaks tried, each caught by the test named:
 *   a threshold that is one higher, bytes one step late                    every_step
 *   steps cut off instead of rounded                                       between_steps
 *   another power, the straight part too long                              there_and_back
 *   no clamping                                                            ends
 *   NaN and infinities accepted                                            refused
 */
#include "algsurf/shade.h"
#include "environments.h"
#include "picture/colours.h"

/* IEC 61966-2-1: 0..1, from linear light to what is stored, and back. */
static double shown_of(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
}

static double light_of(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : pow((shown + 0.055) / 1.055, 2.4);
}

static int byte_of(double light) {
    const double colour[3] = {light, 0, 1};
    unsigned char bytes[3];
    assert_ok(algsurf_srgb_encode(colour, bytes));
    assert_true(bytes[1] == 0 && bytes[2] == 255);
    return bytes[0];
}

/* No step is so close to a half that pow could decide it otherwise. */
TEST(every_step) {
    uint8_t curve[SRGB_STEPS];
    double nearest = 1;
    algsurf_i_srgb_curve(curve);
    for (int step = 0; step < SRGB_STEPS; step++) {
        double shown = 255 * shown_of(step / 4095.0);
        nearest = fmin(nearest, fabs(shown - floor(shown) - 0.5));
        assert_int_equal(curve[step], (int)floor(shown + 0.5));
        assert_int_equal(byte_of(step / 4095.0), curve[step]);
    }
    assert_true(nearest > 1e-9);
}

/* Between steps the nearest one counts. */
TEST(between_steps) {
    for (int step = 0; step < 4095; step++) {
        int below = byte_of(step / 4095.0), above = byte_of((step + 1) / 4095.0);
        assert_int_equal(byte_of((step + 0.498) / 4095), below);
        assert_int_equal(byte_of((step + 0.502) / 4095), above);
        assert_true(above == below || above == below + 1);
    }
}

TEST(there_and_back) {
    for (int b = 0; b < 256; b++) {
        const unsigned char bytes[3] = {(unsigned char)b, (unsigned char)(255 - b), 7};
        unsigned char back[3];
        double colour[3];
        assert_ok(algsurf_srgb_decode(bytes, colour));
        for (int k = 0; k < 3; k++) {
            double expected = light_of(bytes[k] / 255.0);
            assert_true(fabs(colour[k] - expected) <= 1e-14 * expected);
        }
        assert_ok(algsurf_srgb_encode(colour, back));
        assert_memory_equal(back, bytes, sizeof bytes);
    }
}

TEST(ends) {
    const unsigned char black_white[3] = {0, 255, 0};
    double colour[3];
    assert_true(byte_of(-1e308) == 0 && byte_of(-0x1p-1074) == 0 && byte_of(-0.0) == 0);
    assert_true(byte_of(1.0000001) == 255 && byte_of(1e308) == 255);
    assert_ok(algsurf_srgb_decode(black_white, colour));
    assert_true(colour[0] == 0 && colour[1] == 1);
}

TEST(refused) {
    double colour[3] = {0.5, 0.5, 0.5};
    unsigned char bytes[3] = {7, 8, 9};
    assert_int_equal(algsurf_srgb_encode(NULL, bytes), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_srgb_encode(colour, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_srgb_decode(NULL, colour), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_srgb_decode(bytes, NULL), ALGSURF_E_ARGUMENT);
    for (int k = 0; k < 3; k++)
        for (int which = 0; which < 3; which++) {
            double bad[3] = {0.5, 0.5, 0.5};
            bad[k] = which == 0 ? NAN : which == 1 ? INFINITY : -INFINITY;
            assert_int_equal(algsurf_srgb_encode(bad, bytes), ALGSURF_E_NOT_FINITE);
        }
    assert_true(bytes[0] == 7 && bytes[1] == 8 && bytes[2] == 9 && colour[0] == 0.5);
}

static double between[256][3];

typedef struct curve {
    double colours[256][3];
    unsigned char bytes[256][3];
} curve;

static void both_ways(void *answers) {
    curve *to = answers;
    for (int b = 0; b < 256; b++) {
        const unsigned char bytes[3] = {(unsigned char)b, (unsigned char)b, (unsigned char)b};
        (void)algsurf_srgb_decode(bytes, to->colours[b]);
        (void)algsurf_srgb_encode(between[b], to->bytes[b]);
    }
}

TEST(any_environment) {
    for (int b = 0; b < 256; b++)
        between[b][0] = (b + 0.37) / 256, between[b][1] = (16 * b + 0.5) / 4095, between[b][2] = b / 255.0;
    environments_agree(both_ways, sizeof(curve));
}
