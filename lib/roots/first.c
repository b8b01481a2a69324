/* first.c - many polynomials: checked, solved side by side, and what stays in doubt one by one.
 *
 * The packet code (first_template.h) writes the answers it is sure of, and ALGSURF_LANE_DOUBTFUL as state of
 * the others.  Those are decided alone, in integers: they are the ill-conditioned ones. */
#include "algsurf/packet.h"

#include <math.h>
#include <string.h>

#include "algsurf/isolate.h"
#include "../base/fpenv.h"
#include "coefficients.h"
#include "decide.h"
#include "kernel.h"
#include "../base/options.h"

typedef struct query {
    algsurf_poly_packet polys;
    algsurf_first_roots_options options;
    const algsurf_i_roots_kernel *kernel;
} query;

static algsurf_status check_one(const algsurf_poly_packet *p, size_t i) {
    if (!isfinite(p->lo[i]) || !isfinite(p->hi[i])) return ALGSURF_E_NOT_FINITE;
    if (!(p->lo[i] < p->hi[i])) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k <= p->degree; k++) {
        if (!isfinite(p->c[k][i]) || (p->r && !isfinite(p->r[k][i]))) return ALGSURF_E_NOT_FINITE;
        if (p->r && p->r[k][i] < 0) return ALGSURF_E_ARGUMENT;
    }
    return ALGSURF_OK;
}

static algsurf_status check_shape(const algsurf_poly_packet *p) {
    if (p->degree < 0 || p->degree > ALGSURF_MAX_POLY_DEGREE) return ALGSURF_E_ARGUMENT;
    if (p->count == 0) return ALGSURF_OK;
    if (!p->c || !p->lo || !p->hi) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k <= p->degree; k++)
        if (!p->c[k] || (p->r && !p->r[k])) return ALGSURF_E_ARGUMENT;
    return ALGSURF_OK;
}

static algsurf_status prepare(query *q, const algsurf_poly_packet *packet,
                              const algsurf_first_roots_options *options) {
    q->options = (algsurf_first_roots_options){.size = sizeof q->options};
    if (!packet || !algsurf_options_read(&q->polys, sizeof q->polys, packet)) return ALGSURF_E_ARGUMENT;
    if (options && !algsurf_options_read(&q->options, sizeof q->options, options)) return ALGSURF_E_ARGUMENT;
    if (!(q->options.tolerance >= 0 && q->options.tolerance < 1)) return ALGSURF_E_ARGUMENT;
    const algsurf_i_kernel *kernel = algsurf_i_kernel_find(q->options.kernel);
    if (!kernel) return ALGSURF_E_ARGUMENT;
    q->kernel = algsurf_i_roots_kernel_for(kernel);
    return check_shape(&q->polys);
}

/* Coefficient k of v^k over [-1,1] in the Bernstein basis of degree n at j (n+1) + k: that of x^k in
 * (1+x)^j (1-x)^(n-j) over C(n,k), the numbers of ways to choose k ends of n.  All but the quotient is exact.
 */
static void set_basis(double *basis, int n) {
    double binomial[ALGSURF_MAX_POLYS_DEGREE + 1] = {1}, g[ALGSURF_MAX_POLYS_DEGREE + 1] = {1};
    for (int k = 1; k <= n; k++) {
        binomial[k] = binomial[k - 1] * (n - k + 1) / k;
        g[k] = k % 2 ? -binomial[k] : binomial[k];
    }
    for (int j = 0; j <= n; j++) {
        for (int k = 0; k <= n; k++) basis[j * (n + 1) + k] = g[k] / binomial[k];
        for (int k = 1; k <= n; k++) g[k] += g[k - 1]; /* g / (1-x) */
        for (int k = n; k >= 1; k--) g[k] += g[k - 1]; /* g (1+x) */
    }
}

