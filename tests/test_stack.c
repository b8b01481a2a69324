/* test_stack.c - how much stack each public function needs: at most what its comment says.
 *
 * A call runs on a thread whose stack is painted before; how deep the paint is gone afterwards, less what a
 * thread that does nothing leaves, is what the call took.  Inputs are those that go deepest: the largest
 * degrees, integers, radii, clusters, nested text; and each kernel that runs here, where the caller may
 * choose.  What is measured is compared with what each STACK_OF says, and check_symbols compares that with
 * the headers: a number of KiB in the function's comment, or USUAL where the comment has none.  Calls that a
 * renderer makes are to work on a thread of 64 KiB, all others on one of 128 KiB.
 *
 * Every call is made once before, so that the dynamic linker's own stack does not count.  Numbers are
 * compared where they were measured: x86-64, gcc, optimised.  Sanitizers, debugging builds and emulators take
 * more, and other compilers have other frames: there the calls are made, and what they took is printed. */
#define _DEFAULT_SOURCE
#include <pthread.h>
#include <sys/mman.h>

#include "algsurf/algsurf.h"
#include "unit.h"

enum { USUAL = 8, RENDERER = 64, OTHERS = 128, MOST = ALGSURF_MAX_POLY_DEGREE, MOST_CALLS = 256 };

/* ---- painted stacks ---- */

#define STACK ((size_t)1 << 20)
#define PAINT 0xa5

typedef struct job {
    void (*run)(void);
} job;

static void *work(void *data) {
    const job *j = data;
    if (j->run) j->run();
    return NULL;
}

/* The bytes of stack that a thread with this job has written to. */
static size_t depth_of(void (*run)(void)) {
    job j = {run};
    pthread_attr_t attributes;
    pthread_t thread;
    unsigned char *stack = mmap(NULL, STACK, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(stack != MAP_FAILED);
    memset(stack, PAINT, STACK);
    assert_int_equal(pthread_attr_init(&attributes), 0);
    assert_int_equal(pthread_attr_setstack(&attributes, stack, STACK), 0);
    assert_int_equal(pthread_create(&thread, &attributes, work, &j), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    (void)pthread_attr_destroy(&attributes);
    size_t clean = 0;
    while (clean < STACK && stack[clean] == PAINT) clean++;
    assert_int_equal(munmap(stack, STACK), 0);
    assert_true(clean > 0);
    return STACK - clean;
}

/* ---- inputs ---- */

/* Polynomials with p->name, the coefficients c and radii r. */
typedef struct poly {
    int degree;
    double c[MOST + 1], r[MOST + 1];
} poly;

enum { LITTLEWOOD, LITTLEWOOD_64, SQUARE, SQUARE_64, BINOMIAL, CLUSTER, CHEBYSHEV, SMALL, POLYS };
static poly polys[POLYS];

static void make_polys(void) {
    uint64_t seed = 1;
    for (int which = LITTLEWOOD; which <= SQUARE_64; which++) {
        poly *p = polys + which;
        int n = which == LITTLEWOOD || which == SQUARE ? MOST : 64;
        double q[MOST + 1];
        for (int k = 0; k <= n; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            q[k] = seed >> 63 ? 1 : -1;
        }
        p->degree = n;
        for (int k = 0; k <= n; k++) p->c[k] = which >= SQUARE ? 0 : q[k];
        for (int i = 0; which >= SQUARE && i <= n / 2; i++)
            for (int k = 0; k <= n / 2; k++) p->c[i + k] += q[i] * q[k];
    }
    polys[BINOMIAL].degree = MOST, polys[BINOMIAL].c[0] = 4, polys[BINOMIAL].c[MOST / 2] = -4;
    polys[BINOMIAL].c[MOST] = 1;
    polys[CLUSTER].degree = 60; /* Mignotte: two roots close to 1/1000 */
    polys[CLUSTER].c[60] = 1, polys[CLUSTER].c[2] = -2e6, polys[CLUSTER].c[1] = 4e3, polys[CLUSTER].c[0] = -2;
    double t[2][33] = {{1}, {0, 1}}; /* T_30: 30 real roots */
    for (int n = 2; n <= 30; n++) {
        for (int k = 30; k >= 0; k--) {
            double next = (k > 0 ? 2 * t[1][k - 1] : 0) - t[0][k];
            t[0][k] = next;
        }
        for (int k = 0; k <= 30; k++) {
            double x = t[0][k];
            t[0][k] = t[1][k], t[1][k] = x;
        }
    }
    polys[CHEBYSHEV].degree = 30;
    memcpy(polys[CHEBYSHEV].c, t[1], 31 * sizeof(double));
    polys[SMALL].degree = 6;
    for (int k = 0; k <= 6; k++) polys[SMALL].c[k] = (k * 5 % 7) - 2.9;
    for (int which = 0; which < POLYS; which++)
        for (int k = 0; k <= polys[which].degree; k++) polys[which].r[k] = 0x1p-40 * fabs(polys[which].c[k]);
}

/* Surfaces: of high degree, in rows, dense with nodes, touched by every ray, known to an error. */
enum { SURFACES = 7 };
static algsurf_surface *surfaces[SURFACES];

static void make_surfaces(void) {
    static const char *const equations[SURFACES - 1] = {
        "x^64 + y^64 + z^64 + x^3 y z - x + 0.1 y - 1",
        "x^24 + y^24 + z^24 + x y z - 0.7",
        "(x + 2y - z)^12 + (x^2 - y z + 0.3)^6 + (z - 0.1)^9 - 0.5",
        "(x^2 + y^2 + z^2 - 1)^2",
        "(x^8 + y^8 + z^8 - 1)^2 (x^2 + y^2 + z^2 - 0.5)^3",
        "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8",
    };
    for (int i = 0; i < SURFACES - 1; i++)
        assert_ok(algsurf_surface_from_equation(equations[i], NULL, 0, surfaces + i, NULL));
    assert_ok(algsurf_surface_with_error(surfaces[3], 1e-9, surfaces + SURFACES - 1));
}

static void free_surfaces(void) {
    for (int i = 0; i < SURFACES; i++) algsurf_surface_free(surfaces[i]);
}

static const algsurf_extent extents[3] = {{ALGSURF_EXTENT_ALL, {0, 0, 0}, {0, 0, 0}},
                                          {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3, 0, 0}},
                                          {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2, 2, 2}}};

