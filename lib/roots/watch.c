/* watch.c - counts and callbacks of an observer. */
#include "../base/arithmetic.h"
#include "watch.h"

#include <float.h>
#include <math.h>

#include "../base/elementary.h"
#include "../base/options.h"

algsurf_status algsurf_i_observer_check(const algsurf_observer *observer) {
    algsurf_observer known;
    return observer ? algsurf_options_read(&known, sizeof known, observer) : ALGSURF_OK;
}

double algsurf_i_watched_place(const algsurf_i_watch *watch, double place) {
    return place >= 1 ? watch->hi : watch->lo + (watch->hi - watch->lo) * place;
}

int algsurf_i_most_variations(const signed char *signs, int degree) {
    int count = 0, last = 0, first = 0; /* first: undecided signs before one that is known */
    for (int j = 0; j <= degree; j++) {
        int sign = signs[j];
        if (sign == 0) continue;
        if (sign == ALGSURF_SIGN_UNDECIDED && last == 0) {
            first++;
            continue;
        }
        if (sign == ALGSURF_SIGN_UNDECIDED) sign = -last;
        count += last != 0 && sign != last;
        last = sign;
    }
    return last == 0 && first > 0 ? first - 1 : count + first;
}

static double in_caller_unit(const algsurf_i_watch *watch, double y) {
    return watch->power > 1 ? copysign(algsurf_i_pow(fabs(y), 1.0 / watch->power), y) : y;
}

static void note_engine(algsurf_observer *observer, int engine) {
    if (engine > observer->engine) observer->engine = engine;
}

void algsurf_i_tell_cell(const algsurf_i_watch *watch, const algsurf_cell *cell) {
    algsurf_observer *o = watch->observer;
    algsurf_cell told = *cell;
    told.lo = in_caller_unit(watch, cell->lo);
    told.hi = in_caller_unit(watch, cell->hi);
    o->cells++;
    note_engine(o, cell->engine);
    if (o->on_cell) o->on_cell(&told, o->data);
}

void algsurf_i_tell_point(const algsurf_i_watch *watch, double t, double value, int exponent, int engine) {
    algsurf_observer *o = watch->observer;
    double told = ldexp(value, exponent + watch->exponent);
    o->evaluations++;
    note_engine(o, engine);
    if (told == 0 && value != 0) told = copysign(DBL_TRUE_MIN, value);
    if (o->on_point) o->on_point(in_caller_unit(watch, t), told, engine, o->data);
}
