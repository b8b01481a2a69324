/* portable.c - see portable.h. */
#define _XOPEN_SOURCE 700 /* POSIX, and realpath */
#define _DARWIN_C_SOURCE  /* POSIX alone hides _SC_NPROCESSORS_ONLN there */
#include "portable.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
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

/* ---- links, signals, modes: neither on Windows nor on WebAssembly ---- */

#if defined(_WIN32) || defined(__wasi__)
char *portable_path_behind(const char *path) {
    (void)path;
    errno = ENOSYS;
    return NULL;
}

static void set_mode(int descriptor, mode_t mode) {
    (void)descriptor;
    (void)mode;
}

void portable_remember(const char *path) { (void)path; }
void portable_forget(const char *path) { (void)path; }
#else
#include <signal.h>

char *portable_path_behind(const char *path) { return realpath(path, NULL); }

static void set_mode(int descriptor, mode_t mode) { (void)fchmod(descriptor, mode); }

enum { MOST_FILES = 8 };
static const char *volatile remembered[MOST_FILES];

/* Only calls that a handler may make. */
static void remove_remembered(void) {
    for (int i = 0; i < MOST_FILES; i++) {
        const char *path = remembered[i];
        if (path) (void)unlink(path);
    }
}

/* The signal is raised again, and ends the program as it would have. */
static void end_by(int number) {
    remove_remembered();
    (void)raise(number);
}

/* What is ignored, as under nohup, stays ignored. */
static void catch_signals(void) {
    static const int numbers[] = {SIGINT,  SIGTERM, SIGHUP,  SIGPIPE, SIGQUIT,
                                  SIGALRM, SIGXCPU, SIGXFSZ, SIGUSR1, SIGUSR2};
    static int done;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers && !done; i++) {
        struct sigaction action, before;
        memset(&action, 0, sizeof action);
        action.sa_handler = end_by;
        action.sa_flags = (int)SA_RESETHAND;
        if (sigaction(numbers[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
            (void)sigaction(numbers[i], &action, NULL);
    }
    if (!done) (void)atexit(remove_remembered);
    done = 1;
}

void portable_remember(const char *path) {
    catch_signals();
    for (int i = 0; i < MOST_FILES; i++) {
        if (remembered[i]) continue;
        remembered[i] = path;
        return;
    }
}

void portable_forget(const char *path) {
    for (int i = 0; i < MOST_FILES; i++)
        if (remembered[i] == path) remembered[i] = NULL;
}
#endif

static portable_kind kind_of(const struct stat *s) {
    return S_ISREG(s->st_mode) ? PORTABLE_FILE : S_ISDIR(s->st_mode) ? PORTABLE_FOLDER : PORTABLE_OTHER;
}

portable_kind portable_kind_of(const char *path) {
    struct stat s;
    return about(path, &s) != 0 ? PORTABLE_NOTHING : kind_of(&s);
}

portable_kind portable_kind_behind(const char *path) {
    struct stat s;
    return stat(path, &s) != 0 ? PORTABLE_NOTHING : kind_of(&s);
}

int portable_folder_length(const char *path) {
    int length = (int)strlen(path);
    while (length > 0 && !is_separator(path[length - 1])) length--;
    return length;
}

#if defined(_WIN32)
int portable_is_same(const char *a, const char *b) { return strcmp(a, b) == 0; }
#else
/* Of the folder that holds what is at a path. */
static int about_folder(const char *path, struct stat *s) {
    char name[4096] = ".";
    int length = portable_folder_length(path);
    if ((size_t)length >= sizeof name) return -1;
    if (length > 0) memcpy(name, path, (size_t)length), name[length] = 0;
    return stat(name, s);
}

int portable_is_same(const char *a, const char *b) {
    struct stat s, t;
    int a_is_there = stat(a, &s) == 0, b_is_there = stat(b, &t) == 0;
    if (strcmp(a, b) == 0) return 1;
    if (a_is_there != b_is_there) return 0;
    if (!a_is_there && (about_folder(a, &s) != 0 || about_folder(b, &t) != 0 ||
                        strcmp(a + portable_folder_length(a), b + portable_folder_length(b)) != 0))
        return 0;
    return s.st_dev == t.st_dev && s.st_ino == t.st_ino;
}
#endif

FILE *portable_create(const char *path, const char *like) {
    struct stat s;
    int known = stat(like, &s) == 0 && S_ISREG(s.st_mode);
    mode_t mode = known ? s.st_mode & 0777 : 0666; /* as fopen creates */
    int descriptor = open(path, O_WRONLY | O_CREAT | O_EXCL | O_BINARY, mode);
    if (descriptor < 0) return NULL;
    if (known) set_mode(descriptor, mode);
    FILE *file = fdopen(descriptor, "wb");
    if (!file) (void)close(descriptor);
    return file;
}
