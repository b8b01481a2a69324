/* interval_public.h - a public operation: the standard environment around a function that is not inlined. */
#ifndef ALGSURF_INTERVAL_PUBLIC_H
#define ALGSURF_INTERVAL_PUBLIC_H
#include "../base/fpenv.h"

/* Defines algsurf_<name>(parameters), which returns work(arguments). */
#define ALGSURF_I_PUBLIC(type, name, work, parameters, arguments)                                            \
    static ALGSURF_NOINLINE type bracketed_##name parameters { return work arguments; }                      \
    type algsurf_##name parameters {                                                                         \
        algsurf_fpenv saved;                                                                                 \
        algsurf_fpenv_enter(&saved);                                                                         \
        type result_in_standard_environment = bracketed_##name arguments;                                    \
        algsurf_fpenv_leave(&saved);                                                                         \
        return result_in_standard_environment;                                                               \
    }

#endif
