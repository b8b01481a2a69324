/* test_colour.c - colours as text.  Catches: a digit in the wrong place, a name cut short, a text that is no
 * colour and passes. */
#include "cli_guess.h"
#include "colour.h"
#include "unit.h"

static void reads(const char *text, int red, int green, int blue) {
    css_colour c = {{1, 2, 3}, 0};
    if (!colour_read(text, &c)) fail_msg("'%s' is refused", text);
    if (c.srgb[0] != red || c.srgb[1] != green || c.srgb[2] != blue || !c.given)
        fail_msg("'%s' is %d %d %d", text, c.srgb[0], c.srgb[1], c.srgb[2]);
}

TEST(test_read) {
    reads("#000000", 0, 0, 0);
    reads("#0180fF", 1, 128, 255);
    reads("#08f", 0, 136, 255);
    reads("red", 255, 0, 0);
    reads("Teal", 0, 128, 128);
    reads("aliceblue", 240, 248, 255);
    reads("yellowgreen", 154, 205, 50);
    reads("rebeccapurple", 102, 51, 153);
    reads("grey", 128, 128, 128);
    reads("gray", 128, 128, 128);
    static const char *const bad[] = {"",         "#",       "#1",   "#12",       "#1234", "#12345",
                                      "#1234567", "#12345g", "#-12", "123456",    "re",    "redd",
                                      "red ",     " red",    "none", "rgb(1,2,3)"};
    css_colour c;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (colour_read(bad[i], &c)) fail_msg("'%s' is accepted", bad[i]);
}

TEST(test_values) {
    const css_colour white = {{255, 255, 255}, 1}, black = {{0, 0, 0}, 1};
    double rgb[3];
    colour_of(&white, rgb);
    for (int i = 0; i < 3; i++) assert_true(rgb[i] == 1);
    colour_of(&black, rgb);
    for (int i = 0; i < 3; i++) assert_true(rgb[i] == 0);
}

/* The nearest of some names.  Catches: a swap that counts twice, capitals that count, a guess that is far. */
static void guesses(const char *wrong, const char *expected) {
    static const char *const names[] = {"--colour", "--centre", "--size", "--sweep", "--help"};
    cli_guess guess = cli_guess_begin(wrong, strlen(wrong));
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) cli_guess_try(&guess, names[i]);
    if (!expected) {
        if (guess.name) fail_msg("'%s': %s", wrong, guess.name);
    } else if (!guess.name || strcmp(guess.name, expected) != 0) {
        fail_msg("'%s': %s", wrong, guess.name ? guess.name : "nothing");
    }
}

TEST(test_guess) {
    guesses("--color", "--colour");
    guesses("--center", "--centre");
    guesses("--SIZE", "--size");
    guesses("-size", "--size");
    guesses("--seep", "--sweep");
    guesses("--coluor", "--colour");
    guesses("--centred", "--centre");
    guesses("", NULL);
    guesses("--", NULL);
    guesses("--picture", NULL);
    guesses("--hp", NULL); /* half of its letters are missing: dashes are none */
    guesses("--hep", "--help");
    guesses("--0123456789012345678901234567890123456789", NULL);
}

/* Words of other programs.  Catches: dashes that count, a part of a word that passes for it, a second use
 * lost. */
TEST(test_meaning) {
    cli_guess cut = cli_guess_begin("--cut=1,2,3,4", 5), width = cli_guess_begin("-width", 6);
    cli_guess wide = cli_guess_begin("--widths", 8), none = cli_guess_begin("--", 2);
    assert_string_equal(cli_guess_meaning(&cut, 0), "--clip A,B,C,D");
    assert_string_equal(cli_guess_meaning(&cut, 1), "--extent box:X,Y,Z");
    assert_null(cli_guess_meaning(&cut, 2));
    assert_string_equal(cli_guess_meaning(&width, 0), "--size WxH");
    assert_null(cli_guess_meaning(&wide, 0));
    assert_null(cli_guess_meaning(&none, 0));
}
