/* accuracy_pictures.h - what a picture's tier costs and gives, by resolution and distance of the camera. */
#ifndef ACCURACY_PICTURES_H
#define ACCURACY_PICTURES_H
#include "accuracy_report.h"

enum { SIZES = 6 };

/* A size of picture from a distance, in radii of the extent. */
typedef struct picture_size {
    int width, height;
    double distance;
} picture_size;

/* One tier's picture. */
typedef struct picture_line {
    double ns[MAX_REPEAT]; /* CPU time a pixel, sorted at the end */
} picture_line;

typedef struct picture_record {
    const catalogue_entry *entry;
    int repeat, sizes;
    picture_size size[SIZES];
    picture_line line[SIZES][TIERS];
} picture_record;

/* Draws the surface, fewer sizes if quick.  Ends the program when that cannot be had, and when the bounded
 * tier shows something else than the certified one where it decides. */
void pictures_run(const catalogue_entry *entry, int quick, int repeat, picture_record *r);

void pictures_table(const picture_record *r);

/* accuracy_pictures.csv and accuracy_pictures.svg of all. */
void pictures_files(const picture_record *records, int count, const char *folder);

#endif
