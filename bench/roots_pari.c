/* roots_pari.c - PARI: Uspensky's method on exact rationals for the real roots in an interval, the splitting
 * of Schoenhage and Gourdon for all complex ones, in its smallest precision (64 bits).
 */
#include <math.h>
#include <pari/pari.h>

#include "algsurf/status.h"
#include "roots_others.h"

enum { STACK = 512 << 20, PRIMES = 2 };

static void start(void) {
    static int started;
    if (!started) pari_init(STACK, PRIMES);
    started = 1;
}

static GEN exact(double x) {
    int exponent;
    double mantissa = frexp(x, &exponent);
    return x == 0 ? gen_0 : gmul2n(stoi((long)ldexp(mantissa, 53)), exponent - 53);
}

static GEN approximate(double re, double im) {
    GEN real = re == 0 ? gen_0 : dbltor(re);
    return im == 0 ? real : mkcomplex(real, dbltor(im));
}

static GEN polynomial(int degree) {
    GEN p = cgetg(degree + 3, t_POL);
    p[1] = evalsigne(1) | evalvarn(0);
    return p;
}

static GEN exact_polynomial(const double *c, int degree) {
    GEN p = polynomial(degree);
    for (int k = 0; k <= degree; k++) gel(p, k + 2) = exact(c[k]);
    return normalizepol(p);
}

int by_pari_interval(const double *c, int degree, double *real) {
    volatile int count = 0;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { count = 0; }
    pari_TRY {
        GEN found = realroots(exact_polynomial(c, degree), mkvec2(gen_m1, gen_1), DEFAULTPREC);
        for (long i = 1; i < lg(found); i++) real[i - 1] = gtodouble(gel(found, i));
        count = (int)lg(found) - 1;
    }
    pari_ENDCATCH;
    set_avma(before);
    return count;
}

double by_pari_first(const double *c, int degree) {
    double real[ALGSURF_MAX_DEGREE];
    return by_pari_interval(c, degree, real) > 0 ? real[0] : NAN;
}

int by_pari_isolated(const double *c, int degree) {
    volatile int count = -1;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { count = -1; }
    pari_TRY { count = (int)lg(realroots(exact_polynomial(c, degree), NULL, DEFAULTPREC)) - 1; }
    pari_ENDCATCH;
    set_avma(before);
    return count;
}

int by_pari_counted(const double *c, int degree) {
    volatile int count = -1;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { count = -1; }
    pari_TRY { count = (int)RgX_sturmpart(exact_polynomial(c, degree), NULL); }
    pari_ENDCATCH;
    set_avma(before);
    return count;
}

static int all_roots(GEN p, other_root *answer) {
    GEN found = roots(normalizepol(p), DEFAULTPREC);
    for (long i = 1; i < lg(found); i++)
        answer[i - 1] = (other_root){gtodouble(greal(gel(found, i))), gtodouble(gimag(gel(found, i))), NAN};
    return (int)lg(found) - 1;
}

int by_pari_all(const double *re, const double *im, int degree, other_root *answer) {
    volatile int count = 0;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { count = 0; }
    pari_TRY {
        GEN p = polynomial(degree);
        for (int k = 0; k <= degree; k++) gel(p, k + 2) = approximate(re[k], im ? im[k] : 0);
        count = all_roots(p, answer);
    }
    pari_ENDCATCH;
    set_avma(before);
    return count;
}

static GEN integer(const algsurf_integer *z) {
    GEN value = gen_0;
    for (int i = labs(z->length) - 1; i >= 0; i--)
        for (int shift = 32; shift >= 0; shift -= 32)
            value = addiu(shifti(value, 32), (ulong)(z->limbs[i] >> shift & UINT32_MAX));
    return z->length < 0 ? negi(value) : value;
}

int by_pari_integers(const algsurf_integer *re, const algsurf_integer *im, int degree, other_root *answer) {
    volatile int count = 0;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { count = 0; }
    pari_TRY {
        GEN p = polynomial(degree);
        for (int k = 0; k <= degree; k++)
            gel(p, k + 2) =
                im && im[k].length ? mkcomplex(integer(&re[k]), integer(&im[k])) : integer(&re[k]);
        count = all_roots(p, answer);
    }
    pari_ENDCATCH;
    set_avma(before);
    return count;
}
