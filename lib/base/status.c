/* status.c - texts for status codes, and the version. */
#include "arithmetic.h"
#include "algsurf/status.h"

const char *algsurf_status_text(algsurf_status status) {
    switch (status) {
#define TEXT(name, number, text)                                                                             \
    case name:                                                                                               \
        return text;
        ALGSURF_STATUS_LIST(TEXT)
#undef TEXT
    }
    return "unknown status";
}

const char *algsurf_status_name(algsurf_status status) {
    switch (status) {
#define NAME(name, number, text)                                                                             \
    case name:                                                                                               \
        return #name;
        ALGSURF_STATUS_LIST(NAME)
#undef NAME
    }
    return "unknown";
}

#define STRING_OF(x) #x
#define STRING(x) STRING_OF(x)

const char *algsurf_version(void) {
    return STRING(ALGSURF_VERSION_MAJOR) "." STRING(ALGSURF_VERSION_MINOR) "." STRING(ALGSURF_VERSION_PATCH);
}

int algsurf_version_number(void) { return ALGSURF_VERSION; }
