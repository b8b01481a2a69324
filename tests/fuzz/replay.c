/* replay.c - runs a fuzz target on files, without libFuzzer: the corpus as a test, or one finding.
 *
 *     fuzz_NAME FILE_OR_FOLDER...
 *
 * The target ends the process when something is wrong, so each file of a folder is run in a process of its
 * own, and those that fail are named; a single file is run in this one.  Nothing to run is an error.
 */
#include <dirent.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fuzz.h"

static int runs, failures;

static void run_file(const char *path) {
    FILE *file = fopen(path, "rb");
    size_t size = 0, room = 1 << 16;
    uint8_t *data = malloc(room);
    fuzz_check(data);
    if (!file) {
        perror(path);
        exit(2);
    }
    for (size_t got; (got = fread(data + size, 1, room - size, file)) > 0;) {
        size += got;
        if (size < room) continue;
        data = realloc(data, room *= 2);
        fuzz_check(data);
    }
    fclose(file);
    uint8_t *exact = malloc(size ? size : 1); /* so that a sanitizer sees the end */
    fuzz_check(exact);
    memcpy(exact, data, size);
    free(data);
    (void)LLVMFuzzerTestOneInput(exact, size);
    free(exact);
    runs++;
}

static void run_apart(const char *path) {
    int status = 0;
    pid_t child = fork();
    fuzz_check(child >= 0);
    if (child == 0) {
        run_file(path);
        exit(0);
    }
    fuzz_check(waitpid(child, &status, 0) == child);
    runs++;
    if (status == 0) return;
    failures++;
    fprintf(stderr, "FAILED: %s\n", path);
}

static void run_folder(DIR *folder, const char *path) {
    for (struct dirent *entry; (entry = readdir(folder));) {
        char name[4096];
        if (entry->d_name[0] == '.') continue;
        snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
        run_apart(name);
    }
    closedir(folder);
}

int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        DIR *folder = opendir(argv[i]);
        if (folder)
            run_folder(folder, argv[i]);
        else
            run_file(argv[i]);
    }
    printf("%d inputs, %d failed\n", runs, failures);
    if (runs == 0) return 2;
    return failures > 0;
}