/* Generic ones, one that touches spheres, one from far away, one in a plane of symmetry. */
enum { RAYS = 6 };
static const algsurf_ray rays[RAYS] = {
    {{-4, 0.3, 0.2}, {1, 0.02, -0.03}, 0, HUGE_VAL},
    {{-4, 1, 0}, {1, 0, 0}, 0, HUGE_VAL},
    {{-4e5, 0.25, 0.125}, {1e-3, 0, 0}, 0, HUGE_VAL},
    {{0, 0, -4}, {0, 0, 1}, -HUGE_VAL, HUGE_VAL},
    {{-4, 0.1, 0.7}, {1, 0, 0}, 0, 4},
    {{3, 3, 3}, {-1, -1, -1}, 0, HUGE_VAL},
};

/* Each combination of surface, extent and options, for a call with a ray. */
static void for_rays(void (*call)(const algsurf_surface *, const algsurf_extent *, const algsurf_ray *,
                                  const algsurf_intersect_options *)) {
    for (int s = 0; s < SURFACES; s++)
        for (int e = 0; e < 3; e++)
            for (int way = 0; way < 4; way++)
                for (int i = 0; i < RAYS; i++) {
                    algsurf_intersect_options o = {.size = sizeof o};
                    if (way == 1) o.tier = ALGSURF_TIER_BOUNDED;
                    if (way == 2) o.method = ALGSURF_METHOD_BRENT;
                    if (way == 3) o.undecided_as = ALGSURF_AS_MISS;
                    call(surfaces[s], extents + e, rays + i, &o);
                }
}

/* ---- the calls: what the headers say of their stacks, in KiB, and for whom ---- */

static struct {
    const char *name;
    void (*run)(void);
    int stated, limit;
} calls[MOST_CALLS];
static int call_count;

/* What to run; it enters the list before main begins. */
#define STACK_OF(function, kib, whom)                                                                        \
    static void run_##function(void);                                                                        \
    __attribute__((constructor)) static void list_##function(void) {                                         \
        calls[call_count].name = #function, calls[call_count].run = run_##function;                          \
        calls[call_count].stated = (kib), calls[call_count++].limit = (whom);                                \
    }                                                                                                        \
    static void run_##function(void)

static void one_first(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                      const algsurf_intersect_options *o) {
    algsurf_hit hit;
    (void)algsurf_intersect_first(s, e, r, o, &hit);
}
STACK_OF(algsurf_intersect_first, 42, RENDERER) { for_rays(one_first); }

static void one_all(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                    const algsurf_intersect_options *o) {
    static algsurf_hit hits[ALGSURF_MAX_DEGREE];
    int count;
    (void)algsurf_intersect_all(s, e, r, o, hits, ALGSURF_MAX_DEGREE, &count);
}
STACK_OF(algsurf_intersect_all, 42, RENDERER) { for_rays(one_all); }

static void one_occluded(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                         const algsurf_intersect_options *o) {
    int state;
    (void)algsurf_occluded(s, e, r, o, &state);
}
STACK_OF(algsurf_occluded, 42, RENDERER) { for_rays(one_occluded); }

static void one_leave(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                      const algsurf_intersect_options *o) {
    const algsurf_hit hit = {.state = ALGSURF_STATE_HIT, .normal = {1, 0, 0}};
    double start[3];
    (void)algsurf_hit_leave(s, r, &hit, e && o->tier ? 1 : -1, start);
}
STACK_OF(algsurf_hit_leave, USUAL, RENDERER) { for_rays(one_leave); }

static void one_complex(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                        const algsurf_intersect_options *o) {
    const double imaginary = o->method ? 0.5 : 0;
    const algsurf_complex_space space = {sizeof space, {0, o->tier ? 0.3 : 1e-10}, &imaginary, 1};
    algsurf_hit hit;
    (void)algsurf_intersect_complex(s, e, r, &space, NULL, NULL, &hit, NULL);
}
STACK_OF(algsurf_intersect_complex, 34, RENDERER) { for_rays(one_complex); }

/* Packets of nine times the same kind of ray, by each kernel. */
static void packets(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                    const algsurf_intersect_options *how, int occluded) {
    static double origin[3][9], direction[3][9], t_min[9], t_max[9], t[3][9], x[6][9];
    static unsigned char state[9];
    algsurf_ray_packet packet = {.size = sizeof packet, .count = 9, .t_min = t_min, .t_max = t_max};
    algsurf_hit_packet hits = {.size = sizeof hits, .state = state, .t = t[0], .t_lo = t[1], .t_hi = t[2]};
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 9; i++) origin[k][i] = r->origin[k] + 0x1p-6 * i * (k == 1);
        for (int i = 0; i < 9; i++) direction[k][i] = r->direction[k];
        packet.origin[k] = origin[k], packet.direction[k] = direction[k];
        hits.position[k] = x[k], hits.normal[k] = x[3 + k];
    }
    for (int i = 0; i < 9; i++) t_min[i] = r->t_min, t_max[i] = r->t_max;
    for (int k = 0; algsurf_kernel_name(k / 2); k++) {
        algsurf_intersect_options o = *how;
        o.kernel = algsurf_kernel_name(k / 2);
        t_max[8] = k % 2 ? NAN : r->t_max; /* a bad ray: by pieces */
        if (occluded)
            (void)algsurf_occluded_packet(s, e, &packet, &o, state);
        else
            (void)algsurf_intersect_packet(s, e, &packet, &o, &hits);
    }
}

