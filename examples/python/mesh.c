/* mesh.c - triangles, as the program mesh makes them. */
#include "fit_extent.h"
#include "mesh_make.h"
#include "mesh_threads.h"
#include "module.h"

static int make(const taken *t, const mesh_options *options, mesh *made) {
    algsurf_extent extent = t->extent;
    algsurf_status failed = ALGSURF_OK;
    int bounded;
    memset(made, 0, sizeof *made);
    if (!t->space) extent = fit_extent(t->surface, &bounded, &failed);
    return failed == ALGSURF_OK ? (int)mesh_make(t->surface, &extent, options, made) : (int)failed;
}

static PyObject *bytes_of(const void *at, size_t count, size_t size) {
    return PyByteArray_FromStringAndSize(at, (Py_ssize_t)(count * size));
}

/* make_mesh(surface, extent, cells, solid, on_surface, threads): points, normals, triangles, and how many
 * places there are of each kind of doubt. */
static PyObject *make_mesh(PyObject *module, PyObject *const *args, Py_ssize_t n) {
    (void)module;
    taken t;
    mesh made;
    patience waiting = {NULL, {0, 0}};
    if (!take(args, n, "seiiii", &t)) return NULL;
    int threads = (int)t.whole[3];
    const mesh_options options = {.cells = (int)t.whole[0],
                                  .solid = t.whole[1] != 0,
                                  .on_surface = t.whole[2] != 0,
                                  .run = mesh_threads_run,
                                  .run_data = &threads,
                                  .progress = is_interrupted,
                                  .progress_data = &waiting};
    waiting.thread = PyEval_SaveThread();
    const int status = make(&t, &options, &made);
    PyEval_RestoreThread(waiting.thread);
    PyObject *answer = NULL;
    if (!PyErr_Occurred() && status == ALGSURF_OK)
        answer = Py_BuildValue(
            "NNNnnnn", bytes_of(made.at, made.points, sizeof *made.at),
            bytes_of(made.normal, made.points, sizeof *made.normal),
            bytes_of(made.corner, made.triangles, sizeof *made.corner),
            (Py_ssize_t)made.doubts[MESH_CROWDED].count, (Py_ssize_t)made.doubts[MESH_TOUCHED].count,
            (Py_ssize_t)made.doubts[MESH_UNDECIDED].count, (Py_ssize_t)made.doubts[MESH_SHARP].count);
    else if (!PyErr_Occurred())
        refuse(status);
    mesh_free(&made);
    return answer;
}

PyMethodDef mesh_methods[] = {METHOD(make_mesh), METHODS_END};
