/* roots.c - the roots of one polynomial.
 *
 * Lists and tuples of plain numbers are read here, for the sake of speed: of floats, of whole numbers that
 * doubles hold, and, where that makes sense, of complex numbers.  Of anything else the answer is None, and
 * the caller has to make plain numbers or integers of it. */
#include "module.h"

enum { MOST = ALGSURF_MAX_POLY_DEGREE + 1 };
static const long long WHOLE = 1LL << 53; /* all whole numbers up to this are doubles */

typedef struct polynomial {
    double re[MOST];
    algsurf_complex z[MOST]; /* only if is_complex */
    int degree, is_complex;
} polynomial;

/* A number, 1; a complex one, 2; nothing plain, 0. */
static int read_number(PyObject *x, double *re, double *im) {
    *im = 0;
    if (PyFloat_Check(x)) {
        *re = PyFloat_AsDouble(x);
        return 1;
    }
    if (PyLong_Check(x)) {
        int overflow;
        const long long whole = PyLong_AsLongLongAndOverflow(x, &overflow);
        *re = (double)whole;
        return !overflow && whole >= -WHOLE && whole <= WHOLE;
    }
    if (!PyComplex_Check(x)) return 0;
    *re = PyComplex_RealAsDouble(x);
    *im = PyComplex_ImagAsDouble(x);
    return 2;
}

/* 1: it is read; 0: it holds something that is not plain; -1: an error is raised. */
static int read_plain(PyObject *c, polynomial *p, int complex_too) {
    const int is_list = PyList_Check(c);
    if (!is_list && !PyTuple_Check(c)) return 0;
    const Py_ssize_t n = is_list ? PyList_Size(c) : PyTuple_Size(c);
    if (n == 0) {
        PyErr_SetString(PyExc_ValueError, "a polynomial without coefficients");
        return -1;
    }
    p->degree = (int)n - 1;
    p->is_complex = 0;
    for (Py_ssize_t i = 0; i < n; i++) {
        if (i == MOST) {
            (void)refuse(ALGSURF_E_DEGREE);
            return -1;
        }
        double im;
        const int kind = read_number(is_list ? PyList_GetItem(c, i) : PyTuple_GetItem(c, i), &p->re[i], &im);
        if (kind == 0 || (kind == 2 && !complex_too)) return 0;
        if (kind == 2 && !p->is_complex) {
            for (Py_ssize_t k = 0; k < i; k++) p->z[k] = (algsurf_complex){p->re[k], 0};
            p->is_complex = 1;
        }
        if (p->is_complex) p->z[i] = (algsurf_complex){p->re[i], im};
    }
    return 1;
}

/* What a call begins with: arguments (c, lo, hi), or (c) alone.  If it is not to go on, *answer is what to
 * return. */
static int begin(PyObject *const *args, Py_ssize_t n, int real, polynomial *p, double ends[2],
                 PyObject **answer) {
    *answer = NULL;
    if (n != (real ? 3 : 1)) {
        PyErr_SetString(PyExc_TypeError, "another number of arguments was expected");
        return 0;
    }
    const int read = read_plain(args[0], p, !real);
    if (read == 0) *answer = refused_at(0, ALGSURF_OK); /* None */
    for (int i = 0; read == 1 && real && i < 2; i++) {
        ends[i] = PyFloat_AsDouble(args[1 + i]);
        if (ends[i] == -1 && PyErr_Occurred()) return 0;
    }
    if (read == 1 && real && ends[0] > ends[1]) {
        PyErr_SetString(PyExc_ValueError, "lo is above hi");
        return 0;
    }
    return read == 1;
}

static PyObject *bytes_of(int status, const void *found, int count, size_t size) {
    return status < 0 ? refuse(status) : PyByteArray_FromStringAndSize(found, count * (Py_ssize_t)size);
}