static void one_packet(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                       const algsurf_intersect_options *o) {
    packets(s, e, r, o, 0);
}
STACK_OF(algsurf_intersect_packet, 50, RENDERER) { for_rays(one_packet); }

static void one_occluded_packet(const algsurf_surface *s, const algsurf_extent *e, const algsurf_ray *r,
                                const algsurf_intersect_options *o) {
    packets(s, e, r, o, 1);
}
STACK_OF(algsurf_occluded_packet, 50, RENDERER) { for_rays(one_occluded_packet); }

/* A call with each polynomial, interval, and with radii or without. */
static void for_polys(void (*call)(const double *c, const double *r, int n, double lo, double hi)) {
    for (int which = 0; which < POLYS; which++)
        for (int radii = 0; radii < 2; radii++) {
            const poly *p = polys + which;
            if (radii && p->degree > 64 && which != LITTLEWOOD) continue;
            call(p->c, radii ? p->r : NULL, p->degree, -HUGE_VAL, HUGE_VAL);
            call(p->c, radii ? p->r : NULL, p->degree, -1.25, 0.75);
        }
}

static algsurf_bracket brackets[MOST];
static algsurf_real_root real_roots[9 * MOST];
static algsurf_complex_root complex_roots[9 * MOST];
static int found;

/* Watching takes stack, too. */
static void ignore_cell(const algsurf_cell *cell, void *data) { (void)data, (void)cell; }
static void ignore_point(double t, double value, int engine, void *data) {
    (void)data, (void)t, (void)value, (void)engine;
}
static algsurf_observer watcher = {.size = sizeof watcher, .on_cell = ignore_cell, .on_point = ignore_point};
static const algsurf_isolate_options watched = {.size = sizeof watched, .observer = &watcher};

static void first_bracket(const double *c, const double *r, int n, double lo, double hi) {
    (void)algsurf_isolate_first(c, r, n, lo, hi, NULL, brackets, &found);
    (void)algsurf_isolate_first(c, r, n, lo, hi, &watched, brackets, &found);
}
static void all_brackets(const double *c, const double *r, int n, double lo, double hi) {
    (void)algsurf_isolate_all(c, r, n, lo, hi, NULL, brackets, MOST, &found);
    (void)algsurf_isolate_all(c, r, n, lo, hi, &watched, brackets, MOST, &found);
}
static void number_of_roots(const double *c, const double *r, int n, double lo, double hi) {
    (void)algsurf_count_roots(c, r, n, lo, hi, &found);
}
static void roots_of(const double *c, const double *r, int n, double lo, double hi) {
    if (!r) (void)algsurf_real_roots(c, n, lo, hi, real_roots, MOST, &found);
}
static void first_root(const double *c, const double *r, int n, double lo, double hi) {
    double root;
    if (!r) (void)algsurf_real_root_first(c, n, lo, hi, &root, &found);
}
STACK_OF(algsurf_real_root_first, 54, RENDERER) { for_polys(first_root); }
STACK_OF(algsurf_isolate_first, 40, RENDERER) { for_polys(first_bracket); }
STACK_OF(algsurf_isolate_all, 40, OTHERS) { for_polys(all_brackets); }
STACK_OF(algsurf_count_roots, 44, OTHERS) { for_polys(number_of_roots); }
STACK_OF(algsurf_real_roots, 56, OTHERS) { for_polys(roots_of); }

STACK_OF(algsurf_real_roots_integers, 62, OTHERS) {
    static const uint64_t limbs[3][2] = {{7, 5}, {3, 1u << 9}, {1, 1}};
    algsurf_integer c[MOST + 1];
    for (int n = 2; n <= MOST; n *= 4) {
        for (int k = 0; k <= n; k++) c[k] = (algsurf_integer){limbs[k % 3], k * k % 5 - 2 > 0 ? 2 : -2};
        (void)algsurf_real_roots_integers(c, n, -HUGE_VAL, HUGE_VAL, real_roots, MOST, &found);
    }
}

/* Brackets of roots, by all methods. */
enum { SOME = 2 };
static algsurf_bracket known[POLYS][SOME];
static int known_count[POLYS];

static void find_brackets(void) {
    for (int which = 0; which < POLYS; which++) {
        const poly *p = polys + which;
        (void)algsurf_isolate_all(p->c, NULL, p->degree, -2, 2, NULL, brackets, MOST, &known_count[which]);
        if (known_count[which] > SOME) known_count[which] = SOME;
        memcpy(known[which], brackets, sizeof known[which]);
    }
}

