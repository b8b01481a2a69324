/* module.h - what the files of the extension module _algsurf share.
 *
 * The module is private to the package: its functions check what could make C fail, and no more; the Python
 * files beside it check what users say.  Arrays come by the buffer protocol, so that numpy's headers are not
 * needed. */
#ifndef ALGSURF_PYTHON_MODULE_H
#define ALGSURF_PYTHON_MODULE_H
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <string.h>
#include <time.h>

#include "algsurf/algsurf.h"

#define METHOD(function)                                                                                     \
    { #function, (PyCFunction)(void (*)(void))(function), METH_FASTCALL, NULL }
#define METHODS_END                                                                                          \
    { NULL, NULL, 0, NULL }

/* The methods of each file. */
extern PyMethodDef roots_methods[], batch_methods[], surface_methods[], picture_methods[], mesh_methods[];

/* Raises what the status means, with the library's words, and returns null. */
PyObject *refuse(int status);

/* Doubles with two axes, in any layout with whole steps. */
typedef struct doubles {
    const double *at;
    Py_ssize_t rows, columns;
    ptrdiff_t row, column; /* steps, in doubles */
} doubles;

/* Arguments as they are read; what there is not of a kind is not set. */
enum { MOST_BUFFERS = 12 };
typedef struct taken {
    algsurf_surface *surface;
    algsurf_extent extent;
    const algsurf_extent *space;    /* &extent, or null for all of space */
    Py_buffer buffer[MOST_BUFFERS]; /* tables among them */
    doubles table[2];
    Py_ssize_t whole[4];
    double real[2];
    int buffers;
} taken;

/* Reads arguments, one for each letter: s surface, e extent or None, t table of doubles, r and w array to
 * read or to write, in one piece; i whole number, d real number.  0: an error is raised, and nothing is held.
 */
int take(PyObject *const *args, Py_ssize_t count, const char *letters, taken *t);

/* Gives the buffers back, and returns the answer. */
PyObject *give_back(taken *t, PyObject *answer);

/* Has buffer i room for so many items of that size?  0: an error is raised. */
int holds(const taken *t, int i, Py_ssize_t count, size_t size);

/* A surface in a capsule, which owns it. */
PyObject *capsule_of(algsurf_surface *surface);

/* Asks ten times a second whether the user has pressed Ctrl-C, while other threads run. */
typedef struct patience {
    PyThreadState *thread; /* as PyEval_SaveThread gave it */
    struct timespec last;
} patience;

/* For what takes long: 1 if so, with the error raised; data is a patience. */
int is_interrupted(int done, int total, void *data);

/* None if status is OK, else (index, status): what was refused first. */
PyObject *refused_at(Py_ssize_t index, int status);

#endif
