/* baseline.h - packets of two, of four floats if the includer defines SINGLE: what every 64-bit x86 (SSE2)
 * and ARM (NEON) processor has; to be included before a template. */
#include "unrolled.h"
#if defined(SINGLE)
#define LANES 4
#else
#define LANES 2
#endif
#define KERNEL(name) name##_baseline