STACK_OF(algsurf_refine_poly, 42, RENDERER) {
    for (int which = 0; which < POLYS; which++)
        for (int i = 0; i < 8 * known_count[which]; i++) {
            const poly *p = polys + which;
            const algsurf_bracket *b = known[which] + i / 8;
            algsurf_refine_options o = {.size = sizeof o, .method = i % 4, .max_iterations = 40};
            algsurf_refined_root root;
            o.observer = i / 4 % 2 ? &watcher : NULL;
            (void)algsurf_refine_poly(p->c, NULL, p->degree, b->lo, b->hi, &o, &root);
            if (p->degree > 64 || o.method != ALGSURF_METHOD_DEFAULT) continue;
            (void)algsurf_refine_poly(p->c, p->r, p->degree, b->lo, b->hi, &o, &root);
        }
}

static double cubic(double x, void *data) {
    (void)data;
    return x * x * x - 2;
}
STACK_OF(algsurf_refine_function, USUAL, RENDERER) {
    for (int method = 0; method < 4; method++) {
        algsurf_refine_options o = {.size = sizeof o, .max_iterations = 60};
        algsurf_refined_root root;
        o.method = (int)method;
        (void)algsurf_refine_function(cubic, NULL, 0, 2, &o, &root);
    }
}

/* Nine copies of a polynomial, a little apart, by each kernel. */
static void batches(int roots) {
    static double c[MOST + 1][9], r[MOST + 1][9], lo[9], hi[9], root[9];
    static unsigned char state[9];
    static int count[9];
    for (int which = 0; which < 3 * POLYS; which++) {
        const poly *p = polys + which % POLYS;
        for (int k = 0; k <= p->degree; k++) {
            for (int i = 0; i < 9; i++) c[k][i] = p->c[k], r[k][i] = p->r[k];
        }
        for (int i = 0; i < 9; i++) c[0][i] += 0x1p-8 * i, lo[i] = -1.25, hi[i] = 0.75;
        if (which / POLYS == 1 && p->degree > 64) continue;
        size_t many = p->degree > 64 ? 1 : 9; /* of high degree, each is solved alone */
        algsurf_real_batch batch = {.size = sizeof batch,
                                    .count = many,
                                    .degree = p->degree,
                                    .coefficients = {c[0], 9, 1},
                                    .lo = lo,
                                    .hi = hi,
                                    .interval_step = 1};
        if (which / POLYS == 1) batch.radii = (algsurf_table){r[0], 9, 1};
        if (which / POLYS == 2 && p->degree >= 6) batch.degree = 6;
        int kernels = batch.degree > 20 ? 1 : 3;
        for (int k = 0; k < kernels && algsurf_kernel_name(k); k++) {
            algsurf_batch_options o = {.size = sizeof o, .kernel = algsurf_kernel_name(k)};
            if (roots)
                (void)algsurf_real_roots_batch(&batch, &o, real_roots, count);
            else
                (void)algsurf_first_roots_batch(&batch, &o, state, root);
        }
    }
}
STACK_OF(algsurf_first_roots_batch, 54, OTHERS) { batches(0); }
STACK_OF(algsurf_real_roots_batch, 54, OTHERS) { batches(1); }

STACK_OF(algsurf_poly_value, USUAL, OTHERS) {
    double value, bound;
    (void)algsurf_poly_value(polys[0].c, polys[0].r, MOST, 0.7, &value, &bound);
}
STACK_OF(algsurf_poly_value_compensated, USUAL, OTHERS) {
    double value, bound;
    (void)algsurf_poly_value_compensated(polys[0].c, polys[0].r, MOST, 0.7, &value, &bound);
    (void)algsurf_poly_value_compensated(polys[0].c, NULL, MOST, 0x1p900, &value, &bound);
}
STACK_OF(algsurf_poly_to_bernstein, 10, OTHERS) {
    static double b[2][MOST + 1];
    (void)algsurf_poly_to_bernstein(polys[0].c, polys[0].r, MOST, -0.5, 0.7, b[0], b[1]);
}

/* ---- complex roots ---- */

static algsurf_complex complexes[MOST + 1];

/* Some of them complex, some real. */
static const algsurf_complex *complex_of(const poly *p, int imaginary) {
    for (int k = 0; k <= p->degree; k++)
        complexes[k] = (algsurf_complex){p->c[k], imaginary ? 0.125 * (k % 3) : 0};
    return complexes;
}

static void complex_calls(int real) {
    for (int which = 0; which < POLYS; which++)
        for (int way = 0; way < 4; way++) {
            const poly *p = polys + which;
            const double *r = way / 2 ? p->r : NULL;
            if (real)
                (void)algsurf_complex_roots_of_real(p->c, r, p->degree, complex_roots, &found);
            else
                (void)algsurf_complex_roots(complex_of(p, way % 2), r, p->degree, complex_roots, &found);
        }
}
STACK_OF(algsurf_complex_roots, 64, OTHERS) { complex_calls(0); }
STACK_OF(algsurf_complex_roots_of_real, 64, OTHERS) { complex_calls(1); }

STACK_OF(algsurf_complex_roots_batch, 64, OTHERS) {
    static double c[ALGSURF_MAX_DEGREE + 1][9], im[ALGSURF_MAX_DEGREE + 1][9];
    static int count[9];
    static const int degrees[] = {2, 6, 10, 24, 64};
    for (int d = 0; d < 5; d++)
        for (int way = 0; way < 2; way++)
            for (int kernel = 0; algsurf_kernel_name(kernel); kernel++) {
                algsurf_batch_options o = {.size = sizeof o, .kernel = algsurf_kernel_name(kernel)};
                algsurf_complex_batch batch = {
                    .size = sizeof batch, .count = 9, .degree = degrees[d], .re = {c[0], 9, 1}};
                if (way) batch.im = (algsurf_table){im[0], 9, 1};
                for (int k = 0; k <= degrees[d]; k++) {
                    for (int i = 0; i < 9; i++) c[k][i] = (k * 5 + i) % 7 - 2.9, im[k][i] = 0.1 * (k % 3);
                }
                (void)algsurf_complex_roots_batch(&batch, &o, complex_roots, count);
            }
}

