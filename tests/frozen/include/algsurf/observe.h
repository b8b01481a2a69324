#ifndef ALGSURF_OBSERVE_H
#define ALGSURF_OBSERVE_H
#include <stddef.h>
#include "algsurf/status.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef enum algsurf_engine {
    ALGSURF_ENGINE_NONE = 0,
    ALGSURF_ENGINE_DOUBLES = 1,
    ALGSURF_ENGINE_INTEGERS = 2
} algsurf_engine;
typedef enum algsurf_sign {
    ALGSURF_SIGN_NEGATIVE = -1,
    ALGSURF_SIGN_ZERO = 0,
    ALGSURF_SIGN_POSITIVE = 1,
    ALGSURF_SIGN_UNDECIDED = 2
} algsurf_sign;
typedef struct algsurf_cell {
    double lo, hi;
    int variations;
    int engine;
    int degree;
    const signed char *signs;
} algsurf_cell;
typedef void (*algsurf_cell_observer)(const algsurf_cell *cell, void *data);
typedef void (*algsurf_point_observer)(double t, double value, int engine, void *data);
typedef struct algsurf_observer {
    size_t size;
    algsurf_cell_observer on_cell;
    algsurf_point_observer on_point;
    void *data;
    size_t cells;
    size_t evaluations;
    int engine;
} algsurf_observer;
#ifdef __cplusplus
}
#endif
#endif
