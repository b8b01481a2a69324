/* options.h - reading a caller's struct that starts with its own size.
 *
 * Such a struct may be older than the library (smaller: what it lacks is 0, the default) or newer
 * (larger: accepted if the part unknown here is all 0, hence asks for defaults).
 */
#ifndef ALGSURF_OPTIONS_H
#define ALGSURF_OPTIONS_H
#include <stddef.h>
#include <string.h>

/* Copies *given, a struct whose first member is its size, into the `known_size` bytes at `known`,
 * whose own size member then is known_size.  Returns 1; 0 when the size is smaller than its own
 * member or the unknown tail is not zero: then `known` is untouched. */
static inline int algsurf_options_read(void *known, size_t known_size, const void *given) {
    size_t size;
    memcpy(&size, given, sizeof size);
    if (size < sizeof size) return 0;
    for (size_t i = known_size; i < size; i++)
        if (((const unsigned char *)given)[i] != 0) return 0;
    memset(known, 0, known_size);
    memcpy(known, given, size < known_size ? size : known_size);
    memcpy(known, &known_size, sizeof known_size);
    return 1;
}

#endif
