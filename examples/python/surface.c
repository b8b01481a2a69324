/* surface.c - a surface, in a capsule; its terms, values, gradients, where it is, and what rays meet. */
#include "module.h"

/* Pairs (name, value).  Null: an error is raised. */
static algsurf_constant *constants_from(PyObject *pairs, Py_ssize_t count) {
    algsurf_constant *all = PyMem_Malloc(((size_t)count + 1) * sizeof *all);
    if (!all) PyErr_NoMemory();
    for (Py_ssize_t i = 0; i < count && all; i++) {
        PyObject *pair = PyTuple_GetItem(pairs, i);
        if (pair && PyArg_ParseTuple(pair, "sd", &all[i].name, &all[i].value)) continue;
        PyMem_Free(all);
        all = NULL;
    }
    return all;
}

/* surface_from_equation(text, ((name, value), ...)): a capsule; or, of an equation that is refused, (status,
 * offset, length, message), message None if it is not known where */
static PyObject *surface_from_equation(PyObject *module, PyObject *args) {
    (void)module;
    const char *text;
    PyObject *pairs;
    algsurf_surface *surface = NULL;
    algsurf_parse_error error = {0, 0, NULL};
    algsurf_status status;
    if (!PyArg_ParseTuple(args, "sO!", &text, &PyTuple_Type, &pairs)) return NULL;
    const Py_ssize_t count = PyTuple_Size(pairs);
    algsurf_constant *constants = constants_from(pairs, count);
    if (!constants) return NULL;
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_surface_from_equation(text, constants, (size_t)count, &surface, &error);
    PyEval_RestoreThread(own);
    PyMem_Free(constants);
    if (status == ALGSURF_OK) return capsule_of(surface);
    return Py_BuildValue("(innz)", (int)status, (Py_ssize_t)error.offset, (Py_ssize_t)error.length,
                         error.message);
}

/* surface_from_terms(terms): an algsurf_term each */
static PyObject *surface_from_terms(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    algsurf_surface *surface = NULL;
    if (!take(args, n, "r", &t)) return NULL;
    const size_t count = (size_t)t.buffer[0].len / sizeof(algsurf_term);
    const algsurf_status status = algsurf_surface_from_terms(t.buffer[0].buf, count, &surface);
    return give_back(&t, status == ALGSURF_OK ? capsule_of(surface) : refuse(status));
}

/* surface_about(surface): (degree, rounding, the bytes of an algsurf_term each) */
static PyObject *surface_about(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    if (!take(args, n, "s", &t)) return NULL;
    const size_t size = algsurf_surface_term_count(t.surface) * sizeof(algsurf_term);
    PyObject *bytes = PyByteArray_FromStringAndSize(NULL, (Py_ssize_t)size);
    if (!bytes) return NULL;
    memset(PyByteArray_AsString(bytes), 0, size); /* what lies between members, too */
    (void)algsurf_surface_terms(t.surface, (algsurf_term *)(void *)PyByteArray_AsString(bytes));
    return Py_BuildValue("(idN)", algsurf_surface_degree(t.surface), algsurf_surface_rounding(t.surface),
                         bytes);
}

/* surface_value(surface, points, value, bound), surface_value(surface, points, gradient): points of three
 * numbers; None, or (index, status) of the first that is refused */
static PyObject *surface_value(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    int status = ALGSURF_OK;
    const int gradient = n == 3;
    if (!take(args, n, gradient ? "srw" : "srww", &t)) return NULL;
    const double *point = t.buffer[0].buf;
    double *out = t.buffer[1].buf, *bound = gradient ? NULL : t.buffer[2].buf, value;
    const Py_ssize_t points = t.buffer[0].len / (Py_ssize_t)(3 * sizeof *point);
    Py_ssize_t i = 0;
    if (!holds(&t, 1, points, (gradient ? 3 : 1) * sizeof *out) ||
        (bound && !holds(&t, 2, points, sizeof *bound)))
        return give_back(&t, NULL);
    PyThreadState *own = PyEval_SaveThread();
    for (; i < points && status == ALGSURF_OK; i++)
        status = gradient
                     ? algsurf_surface_gradient(t.surface, point + 3 * i, &value, out + 3 * i, NULL, NULL)
                     : algsurf_surface_value(t.surface, point + 3 * i, out + i, bound + i);
    PyEval_RestoreThread(own);
    return give_back(&t, refused_at(i - 1, status));
}

/* surface_enclose(surface, extent, part, precision): None, or the box's six numbers */
static PyObject *surface_enclose(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    int empty = 0, status;
    double lo[3], hi[3];
    if (!take(args, n, "seid", &t)) return NULL;
    PyThreadState *own = PyEval_SaveThread();
    status = algsurf_surface_enclose(t.surface, t.space, (algsurf_part)t.whole[0], t.real[0], lo, hi, &empty);
    PyEval_RestoreThread(own);
    if (status < 0) return refuse(status);
    if (empty) Py_RETURN_NONE;
    return Py_BuildValue("(dddddd)", lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]);
}

