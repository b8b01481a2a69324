/* roots_families.c - all complex roots of polynomials whose roots are hard to tell apart in doubles, by this
 * library and by others: families by their recurrences, sparse and random ones, with integers of any length.
 *
 * The number of different roots, and of real ones, is known for most of them, and this library must find as
 * many.  Its boxes judge the others; Arb's balls are proved as well, and must not contradict them.  Every
 * program works in a process of its own, which is ended when it takes too long. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli.h"
#include "roots.h"

enum { MOST = ALGSURF_MAX_POLY_DEGREE, DIGITS = 80 };

/* In two's complement, lowest digit first: to 2560 bits. */
typedef struct number {
    uint32_t digit[DIGITS];
} number;

typedef struct polynomial {
    int degree; /* of what is there, where factors are multiplied */
    number re[MOST + 1], im[MOST + 1];
} polynomial;

/* ---- integers ---- */

static const number one = {{1}};

static number number_of(int64_t value) {
    number a;
    memset(&a, value < 0 ? 0xff : 0, sizeof a);
    a.digit[0] = (uint32_t)value;
    a.digit[1] = (uint32_t)((uint64_t)value >> 32);
    return a;
}

/* a += b c, modulo 2^2560. */
static void add_product(number *a, const number *b, const number *c) {
    for (int i = 0; i < DIGITS; i++) {
        uint64_t carry = 0;
        for (int k = 0; c->digit[i] && k < DIGITS - i; k++) {
            carry += (uint64_t)b->digit[k] * c->digit[i] + a->digit[i + k];
            a->digit[i + k] = (uint32_t)carry;
            carry >>= 32;
        }
    }
}

static void add_times(number *a, const number *b, int64_t factor) {
    const number c = number_of(factor);
    add_product(a, b, &c);
}

static void times(number *a, int64_t factor) {
    number product = {{0}};
    add_times(&product, a, factor);
    *a = product;
}

/* ---- the families: p comes as the polynomial 0 ---- */

static measure_random dice;

static void set(polynomial *p, int k, int64_t value) { p->re[k] = number_of(value); }

static int pick(int below) { return (int)(measure_bits(&dice) % (uint64_t)below); }

/* p *= c2 t^2 + c1 t + c0. */
static void times_factor(polynomial *p, int64_t c2, int64_t c1, int64_t c0) {
    p->degree += c2 ? 2 : 1;
    for (int k = p->degree; k >= 0; k--) {
        times(&p->re[k], c0);
        if (k > 0) add_times(&p->re[k], &p->re[k - 1], c1);
        if (k > 1) add_times(&p->re[k], &p->re[k - 2], c2);
    }
}

/* p_(m+1) = (a t + b) p_m - c p_(m-1), from 1. */
static void recur(polynomial *p, int n, void coefficients(int m, int64_t *a, int64_t *b, int64_t *c)) {
    static number before[MOST + 1];
    memset(before, 0, sizeof before);
    p->re[0] = one;
    for (int m = 0; m < n; m++) {
        int64_t a, b, c;
        coefficients(m, &a, &b, &c);
        for (int k = m + 1; k >= 0; k--) {
            number next = {{0}};
            add_times(&next, &p->re[k], b);
            if (k > 0) add_times(&next, &p->re[k - 1], a);
            add_times(&next, &before[k], -c);
            before[k] = p->re[k];
            p->re[k] = next;
        }
    }
}

static void by_chebyshev(int m, int64_t *a, int64_t *b, int64_t *c) { *a = m ? 2 : 1, *b = 0, *c = 1; }
static void by_legendre(int m, int64_t *a, int64_t *b, int64_t *c) { *a = 2 * m + 1, *b = 0, *c = m * m; }
static void by_hermite(int m, int64_t *a, int64_t *b, int64_t *c) { *a = 2, *b = 0, *c = 2 * m; }
static void by_laguerre(int m, int64_t *a, int64_t *b, int64_t *c) { *a = -1, *b = 2 * m + 1, *c = m * m; }

static void chebyshev(polynomial *p, int n) { recur(p, n, by_chebyshev); }
static void legendre(polynomial *p, int n) { recur(p, n, by_legendre); } /* n! P_n */
static void hermite(polynomial *p, int n) { recur(p, n, by_hermite); }
static void laguerre(polynomial *p, int n) { recur(p, n, by_laguerre); } /* n! L_n */

static void wilkinson(polynomial *p, int n) {
    p->re[0] = one;
    for (int k = 1; k <= n; k++) times_factor(p, 0, 1, -k);
}

/* n! (1 + t + t^2/2 .. t^n/n!) */
static void exponential(polynomial *p, int n) {
    p->re[n] = one;
    for (int k = n; k > 0; k--) add_times(&p->re[k - 1], &p->re[k], k);
}

