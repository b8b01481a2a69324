/* series.c - the polynomials of Chebyshev, T_n and U_n, and Legendre, P_n; see parse.h.
 *
 * Coefficients of T and U come from T_n = 2x T_{n-1} - T_{n-2}: whole numbers below 2^106, so sums of
 * double-doubles are exact.  2^n P_n has whole coefficients, too (DLMF, 18.5.8): that of x^(n-2m) is
 * (-1)^m C(n,m) C(2n-2m,n), and each is a fraction of the one before, of whole numbers below 2^13.  At most 3
 * operations for each of 32 + 64 fractions, right to 2^-99, are right to 2^-90 together; below 2^88 the whole
 * number is the nearest one.
 */
#include "../base/arithmetic.h"
#include "../base/fpenv.h"
#include "parse.h"

#include <math.h>
#include <string.h>

enum { KIND_T = 1, KIND_U, KIND_P };

static const double legendre_error = 0x1p-90;

/* ---- what the text says ---- */

/* Reads an index, at most 1000, whose digits stand behind these bytes each; returns what is behind it, or
 * null if none is there. */
static const char *read_index(const char *text, const char *before, char zero, int *index) {
    const char *start = text;
    const size_t skipped = strlen(before);
    for (*index = 0; strncmp(text, before, skipped) == 0; text += skipped + 1) {
        const int digit = (unsigned char)text[skipped] - (unsigned char)zero;
        if (digit < 0 || digit > 9) break;
        *index = *index < 100 ? 10 * *index + digit : 1000;
    }
    return text > start ? text : NULL;
}

/* An index below the line: _6, _{6}, or the signs of Unicode for that. */
static const char *read_low_index(const char *text, int *index) {
    if (text[0] != '_') return read_index(text, "\xe2\x82", '\x80', index);
    int braced = text[1] == '{';
    text = read_index(text + 1 + braced, "", '0', index);
    if (!braced) return text;
    return text && *text == '}' ? text + 1 : NULL;
}

int algsurf_i_series_follows(const char *text, algsurf_i_series_head *head) {
    static const char *const words[] = {"hebyshevT", "hebyshevU", "egendreP"}; /* behind their first letter */
    static const char letters[] = "CCLccl";
    const char *at = text + 1;
    int word = 0;
    for (int w = 0; w < 6 && !word; w++) {
        size_t length = strlen(words[w % 3]);
        if (*text != letters[w] || strncmp(at, words[w % 3], length) != 0) continue;
        word = w % 3 + 1;
        at += length;
    }
    if (word && algsurf_i_name_part_at(at).width) return 0;
    head->kind = word ? word : algsurf_i_listed("T U P", text, 1);
    if (!head->kind || (!word && !(at = read_low_index(at, &head->index)))) return 0;
    at += algsurf_i_blanks(at);
    const algsurf_i_token bracket = algsurf_i_token_at(at);
    if (!algsurf_i_closing(bracket.kind)) return 0;
    head->bracket = (char)bracket.kind;
    at += bracket.width;
    if (word) {
        at = read_index(at + algsurf_i_blanks(at), "", '0', &head->index);
        if (!at) return 0;
        at += algsurf_i_blanks(at);
        if (*at++ != ',') return 0;
    }
    head->width = (size_t)(at - text);
    return 1;
}

/* ---- coefficients ---- */

static void chebyshev(int kind, int n, algsurf_dd c[]) {
    algsurf_dd older[ALGSURF_MAX_DEGREE + 1] = {{0, 0}}, newer[ALGSURF_MAX_DEGREE + 1] = {{0, 0}};
    older[0].hi = 1;
    newer[1].hi = kind;
    for (int k = 0; k < n; k++)
        for (int i = n; i >= 0; i--) {
            algsurf_dd twice = i > 0 ? algsurf_dd_scale(newer[i - 1], 2) : (algsurf_dd){0, 0};
            twice = algsurf_dd_sub(twice, older[i]);
            older[i] = newer[i];
            newer[i] = twice;
        }
    for (int i = 0; i <= n; i++) c[i] = older[i];
}

/* The nearest whole number. */
static algsurf_dd whole(algsurf_dd v) {
    if (fabs(v.hi) < 0x1p53) return algsurf_dd_from(rint(v.hi + v.lo));
    return algsurf_fast_two_sum(v.hi, rint(v.lo));
}

/* Times 2^n. */
static void legendre(int n, algsurf_dd c[]) {
    algsurf_dd v = {1, 0};
    for (int i = 1; i <= n; i++) v = algsurf_dd_div(algsurf_dd_mul_d(v, n + i), algsurf_dd_from(i));
    for (int m = 0; 2 * m <= n; m++) {
        c[n - 2 * m] = whole(v);
        v = algsurf_dd_mul_d(v, -(double)(n - 2 * m) * (n - 2 * m - 1));
        v = algsurf_dd_div(v, algsurf_dd_from(2.0 * (m + 1) * (2 * n - 2 * m - 1)));
    }
}

/* The last value becomes the polynomial in it.  A function of its own: its arrays are not on the stack while
 * the argument is read, which may be nested. */
static ALGSURF_NOINLINE algsurf_status apply(value *v, int kind, int n) {
    algsurf_dd c[ALGSURF_MAX_DEGREE + 1] = {{0, 0}};
    monomial term[ALGSURF_MAX_DEGREE + 1];
    if (kind == KIND_P)
        legendre(n, c);
    else
        chebyshev(kind, n, c);
    for (int i = 0; i <= n; i++) {
        double err = kind == KIND_P && fabs(c[i].hi) >= 0x1p88 ? legendre_error * fabs(c[i].hi) : 0;
        term[i] = algsurf_i_monomial_make(c[i], err, kind == KIND_P ? -n : 0, 0);
    }
    if (n != 1) return algsurf_i_value_compose(v, term, n);
    value by = {{NULL, 0}, NULL}; /* T_1(a) is a: a series about it would only make its way longer */
    algsurf_status status = algsurf_i_tripoly_make(term[1], &by.p);
    return status == ALGSURF_OK ? algsurf_i_value_multiply(v, &by) : status;
}

int algsurf_i_parse_series(parser *p, const algsurf_i_series_head *head) {
    size_t offset = p->at;
    int n = head->index, kind = head->kind;
    p->at += head->width;
    p->token = (algsurf_i_token){head->bracket, 0, 0};
    if (!algsurf_i_parse_nested(p, offset, algsurf_i_parse_inside)) return 0;
    value *v = algsurf_i_parse_top(p);
    if (n > 0 && algsurf_i_tripoly_degree(&v->p) * n > ALGSURF_MAX_DEGREE)
        return algsurf_i_parse_fail(p, ALGSURF_E_DEGREE, offset, "the degree of this polynomial is above 64");
    if (n > ALGSURF_MAX_DEGREE) return algsurf_i_parse_refuse(p, offset, "expected an index up to 64");
    return algsurf_i_parse_computed(p, apply(v, kind, n), offset);
}
