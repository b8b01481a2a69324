/* peers_pari.c - PARI: Uspensky's method on exact rationals for the real roots in an interval, the splitting
 * of Schoenhage and Gourdon for all complex ones, in its smallest precision (64 bits).
 */
#include <math.h>
#include <pari/pari.h>

#include "peers_solver.h"

enum { STACK = 64 << 20, PRIMES = 2 };

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

double peer_pari_first(const double *c, int degree) {
    volatile double least = NAN;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { least = NAN; }
    pari_TRY {
        GEN p = polynomial(degree);
        for (int k = 0; k <= degree; k++) gel(p, k + 2) = exact(c[k]);
        GEN found = realroots(normalizepol(p), mkvec2(gen_m1, gen_1), DEFAULTPREC);
        if (lg(found) > 1) least = gtodouble(gel(found, 1));
    }
    pari_ENDCATCH;
    set_avma(before);
    return least;
}

int peer_pari_all(const double *re, const double *im, int degree, peer_root *answer) {
    volatile int count = 0;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { count = 0; }
    pari_TRY {
        GEN p = polynomial(degree);
        for (int k = 0; k <= degree; k++) gel(p, k + 2) = approximate(re[k], im ? im[k] : 0);
        GEN found = roots(normalizepol(p), DEFAULTPREC);
        for (long i = 1; i < lg(found); i++)
            answer[i - 1] =
                (peer_root){gtodouble(greal(gel(found, i))), gtodouble(gimag(gel(found, i))), NAN};
        count = (int)lg(found) - 1;
    }
    pari_ENDCATCH;
    set_avma(before);
    return count;
}
