/* module.c - see module.h. */
#include "module.h"

#include <math.h>

static const char NAME[] = "algsurf_surface";

PyObject *refuse(int status) {
    PyObject *kind = status == ALGSURF_E_NO_MEMORY ? PyExc_MemoryError
                     : status == ALGSURF_E_RANGE   ? PyExc_OverflowError
                                                   : PyExc_ValueError;
    PyErr_SetString(kind, algsurf_status_text((algsurf_status)status));
    return NULL;
}

PyObject *refused_at(Py_ssize_t index, int status) {
    if (status == ALGSURF_OK) Py_RETURN_NONE;
    return Py_BuildValue("(ni)", index, status);
}

static void free_surface(PyObject *capsule) { algsurf_surface_free(PyCapsule_GetPointer(capsule, NAME)); }

PyObject *capsule_of(algsurf_surface *surface) {
    PyObject *capsule = PyCapsule_New(surface, NAME, free_surface);
    if (!capsule) algsurf_surface_free(surface);
    return capsule;
}

/* ---- arguments ---- */

/* (kind, (x, y, z), (a, b, c)), or None */
static int take_extent(PyObject *object, taken *t) {
    algsurf_extent *e = &t->extent;
    double *c = e->centre, *s = e->size;
    t->space = object == Py_None ? NULL : e;
    return !t->space ||
           PyArg_ParseTuple(object, "i(ddd)(ddd)", &e->kind, &c[0], &c[1], &c[2], &s[0], &s[1], &s[2]);
}

static int take_buffer(PyObject *object, taken *t, int flags) {
    if (PyObject_GetBuffer(object, &t->buffer[t->buffers], flags) != 0) return 0;
    t->buffers++;
    return 1;
}

static int take_table(PyObject *object, taken *t, doubles *d) {
    const Py_ssize_t size = sizeof(double);
    if (!take_buffer(object, t, PyBUF_STRIDED_RO | PyBUF_FORMAT)) return 0;
    const Py_buffer *v = &t->buffer[t->buffers - 1];
    const int fits = v->ndim == 2 && v->itemsize == size && v->format && strcmp(v->format, "d") == 0 &&
                     v->strides[0] % size == 0 && v->strides[1] % size == 0;
    if (fits) *d = (doubles){v->buf, v->shape[0], v->shape[1], v->strides[0] / size, v->strides[1] / size};
    if (!fits) PyErr_SetString(PyExc_ValueError, "an array of doubles with two axes was expected");
    return fits;
}

int take(PyObject *const *args, Py_ssize_t count, const char *letters, taken *t) {
    int tables = 0, wholes = 0, reals = 0, good = count == (Py_ssize_t)strlen(letters);
    t->buffers = 0;
    if (!good) PyErr_SetString(PyExc_TypeError, "another number of arguments was expected");
    for (; good && *letters; letters++, args++) {
        switch (*letters) {
        case 's':
            good = (t->surface = PyCapsule_GetPointer(*args, NAME)) != NULL;
            break;
        case 'e':
            good = take_extent(*args, t);
            break;
        case 't':
            good = take_table(*args, t, &t->table[tables++]);
            break;
        case 'r':
            good = take_buffer(*args, t, PyBUF_SIMPLE);
            break;
        case 'w':
            good = take_buffer(*args, t, PyBUF_WRITABLE);
            break;
        case 'i':
            good = (t->whole[wholes++] = PyLong_AsSsize_t(*args)) != -1 || !PyErr_Occurred();
            break;
        default:
            good = (t->real[reals++] = PyFloat_AsDouble(*args)) != -1 || !PyErr_Occurred();
        }
    }
    if (!good) give_back(t, NULL);
    return good;
}

PyObject *give_back(taken *t, PyObject *answer) {
    while (t->buffers > 0) PyBuffer_Release(&t->buffer[--t->buffers]);
    return answer;
}

int holds(const taken *t, int i, Py_ssize_t count, size_t size) {
    if (count >= 0 && (size_t)t->buffer[i].len / size >= (size_t)count) return 1;
    PyErr_SetString(PyExc_ValueError, "an array is too short");
    return 0;
}

int is_interrupted(int done, int total, void *data) {
    patience *p = data;
    struct timespec now;
    (void)done, (void)total;
    (void)timespec_get(&now, TIME_UTC);
    if (fabs((double)(now.tv_sec - p->last.tv_sec) + 1e-9 * (double)(now.tv_nsec - p->last.tv_nsec)) < 0.1)
        return 0;
    p->last = now;
    PyEval_RestoreThread(p->thread);
    const int stop = PyErr_CheckSignals() != 0;
    p->thread = PyEval_SaveThread();
    return stop;
}

/* ---- the module ---- */

static PyObject *status_refuse(PyObject *module, PyObject *number) {
    (void)module;
    const long status = PyLong_AsLong(number);
    return status == -1 && PyErr_Occurred() ? NULL : refuse((int)status);
}

static PyObject *version(PyObject *module, PyObject *none) {
    (void)module, (void)none;
    return PyUnicode_FromString(algsurf_version());
}

static PyMethodDef methods[] = {
    {"refuse", status_refuse, METH_O, NULL}, {"version", version, METH_NOARGS, NULL}, METHODS_END};

static int add_all(PyObject *module) {
    PyMethodDef *const all[] = {roots_methods, batch_methods, surface_methods, picture_methods, mesh_methods};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (PyModule_AddFunctions(module, all[i]) != 0) return -1;
    return 0;
}

static int (*const exec)(PyObject *) = add_all;
static PyModuleDef_Slot slots[] = {{Py_mod_exec, NULL}, {0, NULL}};
static struct PyModuleDef definition = {.m_base = PyModuleDef_HEAD_INIT,
                                        .m_name = "_algsurf",
                                        .m_doc = "libalgsurf as the package algsurf calls it.",
                                        .m_methods = methods,
                                        .m_slots = slots};

PyMODINIT_FUNC PyInit__algsurf(void) {
    memcpy(&slots[0].value, &exec, sizeof exec); /* ISO C has no cast from a function's address */
    return PyModuleDef_Init(&definition);
}