/* z -> z^2 + t, from 0 to 0: a polynomial of degree 2^k - 1. */
static void mandelbrot(polynomial *p, int n) {
    p->re[0] = one;
    while (p->degree < n) {
        static polynomial square;
        memset(&square, 0, sizeof square);
        for (int i = 0; i <= p->degree; i++)
            for (int k = 0; k <= p->degree; k++) add_product(&square.re[i + k + 1], &p->re[i], &p->re[k]);
        square.degree = 2 * p->degree + 1;
        square.re[0] = one;
        *p = square;
    }
}

/* t^n - (a t - 1)^2: two real roots at 1/a, some a^(-n/2) apart. */
static void mignotte(polynomial *p, int n) {
    const int64_t a = (1 << 26) + 1;
    set(p, 0, -1), set(p, 1, 2 * a), set(p, 2, -a * a), set(p, n, 1);
}

/* 1 + t^(n-2) (t + 20000)^2 */
static void far_pair(polynomial *p, int n) {
    set(p, 0, 1), set(p, n, 1), set(p, n - 1, 40000), set(p, n - 2, 400000000);
}

static void unity(polynomial *p, int n) { set(p, 0, -1), set(p, n, 1); }

static void turned_unity(polynomial *p, int n) { p->im[0] = number_of(-1), p->re[n] = one; }

static void sparse(polynomial *p, int n) {
    for (int k = 0; k < 10; k++) set(p, k ? pick(n) : 0, 1 + pick(1000));
    set(p, n, -1 - pick(1000));
}

/* Integers times 10^-300 to 10^300, all times 10^300. */
static void exponents(polynomial *p, int n) {
    for (int k = 0; k <= n; k++) {
        set(p, k, 1 + pick(1000000000));
        for (int e = pick(601); e > 0; e--) times(&p->re[k], 10);
        if (pick(2)) times(&p->re[k], -1);
    }
}

static void gaussian(polynomial *p, int n) {
    for (int k = 0; k <= n; k++) set(p, k, 1 + pick(1000)), p->im[k] = number_of(pick(2001) - 1000);
}

/* 2^k, k from -n/2. */
static void geometric(polynomial *p, int n) {
    p->re[0] = one;
    for (int k = -n / 2; p->degree < n; k++)
        times_factor(p, 0, k < 0 ? (int64_t)1 << -k : 1, k < 0 ? -1 : -((int64_t)1 << k));
}

/* A real root and a pair of complex ones, m times for m = 1, 2 .., of degree 3 (1 + 2 .. ). */
static void multiple(polynomial *p, int n) {
    p->re[0] = one;
    for (int m = 1; p->degree < n; m++)
        for (int i = 0; i < m; i++) times_factor(p, 0, 3, 10 + m), times_factor(p, 1, -2 * m, m * m + 9);
}

static const struct {
    const char *section, *name;
    void (*make)(polynomial *p, int n);
    int n, different, real; /* roots; -1: not known */
} families[] = {
    {"real families", "Chebyshev-80", chebyshev, 80, 80, 80},
    {"real families", "Chebyshev-160", chebyshev, 160, 160, 160},
    {"real families", "Chebyshev-320", chebyshev, 320, 320, 320},
    {"real families", "Legendre-80", legendre, 80, 80, 80},
    {"real families", "Legendre-160", legendre, 160, 160, 160},
    {"real families", "Hermite-160", hermite, 160, 160, 160},
    {"real families", "Laguerre-160", laguerre, 160, 160, 160},
    {"real families", "Wilkinson-40", wilkinson, 40, 40, 40},
    {"real families", "Wilkinson-80", wilkinson, 80, 80, 80},
    {"real families", "Wilkinson-160", wilkinson, 160, 160, 160},
    {"real families", "2^k-60", geometric, 60, 60, 60},
    {"families", "exp-100", exponential, 100, 100, 0},
    {"families", "exp-200", exponential, 200, 200, 0},
    {"families", "Mandelbrot-127", mandelbrot, 127, 127, -1},
    {"families", "Mandelbrot-255", mandelbrot, 255, 255, -1},
    {"families", "Mignotte-64", mignotte, 64, -1, -1},
    {"families", "Mignotte-128", mignotte, 128, -1, -1},
    {"families", "Mignotte-256", mignotte, 256, -1, -1},
    {"families", "far pair-300", far_pair, 300, -1, -1},
    {"families", "x^400-1", unity, 400, 400, 2},
    {"families", "x^300-i", turned_unity, 300, 300, 0},
    {"families", "sparse-512", sparse, 512, 512, -1},
    {"families", "exponents-100", exponents, 100, 100, -1},
    {"families", "Gaussian-100", gaussian, 100, 100, -1},
    {"families", "multiple-108", multiple, 108, 24, 8},
};

enum { FAMILIES = sizeof families / sizeof *families };

/* ---- the contest ---- */

/* A family as magnitudes and signs, and this library's answer. */
static int degree;
static uint64_t limb[2][MOST + 1][DIGITS / 2];
static algsurf_integer integer[2][MOST + 1], *imaginary; /* null: there are none */
static algsurf_complex_root own[MOST];
static int boxes;

