/* extremes_impl.h - the makers of scenes, and what they share. */
#ifndef EXTREMES_IMPL_H
#define EXTREMES_IMPL_H
#include "extremes_cases.h"

/* Each fills surface, extent, rays, and what is known of them; the room for the rays is there.  Returns 0
 * when there is no memory. */
int make_distance(int variant, double value, measure_random *random, scene *s);
int make_scale(int variant, double value, measure_random *random, scene *s);
int make_gap(int variant, double value, measure_random *random, scene *s);
int make_degree(int variant, double value, measure_random *random, scene *s);
int make_singular(int variant, double value, measure_random *random, scene *s);
int make_extent(int variant, double value, measure_random *random, scene *s);
int make_spread(int variant, double value, measure_random *random, scene *s);
int make_leading(int variant, double value, measure_random *random, scene *s);

/* The surface of an equation, its coefficient of x^i y^j z^k times s_0^-i s_1^-j s_2^-k size, rounded:
 * stretched by s_0, s_1, s_2 along the axes. */
int set_equation(scene *s, const char *equation);
int set_stretched(scene *s, const char *equation, const double stretch[3], double size);
int set_terms(scene *s, const algsurf_term *terms, size_t count);

/* Uniform on the unit sphere; in the unit ball. */
void random_direction(measure_random *random, double w[3]);
void random_in_ball(measure_random *random, double x[3]);

/* Ray i starts at the eye, t from 0 on; towards a target, with a direction of unit length, rounded. */
void set_ray(scene *s, size_t i, const double eye[3], const double direction[3]);
void set_look(scene *s, size_t i, const double eye[3], const double target[3]);

#endif
