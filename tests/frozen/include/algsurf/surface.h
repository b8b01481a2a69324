#ifndef ALGSURF_SURFACE_H
#define ALGSURF_SURFACE_H
#include <stddef.h>
#include "algsurf/status.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_surface algsurf_surface;
typedef struct algsurf_term {
    int i, j, k;
    double a;
} algsurf_term;
typedef struct algsurf_constant {
    const char *name;
    double value;
} algsurf_constant;
typedef struct algsurf_parse_error {
    size_t offset;
    size_t length;
    const char *message;
} algsurf_parse_error;
ALGSURF_API algsurf_status algsurf_surface_from_terms(const algsurf_term *terms, size_t count,
                                                      algsurf_surface **surface);
ALGSURF_API algsurf_status algsurf_surface_from_equation(const char *text, const algsurf_constant *constants,
                                                         size_t count, algsurf_surface **surface,
                                                         algsurf_parse_error *error);
ALGSURF_API double algsurf_surface_rounding(const algsurf_surface *surface);
ALGSURF_API algsurf_status algsurf_surface_with_error(const algsurf_surface *surface, double error,
                                                      algsurf_surface **approximate);
ALGSURF_API void algsurf_surface_free(algsurf_surface *surface);
ALGSURF_API int algsurf_surface_degree(const algsurf_surface *surface);
ALGSURF_API size_t algsurf_surface_term_count(const algsurf_surface *surface);
ALGSURF_API algsurf_status algsurf_surface_terms(const algsurf_surface *surface, algsurf_term *terms);
ALGSURF_API algsurf_status algsurf_surface_value(const algsurf_surface *surface, const double point[3],
                                                 double *value, double *bound);
ALGSURF_API algsurf_status algsurf_surface_gradient(const algsurf_surface *surface, const double point[3],
                                                    double *value, double gradient[3], double *value_bound,
                                                    double gradient_bound[3]);
#ifdef __cplusplus
}
#endif
#endif
