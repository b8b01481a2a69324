/* portable.h - what POSIX and Windows do differently, for the programs here; everything else is C11, or POSIX
 * that mingw-w64 has too. */
#ifndef PORTABLE_H
#define PORTABLE_H
#include <stdio.h>

/* From here on, the bytes written to standard output are those that the program gave: Windows' text mode
 * would end lines by CR LF, and cut pictures. */
void portable_binary_output(void);

/* What is at a path; a link is "other", wherever it leads. */
typedef enum portable_kind { PORTABLE_NOTHING, PORTABLE_FILE, PORTABLE_FOLDER, PORTABLE_OTHER } portable_kind;
portable_kind portable_kind_of(const char *path);
portable_kind portable_kind_behind(const char *path); /* links are followed; nothing: they lead nowhere */

/* The path that a link leads to in the end, to be freed; null with errno set, or where there are no links. */
char *portable_path_behind(const char *path);

/* Do two paths name the same file, be it there or not?  On Windows: the same text. */
int portable_is_same(const char *a, const char *b);

/* How many characters of a path name its folder, with the separator at their end; 0: there is none. */
int portable_folder_length(const char *path);

/* These return 0, or -1 with errno set. */
int portable_rename(const char *from, const char *to); /* replaces a file that is there */
int portable_make_folder(const char *path);

/* A file for writing that was not there before, with the permissions of the file at `like` if there is one;
 * null with errno set, EEXIST where there was one. */
FILE *portable_create(const char *path, const char *like);

/* From now on the file is removed, if its name is still that, when the program ends or a signal ends it (an
 * interruption at the keyboard, a request to end, a limit that is reached); until it is forgotten.  The name must live as long.  At
 * most 8 files. Not on Windows, which removes no open file. */
void portable_remember(const char *path);
void portable_forget(const char *path);

/* How many processors the system has for threads. */
long portable_processors(void);

#endif