static algsurf_complex_solver *solver;

STACK_OF(algsurf_complex_solver_create, USUAL, OTHERS) {
    algsurf_complex_solver *made = NULL;
    (void)algsurf_complex_solver_create(MOST, &made);
    algsurf_complex_solver_free(made);
}
STACK_OF(algsurf_complex_solver_free, USUAL, OTHERS) { algsurf_complex_solver_free(NULL); }
STACK_OF(algsurf_complex_solver_run, 28, OTHERS) {
    for (int which = 0; which < POLYS; which++)
        for (int imaginary = 0; imaginary < 2; imaginary++) {
            const poly *p = polys + which;
            (void)algsurf_complex_solver_run(solver, complex_of(p, imaginary), NULL, p->degree, NULL,
                                             complex_roots, &found, NULL);
        }
}

STACK_OF(algsurf_complex_roots_integers, 28, OTHERS) {
    static const uint64_t limbs[3][2] = {{7, 5}, {3, 1u << 9}, {1, 1}};
    algsurf_integer c[MOST + 1];
    for (int n = 2; n <= MOST; n *= 4) {
        for (int k = 0; k <= n; k++) c[k] = (algsurf_integer){limbs[k % 3], k * k % 5 - 2 > 0 ? 2 : -2};
        (void)algsurf_complex_roots_integers(c, n == 8 ? c : NULL, n, complex_roots, &found);
    }
}

static algsurf_precise_roots *precise;

STACK_OF(algsurf_precise_roots_create, 36, OTHERS) {
    static const uint64_t limbs[3][2] = {{7, 5}, {3, 1u << 9}, {1, 1}};
    algsurf_integer c[MOST + 1];
    for (int n = 2; n <= 128; n *= 4) {
        for (int k = 0; k <= n; k++) c[k] = (algsurf_integer){limbs[k % 3], k * k % 5 - 2 > 0 ? 2 : -2};
        algsurf_precise_roots_free(precise);
        precise = NULL;
        (void)algsurf_precise_roots_create(c, n == 8 ? c : NULL, n, 1000, 0, &precise);
    }
}
STACK_OF(algsurf_precise_roots_count, USUAL, OTHERS) { (void)algsurf_precise_roots_count(precise); }
STACK_OF(algsurf_precise_roots_get, USUAL, OTHERS) {
    algsurf_precise_root root;
    (void)algsurf_precise_roots_get(precise, 0, &root);
}
STACK_OF(algsurf_precise_roots_free, USUAL, OTHERS) {
    algsurf_precise_roots_free(precise);
    precise = NULL;
}

static algsurf_complex quotient[MOST];
static algsurf_complex approximation = {0, 1};

STACK_OF(algsurf_paper_approximation, 44, OTHERS) {
    algsurf_paper_options o = {.size = sizeof o};
    (void)algsurf_paper_approximation(complex_of(polys, 1), MOST, (algsurf_complex){0, 1}, &o, &approximation,
                                      quotient, NULL);
}
STACK_OF(algsurf_paper_inclusion, 80, OTHERS) {
    static algsurf_cinterval Z, Q[MOST];
    (void)algsurf_paper_inclusion(complex_of(polys, 1), polys[0].r, MOST, approximation, quotient, NULL, &Z,
                                  Q, NULL, NULL);
}
STACK_OF(algsurf_paper_zeros, 110, OTHERS) {
    static algsurf_paper_zero zeros[MOST];
    algsurf_paper_options o = {.size = sizeof o, .max_steps = 2, .max_inflations = 1};
    (void)algsurf_paper_zeros(complex_of(polys, 1), polys[0].r, MOST, NULL, &o, zeros, &found);
}

static const algsurf_sector sector = {0.1, 0.5};
static const algsurf_complex_root seen[2] = {{{{1, 2}, {0.1, 0.9}}, {1.5, 0.5}, 1, 0},
                                             {{{1, 2}, {-0.9, -0.1}}, {1.5, -0.5}, 1, 0}};

STACK_OF(algsurf_sector_holds, USUAL, RENDERER) { (void)algsurf_sector_holds(&sector, seen, &found); }
STACK_OF(algsurf_select, USUAL, RENDERER) {
    int selected;
    (void)algsurf_select(seen, 2, &sector, 0, 10, &selected, &found);
}
STACK_OF(algsurf_select_of_real, USUAL, RENDERER) {
    int selected;
    (void)algsurf_select_of_real(seen, 2, &sector, 0, 10, &selected, &found);
}

/* ---- surfaces, cameras, light ---- */

/* As deep as allowed: parentheses, signs, powers, roots. */
STACK_OF(algsurf_surface_from_equation, 96, OTHERS) {
    static const char *const opening[] = {"(", "1+x*(", "2^(", "sqrt(", "x^1^1^(1*", "sin(", "T_1("};
    static const char *const inside[] = {"(x+y+z+1)^20", "x", "1", "2", "1", "1", "(x+y+z+1)^8"};
    static const int levels[] = {98, 62, 98, 98, 32, 98, 98};
    for (int i = 0; i < 7; i++) {
        char text[2000] = "x + ";
        algsurf_surface *surface = NULL;
        for (int level = 0; level < levels[i]; level++) strcat(text, opening[i]);
        strcat(text, inside[i]);
        for (int level = 0; level < levels[i]; level++) strcat(text, ")");
        (void)algsurf_surface_from_equation(text, NULL, 0, &surface, NULL);
        algsurf_surface_free(surface);
    }
}

