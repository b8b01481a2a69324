/* batch.c - the roots of many polynomials, a row each, and values of one polynomial at many places.
 *
 * Functions return None, or (index, status) of the first polynomial or place that is refused. */
#include "module.h"

/* Polynomials, table 0, and their intervals, buffers 1 and 2: ends for each, or one for all.  0: an error is
 * raised. */
static int batch_of(const taken *t, algsurf_real_batch *batch) {
    const doubles *c = &t->table[0];
    const size_t one = sizeof(double);
    const ptrdiff_t step = (size_t)t->buffer[1].len != one || (size_t)t->buffer[2].len != one;
    *batch = (algsurf_real_batch){.size = sizeof *batch,
                                  .count = (size_t)c->rows,
                                  .degree = (int)c->columns - 1,
                                  .coefficients = {c->at, c->column, c->row},
                                  .lo = t->buffer[1].buf,
                                  .hi = t->buffer[2].buf,
                                  .interval_step = step};
    if (c->columns > ALGSURF_MAX_POLY_DEGREE + 1) refuse(ALGSURF_E_DEGREE);
    return !PyErr_Occurred() && (!step || (holds(t, 1, c->rows, one) && holds(t, 2, c->rows, one)));
}

static PyObject *first_refused(const int *count, Py_ssize_t rows, int status) {
    Py_ssize_t at = 0;
    while (status != ALGSURF_OK && at + 1 < rows && count[at] >= 0) at++;
    return refused_at(at, status);
}

/* real_batch(c, lo, hi, roots, count): room for max(degree, 1) roots of each; a count may be a status */
static PyObject *real_batch(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    algsurf_real_batch batch;
    int status;
    if (!take(args, n, "trrww", &t)) return NULL;
    const Py_ssize_t rows = t.table[0].rows, room = t.table[0].columns > 2 ? t.table[0].columns - 1 : 1;
    int *count = t.buffer[4].buf;
    if (!batch_of(&t, &batch) || !holds(&t, 3, rows * room, sizeof(algsurf_real_root)) ||
        !holds(&t, 4, rows, sizeof *count))
        return give_back(&t, NULL);
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_real_roots_batch(&batch, NULL, t.buffer[3].buf, count);
    PyEval_RestoreThread(own);
    return give_back(&t, first_refused(count, rows, status));
}

/* complex_batch(re, roots, count), complex_batch(re, roots, count, im): likewise */
static PyObject *complex_batch(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    int status;
    if (!take(args, n, n == 3 ? "tww" : "twwt", &t)) return NULL;
    const doubles re = t.table[0], im = n == 3 ? (doubles){NULL, re.rows, re.columns, 0, 0} : t.table[1];
    const algsurf_complex_batch batch = {.size = sizeof batch,
                                         .count = (size_t)re.rows,
                                         .degree = (int)re.columns - 1,
                                         .re = {re.at, re.column, re.row},
                                         .im = {im.at, im.column, im.row}};
    int *count = t.buffer[2].buf;
    if (re.columns > ALGSURF_MAX_POLY_DEGREE + 1) return give_back(&t, refuse(ALGSURF_E_DEGREE));
    if (re.columns != im.columns || re.rows != im.rows || !holds(&t, 2, re.rows, sizeof *count) ||
        !holds(&t, 1, re.rows * (re.columns - 1), sizeof(algsurf_complex_root)))
        return give_back(&t, PyErr_Occurred() ? NULL : refuse(ALGSURF_E_ARGUMENT));
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_complex_roots_batch(&batch, NULL, t.buffer[1].buf, count);
    PyEval_RestoreThread(own);
    return give_back(&t, first_refused(count, re.rows, status));
}

/* pad(roots, count, none): what stands behind the roots of each row becomes none[0], or, if the count is
 * negative, all of it none[1].  The rows and the items are as long as the sizes of the arrays tell. */
static PyObject *pad(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    if (!take(args, n, "wrr", &t)) return NULL;
    const int *count = t.buffer[1].buf;
    const char *none = t.buffer[2].buf;
    const Py_ssize_t rows = t.buffer[1].len / (Py_ssize_t)sizeof *count, size = t.buffer[2].len / 2;
    const Py_ssize_t room = rows > 0 && size > 0 ? t.buffer[0].len / rows / size : 0;
    PyThreadState *own = PyEval_SaveThread();
    char *row = t.buffer[0].buf;
    for (Py_ssize_t i = 0; i < rows; i++, row += room * size)
        for (Py_ssize_t r = count[i] < 0 ? 0 : count[i]; r < room; r++)
            memcpy(row + r * size, none + (count[i] < 0 ? size : 0), (size_t)size);
    PyEval_RestoreThread(own);
    return give_back(&t, refused_at(0, ALGSURF_OK));
}

/* first_batch(c, lo, hi, root, state): infinity where there is none */
static PyObject *first_batch(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    algsurf_real_batch batch;
    int status;
    if (!take(args, n, "trrww", &t)) return NULL;
    const Py_ssize_t rows = t.table[0].rows;
    unsigned char *state = t.buffer[4].buf;
    if (!batch_of(&t, &batch) || !holds(&t, 3, rows, sizeof(double)) || !holds(&t, 4, rows, 1))
        return give_back(&t, NULL);
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_first_roots_batch(&batch, NULL, state, t.buffer[3].buf);
    PyEval_RestoreThread(own);
    Py_ssize_t at = 0;
    while (status != ALGSURF_OK && at + 1 < rows && state[at] <= ALGSURF_FIRST_ROOT_FOUND) at++;
    return give_back(&t, refused_at(at, status));
}

/* evaluate(c, radii, x, value, bound): at each x; radii may be empty */
static PyObject *evaluate(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    enum { C, RADII, X, VALUE, BOUND };
    taken t;
    int status = ALGSURF_OK;
    if (!take(args, n, "rrrww", &t)) return NULL;
    const size_t size = sizeof(double);
    const Py_ssize_t places = t.buffer[X].len / (Py_ssize_t)size, terms = t.buffer[C].len / (Py_ssize_t)size;
    const double *c = t.buffer[C].buf, *radii = t.buffer[RADII].len > 0 ? t.buffer[RADII].buf : NULL;
    const double *x = t.buffer[X].buf;
    double *value = t.buffer[VALUE].buf, *bound = t.buffer[BOUND].buf;
    Py_ssize_t i = 0;
    if (terms > ALGSURF_MAX_POLY_DEGREE + 1) return give_back(&t, refuse(ALGSURF_E_DEGREE));
    if ((radii && !holds(&t, RADII, terms, size)) || !holds(&t, VALUE, places, size) ||
        !holds(&t, BOUND, places, size))
        return give_back(&t, NULL);
    PyThreadState *own = PyEval_SaveThread();
    for (; i < places && status == ALGSURF_OK; i++)
        status = algsurf_poly_value_compensated(c, radii, (int)terms - 1, x[i], value + i, bound + i);
    PyEval_RestoreThread(own);
    return give_back(&t, refused_at(i - 1, status));
}

PyMethodDef batch_methods[] = {METHOD(real_batch),  METHOD(pad),      METHOD(complex_batch),
                               METHOD(first_batch), METHOD(evaluate), METHODS_END};
