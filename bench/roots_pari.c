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

static GEN integer(const algsurf_integer *z) {
    GEN value = gen_0;
    for (int i = labs(z->length) - 1; i >= 0; i--)
        for (int shift = 32; shift >= 0; shift -= 32)
            value = addiu(shifti(value, 32), (ulong)(z->limbs[i] >> shift & UINT32_MAX));
    return z->length < 0 ? negi(value) : value;
}

/* What is asked, and where the answers go. */
typedef struct question {
    const double *c, *im;
    const algsurf_integer *re_integers, *im_integers;
    int degree;
    double *real;
    other_root *root;
} question;

/* Returns how many roots `find` finds, -1: PARI gives up; and leaves its stack as it was. */
static int ask(int (*find)(const question *q), const question *q) {
    volatile int count = -1;
    start();
    pari_sp before = avma;
    pari_CATCH(CATCH_ALL) { count = -1; }
    pari_TRY { count = find(q); }
    pari_ENDCATCH;
    set_avma(before);
    return count;
}

static int in_interval(const question *q) {
    GEN found = realroots(exact_polynomial(q->c, q->degree), mkvec2(gen_m1, gen_1), DEFAULTPREC);
    for (long i = 1; i < lg(found); i++) q->real[i - 1] = gtodouble(gel(found, i));
    return (int)lg(found) - 1;
}

static int isolated(const question *q) {
    return (int)lg(realroots(exact_polynomial(q->c, q->degree), NULL, DEFAULTPREC)) - 1;
}

static int counted(const question *q) { return (int)RgX_sturmpart(exact_polynomial(q->c, q->degree), NULL); }

static int all(const question *q) {
    GEN p = polynomial(q->degree);
    for (int k = 0; k <= q->degree; k++)
        if (q->c)
            gel(p, k + 2) = approximate(q->c[k], q->im ? q->im[k] : 0);
        else if (q->im_integers && q->im_integers[k].length)
            gel(p, k + 2) = mkcomplex(integer(&q->re_integers[k]), integer(&q->im_integers[k]));
        else
            gel(p, k + 2) = integer(&q->re_integers[k]);
    GEN found = roots(normalizepol(p), DEFAULTPREC);
    for (long i = 1; i < lg(found); i++)
        q->root[i - 1] = (other_root){gtodouble(greal(gel(found, i))), gtodouble(gimag(gel(found, i))), NAN};
    return (int)lg(found) - 1;
}

/* Of an answer that there is not. */
static int or_none(int count) { return count < 0 ? 0 : count; }

int by_pari_interval(const double *c, int degree, double *real) {
    return or_none(ask(in_interval, &(question){.c = c, .degree = degree, .real = real}));
}

double by_pari_first(const double *c, int degree) {
    double real[ALGSURF_MAX_DEGREE];
    return by_pari_interval(c, degree, real) > 0 ? real[0] : NAN;
}

int by_pari_isolated(const double *c, int degree) {
    return ask(isolated, &(question){.c = c, .degree = degree});
}

int by_pari_counted(const double *c, int degree) {
    return ask(counted, &(question){.c = c, .degree = degree});
}

int by_pari_all(const double *re, const double *im, int degree, other_root *root) {
    return or_none(ask(all, &(question){.c = re, .im = im, .degree = degree, .root = root}));
}

int by_pari_integers(const algsurf_integer *re, const algsurf_integer *im, int degree, other_root *root) {
    return or_none(
        ask(all, &(question){.re_integers = re, .im_integers = im, .degree = degree, .root = root}));
}