static algsurf_term terms[47905]; /* all of degree 64 */
static size_t term_count;

static void make_terms(void) {
    for (int k = 0; k <= 64; k++)
        for (int j = 0; j + k <= 64; j++)
            for (int i = 0; i + j + k <= 64; i++)
                terms[term_count++] = (algsurf_term){i, j, k, 1 + 0.01 * ((i + 2 * j + 3 * k) % 17)};
}

STACK_OF(algsurf_surface_from_terms, 38, OTHERS) {
    algsurf_surface *surface = NULL;
    (void)algsurf_surface_from_terms(terms, term_count, &surface);
    algsurf_surface_free(surface);
    (void)algsurf_surface_from_terms(terms, 40, &surface);
    algsurf_surface_free(surface);
}
STACK_OF(algsurf_surface_with_error, 38, OTHERS) {
    for (int i = 0; i < SURFACES; i++) {
        algsurf_surface *surface = NULL;
        (void)algsurf_surface_with_error(surfaces[i], 1e-10, &surface);
        algsurf_surface_free(surface);
    }
}
STACK_OF(algsurf_surface_free, USUAL, OTHERS) { algsurf_surface_free(NULL); }
STACK_OF(algsurf_surface_degree, USUAL, OTHERS) { (void)algsurf_surface_degree(surfaces[0]); }
STACK_OF(algsurf_surface_rounding, USUAL, OTHERS) { (void)algsurf_surface_rounding(surfaces[0]); }
STACK_OF(algsurf_surface_term_count, USUAL, OTHERS) { (void)algsurf_surface_term_count(surfaces[0]); }
STACK_OF(algsurf_surface_terms, USUAL, OTHERS) {
    static algsurf_term copy[47905];
    (void)algsurf_surface_terms(surfaces[0], copy);
}

static const double near[3] = {0.1, 0.2, 0.3}, far[3] = {1e200, 1e-200, 3};

STACK_OF(algsurf_surface_value, USUAL, RENDERER) {
    double value, bound;
    for (int i = 0; i < SURFACES; i++) {
        (void)algsurf_surface_value(surfaces[i], near, &value, &bound);
        (void)algsurf_surface_value(surfaces[i], far, &value, &bound);
    }
}
STACK_OF(algsurf_surface_enclose, USUAL, RENDERER) {
    double lo[3], hi[3];
    int empty;
    for (int i = 0; i < SURFACES; i++)
        for (algsurf_part part = ALGSURF_PART_ALL; part <= ALGSURF_PART_SINGULAR; part++)
            (void)algsurf_surface_enclose(surfaces[i], &extents[1], part, 0.25, lo, hi, &empty);
}
STACK_OF(algsurf_surface_gradient, USUAL, RENDERER) {
    double value, gradient[3];
    for (int i = 0; i < SURFACES; i++) {
        (void)algsurf_surface_gradient(surfaces[i], near, &value, gradient, NULL, NULL);
        (void)algsurf_surface_gradient(surfaces[i], far, &value, gradient, NULL, NULL);
    }
}

static double b[2][ALGSURF_MAX_DEGREE + 1];
STACK_OF(algsurf_expand_power, USUAL, RENDERER) {
    for (int i = 0; i < SURFACES * RAYS; i++)
        (void)algsurf_expand_power(surfaces[i / RAYS], rays + i % RAYS, b[0], b[1]);
}
STACK_OF(algsurf_expand_bernstein, 12, RENDERER) {
    for (int i = 0; i < SURFACES * RAYS; i++) {
        algsurf_ray ray = rays[i % RAYS];
        ray.t_min = 0, ray.t_max = 3;
        (void)algsurf_expand_bernstein(surfaces[i / RAYS], &ray, b[0], b[1]);
    }
}
STACK_OF(algsurf_ray_clip, USUAL, RENDERER) {
    static const algsurf_plane planes[2] = {{{1, 0.5, 0}, 0.5}, {{-0.25, 0, 1}, 1}};
    for (int i = 0; i < 3 * RAYS; i++) {
        algsurf_ray chord;
        (void)algsurf_ray_clip(rays + i % RAYS, extents + i / RAYS, planes, 2, &chord, &found);
    }
}

static const double eye[3] = {4, 3, 2.5}, origin[3] = {0, 0, 0}, up[3] = {0, 0, 1};
static const double tilted[3] = {0.6, 0, 0.8}, down[3] = {0, 0, -1};
static const algsurf_material material = {.size = sizeof material,
                                          .outside = {1, 0.7, 0.4},
                                          .inside = {0.4, 0.7, 1},
                                          .diffuse = 0.7,
                                          .ambient = 0.2,
                                          .specular = 0.2,
                                          .roughness = 0.1};
static const algsurf_light light = {{4, 5, 6}, {1, 1, 1}, {1, 0, 0},          {0, 1, 0},
                                    3,         3,         ALGSURF_LIGHT_AREA, {0}};
static const algsurf_light spread = {{4, 5, 6}, {1, 1, 1}, {1, 0, 0},          {0, 1, 0},
                                     0,         0,         ALGSURF_LIGHT_AREA, {0}};
static const double grey[3] = {0.25, 0.25, 0.25};
static const algsurf_lighting lighting = {.size = sizeof lighting,
                                          .material = &material,
                                          .lights = &light,
                                          .light_count = 1,
                                          .up = {0, 1, 0},
                                          .forward = {0, 0, -1},
                                          .radius = 2,
                                          .bounded = 1};