/* The set of polynomials within the radii: its first place with roots. */
static algsurf_status solve_set(const algsurf_i_coefficients *p, double lo, double hi, unsigned char *state,
                                double *where) {
    algsurf_bracket b[ALGSURF_MAX_POLY_DEGREE + 1];
    int found = 0;
    algsurf_status status =
        algsurf_isolate_all(p->c, p->r, p->degree, lo, hi, b, ALGSURF_MAX_POLY_DEGREE + 1, &found);
    if (status < 0 && status != ALGSURF_E_ZERO) return status;
    if (status == ALGSURF_E_ZERO || (found && b[0].kind == ALGSURF_ROOT_UNDECIDED)) {
        *state = ALGSURF_FIRST_ROOT_UNCERTAIN;
        *where = found ? 0.5 * b[0].lo + 0.5 * b[0].hi : lo;
        return ALGSURF_OK;
    }
    *state = found ? ALGSURF_FIRST_ROOT_FOUND : ALGSURF_FIRST_ROOT_NONE;
    if (!found) return ALGSURF_OK;
    *where = 0.5 * b[0].lo + 0.5 * b[0].hi;
    status = algsurf_i_decide_ranges(p, b[0].lo, b[0].hi, b + 1, 1, &found,
                                     NULL); /* as narrow as the radii allow */
    if (found) *where = 0.5 * b[1].lo + 0.5 * b[1].hi;
    return status;
}

/* One polynomial alone: OK or E_NO_MEMORY, and then it stays uncertain. */
static algsurf_status solve_alone(const algsurf_poly_packet *polys, size_t i, unsigned char *state,
                                  double *root) {
    double c[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1], where = HUGE_VAL;
    algsurf_i_coefficients p = {c, polys->r ? r : NULL, polys->degree};
    algsurf_real_root first;
    algsurf_status status = ALGSURF_OK;
    int found = 0, zero = 1;
    for (int k = 0; k <= p.degree; k++) {
        c[k] = polys->c[k][i];
        r[k] = polys->r ? polys->r[k][i] : 0;
        zero = zero && c[k] == 0;
    }
    state[i] = ALGSURF_FIRST_ROOT_UNCERTAIN;
    if (p.r) {
        status = solve_set(&p, polys->lo[i], polys->hi[i], state + i, &where);
    } else if (zero) {
        where = polys->lo[i];
    } else {
        status = algsurf_i_decide_roots(c, p.degree, polys->lo[i], polys->hi[i], 1, &first, 1, &found, NULL);
        if (status == ALGSURF_OK) state[i] = found ? ALGSURF_FIRST_ROOT_FOUND : ALGSURF_FIRST_ROOT_NONE;
        if (found) where = first.value;
    }
    if (root) root[i] = where;
    return status;
}

static ALGSURF_NOINLINE algsurf_status run(const algsurf_poly_packet *packet,
                                           const algsurf_first_roots_options *options, unsigned char *state,
                                           double *root) {
    query q;
    double basis[(ALGSURF_MAX_POLYS_DEGREE + 1) * (ALGSURF_MAX_POLYS_DEGREE + 1)];
    algsurf_status status = prepare(&q, packet, options);
    size_t count = status == ALGSURF_OK ? q.polys.count : 0;
    if (count == 0) return status;
    if (!state) return ALGSURF_E_ARGUMENT;
    const algsurf_poly_packet *p = &q.polys;
    const algsurf_i_polys_job job = {p->c,  p->r,  p->lo, p->hi, p->degree, q.options.tolerance,
                                     basis, state, root};
    if (!q.kernel->good(&job, count))
        for (size_t i = 0; i < count; i++)
            if ((status = check_one(p, i)) != ALGSURF_OK) return status;
    if (p->degree >= 1 && p->degree <= ALGSURF_MAX_POLYS_DEGREE) {
        if (p->degree > 2) set_basis(basis, p->degree);
        q.kernel->solve(&job, count);
    } else {
        memset(state, ALGSURF_LANE_DOUBTFUL, count);
    }
    const unsigned char *doubtful = state;
    while ((doubtful = memchr(doubtful, ALGSURF_LANE_DOUBTFUL, (size_t)(state + count - doubtful)))) {
        algsurf_status alone = solve_alone(p, (size_t)(doubtful - state), state, root);
        if (alone != ALGSURF_OK) status = alone;
        doubtful++;
    }
    return status;
}

algsurf_status algsurf_first_roots(const algsurf_poly_packet *packet,
                                   const algsurf_first_roots_options *options, unsigned char *state,
                                   double *root) {
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = run(packet, options, state, root);
    algsurf_fpenv_leave(&saved);
    return status;
}