/* ---- rays ---- */

/* Rays begin..end-1 of arrays that hold more of them: origins, directions, t_min and t_max, which may be
 * empty. */
static int rays_of(const taken *t, algsurf_ray_packet *rays) {
    const doubles *o = &t->table[0], *d = &t->table[1];
    const Py_ssize_t begin = t->whole[0], end = t->whole[1];
    const ptrdiff_t step = o->rows > 1 ? o->row : 1; /* of one ray it may be anything */
    const double *ends[2] = {NULL, NULL};
    if (o->columns != 3 || d->columns != 3 || step < 1 || o->rows != d->rows ||
        (o->rows > 1 && o->row != d->row) || begin < 0 || begin > end || end > o->rows) {
        PyErr_SetString(PyExc_ValueError, "origins and directions of another layout were expected");
        return 0;
    }
    for (int i = 0; i < 2; i++) {
        if (t->buffer[2 + i].len == 0) continue;
        if (!holds(t, 2 + i, end > 0 ? (end - 1) * step + 1 : 0, sizeof(double))) return 0;
        ends[i] = (const double *)t->buffer[2 + i].buf + begin * step;
    }
    *rays = (algsurf_ray_packet){.size = sizeof *rays,
                                 .count = (size_t)(end - begin),
                                 .step = step,
                                 .t_min = ends[0],
                                 .t_max = ends[1]};
    for (int k = 0; k < 3; k++) {
        rays->origin[k] = o->at + begin * step + k * o->column;
        rays->direction[k] = d->at + begin * step + k * d->column;
    }
    return 1;
}

/* Where the answers go, from ray `begin` on; position and normal are three rows, each as long as the other
 * arrays. */
static int answers_of(const taken *t, algsurf_hit_packet *hits) {
    enum { STATE = 4, T, T_LO, T_HI, POSITION, NORMAL, MULTIPLICITY, SIDE, END };
    static const size_t size[END] = {[STATE] = 1,
                                     [T] = 8,
                                     [T_LO] = 8,
                                     [T_HI] = 8,
                                     [POSITION] = 24,
                                     [NORMAL] = 24,
                                     [MULTIPLICITY] = sizeof(int),
                                     [SIDE] = 1};
    const Py_ssize_t begin = t->whole[0], rays = t->table[0].rows;
    for (int i = STATE; i < t->buffers; i++)
        if (!holds(t, i, rays, size[i])) return 0;
    *hits =
        (algsurf_hit_packet){.size = sizeof *hits, .state = (unsigned char *)t->buffer[STATE].buf + begin};
    if (t->buffers < END) return 1;
    hits->t = (double *)t->buffer[T].buf + begin;
    hits->t_lo = (double *)t->buffer[T_LO].buf + begin;
    hits->t_hi = (double *)t->buffer[T_HI].buf + begin;
    hits->multiplicity = (int *)t->buffer[MULTIPLICITY].buf + begin;
    hits->side = (signed char *)t->buffer[SIDE].buf + begin;
    for (int k = 0; k < 3; k++) {
        hits->position[k] = (double *)t->buffer[POSITION].buf + k * rays + begin;
        hits->normal[k] = (double *)t->buffer[NORMAL].buf + k * rays + begin;
    }
    return 1;
}

/* surface_rays(surface, extent, begin, end, origins, directions, t_min, t_max, state): occluded or not;
 * (..., state, t, t_lo, t_hi, position, normal, multiplicity, side): first hits.
 * None, or (index from begin on, status) of the first ray that is refused, or for which memory was short. */
static PyObject *surface_rays(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    algsurf_ray_packet rays;
    algsurf_hit_packet hits;
    int status;
    if (!take(args, n, n == 9 ? "seiittrrw" : "seiittrrwwwwwwww", &t)) return NULL;
    if (!rays_of(&t, &rays) || !answers_of(&t, &hits)) return give_back(&t, NULL);
    PyThreadState *own = PyEval_SaveThread();
    status = n == 9 ? algsurf_occluded_packet(t.surface, t.space, &rays, NULL, hits.state)
                    : algsurf_intersect_packet(t.surface, t.space, &rays, NULL, &hits);
    PyEval_RestoreThread(own);
    const int sign = status == ALGSURF_E_NO_MEMORY ? ALGSURF_STATE_UNDECIDED : ALGSURF_STATE_REFUSED;
    size_t at = 0;
    while (status != ALGSURF_OK && at + 1 < rays.count && hits.state[at] != sign) at++;
    return give_back(&t, refused_at((Py_ssize_t)at, status));
}

PyMethodDef surface_methods[] = {{"surface_from_equation", surface_from_equation, METH_VARARGS, NULL},
                                 METHOD(surface_from_terms),
                                 METHOD(surface_about),
                                 METHOD(surface_value),
                                 METHOD(surface_enclose),
                                 METHOD(surface_rays),
                                 METHODS_END};
