#ifndef ALGSURF_SELECT_H
#define ALGSURF_SELECT_H
#include "algsurf/allroots.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_sector {
    double sigma, delta;
} algsurf_sector;
typedef enum algsurf_selected {
    ALGSURF_SELECTED_NONE = 0,
    ALGSURF_SELECTED_ONE = 1,
    ALGSURF_SELECTED_UNDECIDED = 2
} algsurf_selected;
ALGSURF_API algsurf_status algsurf_sector_holds(const algsurf_sector *sector,
                                                const algsurf_complex_root *root, int *holds);
ALGSURF_API algsurf_status algsurf_select(const algsurf_complex_root *roots, int count,
                                          const algsurf_sector *sector, double lo, double hi, int *selected,
                                          int *index);
ALGSURF_API algsurf_status algsurf_select_of_real(const algsurf_complex_root *roots, int count,
                                                  const algsurf_sector *sector, double lo, double hi,
                                                  int *selected, int *index);
#ifdef __cplusplus
}
#endif
#endif