STACK_OF(algsurf_camera_pinhole, USUAL, RENDERER) {
    algsurf_camera camera;
    (void)algsurf_camera_pinhole(eye, origin, up, 30, &camera);
}
STACK_OF(algsurf_camera_orthographic, USUAL, RENDERER) {
    algsurf_camera camera;
    (void)algsurf_camera_orthographic(eye, origin, up, 3, &camera);
}
static algsurf_camera camera;
STACK_OF(algsurf_camera_ray, USUAL, RENDERER) {
    algsurf_ray ray;
    (void)algsurf_camera_ray(&camera, 40, 30, 7.5, 3.5, &ray);
}
STACK_OF(algsurf_light_sample, USUAL, RENDERER) {
    double position[3];
    (void)algsurf_light_sample(&light, 1, 2, position);
}
STACK_OF(algsurf_shade, USUAL, RENDERER) {
    double colour[3];
    (void)algsurf_shade(&lighting, NULL, origin, tilted, down, colour);
}
STACK_OF(algsurf_shade_preview, USUAL, RENDERER) {
    double colour[3];
    (void)algsurf_shade_preview(&lighting, origin, tilted, down, colour);
}
static unsigned char grey_bytes[3];
STACK_OF(algsurf_srgb_decode, USUAL, OTHERS) {
    double colour[3];
    (void)algsurf_srgb_decode(grey_bytes, colour);
}
STACK_OF(algsurf_srgb_encode, USUAL, OTHERS) { (void)algsurf_srgb_encode(grey, grey_bytes); }

/* ---- scenes ---- */

static algsurf_scene *scene;

STACK_OF(algsurf_scene_create, USUAL, OTHERS) {
    algsurf_scene *made = NULL;
    (void)algsurf_scene_create(surfaces[0], &made);
    algsurf_scene_free(made);
}
STACK_OF(algsurf_scene_free, USUAL, OTHERS) { algsurf_scene_free(NULL); }
STACK_OF(algsurf_scene_get_lighting, USUAL, OTHERS) {
    static algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting of = {.size = sizeof of};
    (void)algsurf_scene_get_lighting(scene, lights, &of);
}
STACK_OF(algsurf_scene_set_antialias, USUAL, OTHERS) { (void)algsurf_scene_set_antialias(scene, 2); }
STACK_OF(algsurf_scene_set_antialias_threshold, USUAL, OTHERS) {
    (void)algsurf_scene_set_antialias_threshold(scene, 0.1);
}
STACK_OF(algsurf_scene_set_background, USUAL, OTHERS) { (void)algsurf_scene_set_background(scene, grey); }
STACK_OF(algsurf_scene_set_camera, USUAL, OTHERS) { (void)algsurf_scene_set_camera(scene, &camera); }
STACK_OF(algsurf_scene_set_clip, USUAL, OTHERS) {
    const algsurf_plane plane = {{1, 2, 3}, 0.5};
    (void)algsurf_scene_set_clip(scene, &plane, 1);
}
STACK_OF(algsurf_scene_set_coherence, USUAL, OTHERS) {
    (void)algsurf_scene_set_coherence(scene, ALGSURF_COHERENCE_NONE);
}
static const double half = 0.5;
static const algsurf_complex_space half_space = {sizeof half_space, {0, 0.3}, &half, 1};
STACK_OF(algsurf_scene_set_complex_space, USUAL, OTHERS) {
    (void)algsurf_scene_set_complex_space(scene, &half_space);
}
STACK_OF(algsurf_scene_set_extent, USUAL, OTHERS) { (void)algsurf_scene_set_extent(scene, extents + 2); }
STACK_OF(algsurf_scene_set_intersect_options, USUAL, OTHERS) {
    (void)algsurf_scene_set_intersect_options(scene, NULL);
}
STACK_OF(algsurf_scene_set_lights, USUAL, OTHERS) { (void)algsurf_scene_set_lights(scene, &light, 1); }
STACK_OF(algsurf_scene_set_material, USUAL, OTHERS) { (void)algsurf_scene_set_material(scene, &material); }
STACK_OF(algsurf_scene_set_quality, USUAL, OTHERS) {
    (void)algsurf_scene_set_quality(scene, ALGSURF_QUALITY_FULL);
}
STACK_OF(algsurf_scene_set_thin, USUAL, OTHERS) { (void)algsurf_scene_set_thin(scene, grey); }

enum { WIDTH = 17, HEIGHT = 2 };

static void draw(algsurf_scene *of) {
    static uint8_t pixels[WIDTH * HEIGHT * 4];
    static double t[WIDTH * HEIGHT];
    static float normals[WIDTH * HEIGHT * 3];
    static unsigned char state[WIDTH * HEIGHT];
    const algsurf_picture picture = {.size = sizeof picture,
                                     .pixels = pixels,
                                     .format = ALGSURF_RGBA8,
                                     .t = t,
                                     .normals = normals,
                                     .state = state};
    algsurf_render_options size = {.size = sizeof size, .width = WIDTH, .height = HEIGHT, .threads = 2};
    for (int k = 0; algsurf_kernel_name(k); k++) {
        algsurf_intersect_options o = {.size = sizeof o, .kernel = algsurf_kernel_name(k)};
        (void)algsurf_scene_set_intersect_options(of, &o);
        (void)algsurf_render(of, &size, &picture, NULL);
    }
}

