/* baseline.h - packets of two: what every 64-bit x86 (SSE2) and ARM (NEON) processor has; to be included
 * before a template. */
#define LANES 2
#define KERNEL(name) name##_baseline
