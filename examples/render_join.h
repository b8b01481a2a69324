/* render_join.h - render --join: the slices of a picture (--rows), drawn anywhere, become the picture.
 *
 * The slices are PPM files that tell what they are slices of (render_slice.h).  Together they must be the
 * whole picture, each row once, all of the same job: then what is written is, byte by byte, what one run
 * would have written.  Otherwise one line on standard error tells what is missing, twice there or foreign;
 * status 2.
 */
#ifndef RENDER_JOIN_H
#define RENDER_JOIN_H

/* The command line from "--join" on.  Returns the status of the program, or ends it. */
int render_join(int argc, char **argv);

#endif
