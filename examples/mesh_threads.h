/* mesh_threads.h - jobs of mesh_make by several threads. */
#ifndef MESH_THREADS_H
#define MESH_THREADS_H

/* A mesh_runner; data is an int: how many threads, 1 or more. */
void mesh_threads_run(void (*job)(int index, void *job_data), int count, void *job_data, void *data);

#endif
