/* ticks.h - where numbers stand along an axis: steps of 1, 2 or 5 times a power of ten, and their decimal
 * digits. */
#ifndef TICKS_H
#define TICKS_H

/* digit * 10^exponent. */
typedef struct tick_step {
    int digit; /* 1, 2 or 5 */
    int exponent;
} tick_step;

/* The least step that is not below a number > 0, up to rounding. */
tick_step ticks_step(double least);

double ticks_size(tick_step step);

enum { TICKS_TEXT = 32 };

/* k steps as a decimal number without zeros at its end, as -0.25, 1200 or 3e-7; |k| < 1e15. */
void ticks_text(tick_step step, long long k, char text[TICKS_TEXT]);

#endif
