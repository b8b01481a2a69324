/* portable.c - see portable.h. */
#define _POSIX_C_SOURCE 200809L
#define _DARWIN_C_SOURCE /* POSIX alone hides _SC_NPROCESSORS_ONLN there */
#include "portable.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#include <direct.h>
#include <io.h>
#include <windows.h>

void portable_binary_output(void) { (void)_setmode(_fileno(stdout), _O_BINARY); }

static int is_separator(char c) { return c == '/' || c == '\\' || c == ':'; }

static int about(const char *path, struct stat *s) { return stat(path, s); }

int portable_rename(const char *from, const char *to) {
    if (MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING)) return 0;
    errno = EACCES;
    return -1;
}

int portable_make_folder(const char *path) { return _mkdir(path); }

long portable_processors(void) {
    SYSTEM_INFO system;
    GetSystemInfo(&system);
    return (long)system.dwNumberOfProcessors;
}
#else
#define O_BINARY 0

void portable_binary_output(void) {}

static int is_separator(char c) { return c == '/'; }

static int about(const char *path, struct stat *s) { return lstat(path, s); }

int portable_rename(const char *from, const char *to) { return rename(from, to); }

int portable_make_folder(const char *path) { return mkdir(path, 0777); }

long portable_processors(void) {
#if defined(_SC_NPROCESSORS_ONLN)
    return sysconf(_SC_NPROCESSORS_ONLN);
#else
    return 1;
#endif
}
#endif

portable_kind portable_kind_of(const char *path) {
    struct stat s;
    if (about(path, &s) != 0) return PORTABLE_NOTHING;
    return S_ISREG(s.st_mode) ? PORTABLE_FILE : S_ISDIR(s.st_mode) ? PORTABLE_FOLDER : PORTABLE_OTHER;
}

int portable_folder_length(const char *path) {
    int length = (int)strlen(path);
    while (length > 0 && !is_separator(path[length - 1])) length--;
    return length;
}

FILE *portable_create(const char *path) {
    int descriptor = open(path, O_WRONLY | O_CREAT | O_EXCL | O_BINARY, 0666); /* as fopen creates */
    if (descriptor < 0) return NULL;
    FILE *file = fdopen(descriptor, "wb");
    if (!file) (void)close(descriptor);
    return file;
}