/* All surfaces, in all extents, with one sample and chosen ones, what is thin, shadows, complex space. */
STACK_OF(algsurf_render, 58, RENDERER) {
    for (int i = 0; i < 3 * SURFACES; i++) {
        algsurf_scene *of = NULL;
        if (algsurf_scene_create(surfaces[i / 3], &of) != ALGSURF_OK) return;
        (void)algsurf_scene_set_extent(of, extents + i % 3);
        (void)algsurf_scene_set_lights(of, i % 2 ? &light : &spread, 1);
        (void)algsurf_scene_set_quality(of, ALGSURF_QUALITY_FULL);
        (void)algsurf_scene_set_thin(of, grey);
        draw(of);
        (void)algsurf_scene_set_antialias(of, 2);
        (void)algsurf_scene_set_antialias_threshold(of, 0.1);
        (void)algsurf_scene_set_complex_space(of, &half_space);
        draw(of);
        algsurf_scene_free(of);
    }
}

/* ---- intervals ---- */

static const algsurf_interval I = {0.1, 0.7};
static const algsurf_cinterval C = {{0.1, 0.7}, {-0.3, 0.2}};
static algsurf_interval row[MOST + 1], real_result;
static algsurf_cinterval complex_row[MOST + 1], complex_result;

#define RUN(name, call)                                                                                      \
    STACK_OF(name, USUAL, OTHERS) { (void)call; }
RUN(algsurf_interval_make, algsurf_interval_make(0, 1, &real_result))
RUN(algsurf_interval_add, algsurf_interval_add(I, I))
RUN(algsurf_interval_sub, algsurf_interval_sub(I, I))
RUN(algsurf_interval_mul, algsurf_interval_mul(I, I))
RUN(algsurf_interval_div, algsurf_interval_div(I, I, &real_result))
RUN(algsurf_interval_pow, algsurf_interval_pow(I, -77, &real_result))
RUN(algsurf_interval_sqrt, algsurf_interval_sqrt(I, &real_result))
RUN(algsurf_interval_abs, algsurf_interval_abs(I))
RUN(algsurf_interval_hull, algsurf_interval_hull(I, I))
RUN(algsurf_interval_intersect, algsurf_interval_intersect(I, I, &real_result))
RUN(algsurf_interval_width, algsurf_interval_width(I))
RUN(algsurf_interval_mid, algsurf_interval_mid(I))
RUN(algsurf_interval_contains, algsurf_interval_contains(I, 0.3))
RUN(algsurf_interval_interior, algsurf_interval_interior(I, I))
RUN(algsurf_interval_poly, algsurf_interval_poly(row, MOST, I, &real_result))
RUN(algsurf_cinterval_add, algsurf_cinterval_add(C, C))
RUN(algsurf_cinterval_sub, algsurf_cinterval_sub(C, C))
RUN(algsurf_cinterval_mul, algsurf_cinterval_mul(C, C))
RUN(algsurf_cinterval_div, algsurf_cinterval_div(C, C, &complex_result))
RUN(algsurf_cinterval_abs, algsurf_cinterval_abs(C))
RUN(algsurf_cinterval_arg, algsurf_cinterval_arg(C, &real_result))
RUN(algsurf_cinterval_hull, algsurf_cinterval_hull(C, C))
RUN(algsurf_cinterval_intersect, algsurf_cinterval_intersect(C, C, &complex_result))
RUN(algsurf_cinterval_width, algsurf_cinterval_width(C))
RUN(algsurf_cinterval_mid, algsurf_cinterval_mid(C))
RUN(algsurf_cinterval_contains, algsurf_cinterval_contains(C, (algsurf_complex){0, 0}))
RUN(algsurf_cinterval_interior, algsurf_cinterval_interior(C, C))
RUN(algsurf_cinterval_poly, algsurf_cinterval_poly(complex_row, MOST, C, &complex_result))
RUN(algsurf_kernel_name, algsurf_kernel_name(0))
RUN(algsurf_status_name, algsurf_status_name(ALGSURF_OK))
RUN(algsurf_status_text, algsurf_status_text(ALGSURF_OK))
RUN(algsurf_version, algsurf_version())
RUN(algsurf_version_number, algsurf_version_number())
STACK_OF(algsurf_self_test, 60, OTHERS) { (void)algsurf_self_test(); }

#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define COMPARED 1
#else
#define COMPARED 0
#endif

TEST(as_stated) {
    size_t own = depth_of(NULL);
    int failures = 0;
    print_message("a thread's own: %zu bytes\n", own);
    for (int i = 0; i < call_count; i++) {
        calls[i].run();
        size_t all = depth_of(calls[i].run), taken = all > own ? all - own : 0;
        int stated = calls[i].stated, fits = (size_t)stated * 1024 + own <= (size_t)calls[i].limit * 1024;
        if (taken <= (size_t)stated * 1024 && fits) continue;
        print_message("%s: %zu bytes; stated: %d KiB, of %d\n", calls[i].name, taken, stated, calls[i].limit);
        failures++;
    }
    if (COMPARED) assert_int_equal(failures, 0);
}

int main(void) {
    make_polys();
    find_brackets();
    make_surfaces();
    make_terms();
    if (algsurf_complex_solver_create(MOST, &solver) != ALGSURF_OK) return 1;
    if (algsurf_scene_create(surfaces[0], &scene) != ALGSURF_OK) return 1;
    if (algsurf_camera_pinhole(eye, origin, up, 30, &camera) != ALGSURF_OK) return 1;
    for (int k = 0; k <= MOST; k++) row[k] = I, complex_row[k] = C;
    int failed = unit_run("stack");
    algsurf_scene_free(scene);
    algsurf_complex_solver_free(solver);
    free_surfaces();
    return failed;
}