/* real_roots(c, lo, hi): the bytes of an algsurf_real_root for each root */
static PyObject *real_roots(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    polynomial p;
    algsurf_real_root found[MOST];
    double ends[2];
    int status, count = 0;
    PyObject *answer;
    if (!begin(args, n, 1, &p, ends, &answer)) return answer;
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_real_roots(p.re, p.degree, ends[0], ends[1], found, MOST, &count);
    PyEval_RestoreThread(own);
    return bytes_of(status, found, count, sizeof *found);
}

/* count_roots(c, lo, hi): how many */
static PyObject *count_roots(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    polynomial p;
    double ends[2];
    int status, count = 0;
    PyObject *answer;
    if (!begin(args, n, 1, &p, ends, &answer)) return answer;
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_count_roots(p.re, NULL, p.degree, ends[0], ends[1], &count);
    PyEval_RestoreThread(own);
    return status < 0 ? refuse(status) : PyLong_FromLong(count);
}

/* first_root(c, lo, hi): the root, or infinity if there is none */
static PyObject *first_root(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    polynomial p;
    double ends[2], root = 0;
    int status, found = 0;
    PyObject *answer;
    if (!begin(args, n, 1, &p, ends, &answer)) return answer;
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_real_root_first(p.re, p.degree, ends[0], ends[1], &root, &found);
    PyEval_RestoreThread(own);
    return status < 0 ? refuse(status) : PyFloat_FromDouble(found ? root : Py_HUGE_VAL);
}

/* complex_roots(c): the bytes of an algsurf_complex_root for each box */
static PyObject *complex_roots(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    polynomial p;
    algsurf_complex_root found[MOST];
    int status, count = 0;
    PyObject *answer;
    if (!begin(args, n, 0, &p, NULL, &answer)) return answer;
    PyThreadState *own = PyEval_SaveThread();
    status = p.is_complex ? algsurf_complex_roots(p.z, NULL, p.degree, found, &count)
                          : algsurf_complex_roots_of_real(p.re, NULL, p.degree, found, &count);
    PyEval_RestoreThread(own);
    return bytes_of(status, found, count, sizeof *found);
}

/* roots_integers(limbs, lengths, is_complex): as complex_roots; real parts, then as many imaginary ones if
 * is_complex. roots_integers(limbs, lengths, is_complex, lo, hi): as real_roots. limbs are those of all
 * integers, one after another; lengths tell how many each has, with its sign. */
static PyObject *roots_integers(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    algsurf_integer c[2 * MOST];
    union {
        algsurf_real_root real[MOST];
        algsurf_complex_root complex[MOST];
    } found;
    int status, count = 0;
    if (!take(args, n, n == 3 ? "rri" : "rridd", &t)) return NULL;
    const int *length = t.buffer[1].buf, parts = t.whole[0] != 0 ? 2 : 1;
    const Py_ssize_t all = t.buffer[1].len / (Py_ssize_t)sizeof *length;
    if (all > parts * MOST) return give_back(&t, refuse(ALGSURF_E_DEGREE));
    const uint64_t *limbs = t.buffer[0].buf;
    const int terms = (int)all / parts;
    Py_ssize_t used = 0;
    for (int i = 0; i < all; i++) {
        c[i] = (algsurf_integer){limbs + used, length[i]};
        used += length[i] < 0 ? -(Py_ssize_t)length[i] : length[i];
    }
    if (!holds(&t, 0, used, sizeof *limbs)) return give_back(&t, NULL);
    PyThreadState *own = PyEval_SaveThread();
    status = n == 3
                 ? algsurf_complex_roots_integers(c, parts == 2 ? c + terms : NULL, terms - 1, found.complex,
                                                  &count)
                 : algsurf_real_roots_integers(c, terms - 1, t.real[0], t.real[1], found.real, MOST, &count);
    PyEval_RestoreThread(own);
    return give_back(&t,
                     bytes_of(status, &found, count, n == 3 ? sizeof *found.complex : sizeof *found.real));
}

PyMethodDef roots_methods[] = {METHOD(real_roots),    METHOD(count_roots),    METHOD(first_root),
                               METHOD(complex_roots), METHOD(roots_integers), METHODS_END};