static algsurf_integer integer_of(number a, uint64_t *limbs) {
    int negative = a.digit[DIGITS - 1] >> 31 != 0, length = DIGITS / 2;
    if (negative) times(&a, -1);
    for (int i = 0; i < length; i++) limbs[i] = a.digit[2 * i] | (uint64_t)a.digit[2 * i + 1] << 32;
    while (length > 0 && !limbs[length - 1]) length--;
    return (algsurf_integer){limbs, negative ? -length : length};
}

static int solve_here(const algsurf_integer *re, const algsurf_integer *im, int n, other_root *root) {
    (void)root;
    return algsurf_complex_roots_integers(re, im, n, own, &boxes) == ALGSURF_OK ? boxes : 0;
}

typedef struct solver {
    const char *program;
    other_integers *solve;
    int proves;
} solver;

static const solver solvers[] = {
    {"algsurf", solve_here, 0},
#ifdef WITH_ARB
    {"Arb", by_arb_integers, 1},
#endif
#ifdef WITH_MPSOLVE
    {"MPSolve -as isolate", by_mpsolve_secular_isolate, 0},
    {"MPSolve -as approx.", by_mpsolve_secular_approximate, 0},
    {"MPSolve -au isolate", by_mpsolve_classic_isolate, 0},
    {"MPSolve -au approx.", by_mpsolve_classic_approximate, 0},
#endif
#ifdef WITH_PARI
    {"PARI", by_pari_integers, 0},
#endif
};

enum { SOLVERS = sizeof solvers / sizeof *solvers };

/* What a process hands back. */
typedef struct answer {
    double seconds;
    int roots;
    other_root root[MOST];
} answer;

/* Solves until the clock can tell how long that takes; 0 where it takes more than the patience, or breaks. */
static int solve_apart(const solver *s, unsigned patience, answer *shared) {
    int status;
    pid_t child = fork();
    if (child == 0) {
        const algsurf_integer minus_one = {&(uint64_t){1}, -1}, plus_one = {&(uint64_t){1}, 1};
        const algsurf_integer linear[2] = {minus_one, plus_one};
        (void)s->solve(linear, NULL, 1, shared->root); /* what a package does once */
        double begun = measure_cpu();
        int rounds = 0;
        (void)setrlimit(RLIMIT_CPU, &(struct rlimit){patience, patience});
        do {
            shared->roots = s->solve(integer[0], imaginary, degree, shared->root);
            shared->seconds = (measure_cpu() - begun) / ++rounds;
        } while (measure_cpu() - begun < 2e-2);
        _exit(0);
    }
    return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

static void prepare(size_t i) {
    static polynomial p;
    int different = families[i].different, expected = families[i].real, real = 0;
    memset(&p, 0, sizeof p);
    dice = (measure_random){i};
    degree = families[i].n;
    families[i].make(&p, degree);
    imaginary = NULL;
    for (int k = 0; k <= degree; k++) {
        integer[0][k] = integer_of(p.re[k], limb[0][k]);
        integer[1][k] = integer_of(p.im[k], limb[1][k]);
        if (integer[1][k].length != 0) imaginary = integer[1];
    }
    if (!solve_here(integer[0], imaginary, degree, NULL)) cli_fail(CLI_BROKEN, "%s", families[i].name);
    for (int b = 0; b < boxes; b++) real += own[b].real;
    if ((different >= 0 && boxes != different) || (expected >= 0 && real != expected))
        cli_fail(CLI_BROKEN, "%s: %d roots, %d of them real", families[i].name, boxes, real);
}

/* The first answer of each is judged. */
static void judge(const solver *s, const answer *a, contest_row *row) {
    row->count = (size_t)a->roots;
    if (s->solve == solve_here) return;
    roots_judge(own, boxes, a->root, a->roots, 0, row);
    roots_check(s->program, s->proves, row);
}

/* In turn, but what is slow only once. */
static void contend(size_t family, const roots_effort *effort, contest_table *table) {
    answer *shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    contest_row row[SOLVERS];
    if (shared == MAP_FAILED) cli_no_memory();
    prepare(family);
    for (int k = 0; k < SOLVERS; k++)
        row[k] = (contest_row){.section = families[family].section,
                               .task = families[family].name,
                               .degree = degree,
                               .program = solvers[k].program,
                               .unit = "ms"};
    for (int take = 0; take < effort->takes; take++)
        for (int k = 0; k < SOLVERS; k++) {
            if (take > 0 && row[k].takes.seconds[0] > effort->budget) continue;
            int done = solve_apart(&solvers[k], (unsigned)effort->patience, shared);
            if (done && take == 0) judge(&solvers[k], shared, &row[k]);
            measure_take(&row[k].takes, done ? shared->seconds : effort->patience);
        }
    for (int k = 0; k < SOLVERS; k++) contest_add(table, &row[k]);
    munmap(shared, sizeof *shared);
}

void roots_families(const roots_effort *effort, contest_table *table) {
    for (size_t i = 0; i < FAMILIES; i++)
        if (families[i].n <= effort->most_of_family) contend(i, effort, table);
}
