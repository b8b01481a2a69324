/* peers_pictures.c - pictures by this library, by POV-Ray and by surf, of the same scenes.
 *
 * Time is CPU time of one thread for the picture proper: the call of algsurf_render; POV-Ray's own line on
 * tracing; surf's process less one that has nothing to draw.  This library draws what is thin, as `render`
 * does by default, and once more without it ("thin none"), each after such a picture that is not timed. Which
 * pixels show the surface is compared with the latter, where every hit and every miss is proved.  The
 * programs take turns.
 */
#define _XOPEN_SOURCE 700 /* fork, getrusage */
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "must.h"
#include "peers.h"
#include "results.h"

enum { PIXELS = PEERS_WIDTH * PEERS_HEIGHT };

typedef enum artist { USUAL, THIN_NONE, SURF, SURF_EMPTY, POVRAY, POVRAY_STURM, ARTISTS } artist;

static const char *const artist_name[ARTISTS] = {"algsurf",     "algsurf thin none", "surf-alggeo",
                                                 "surf, empty", "POV-Ray",           "POV-Ray sturm"};

typedef struct studio {
    const peers_programs *programs;
    peers_scene scene;
    uint8_t *pixels;
    double *hits;
    char *shows[ARTISTS]; /* 1 where the surface is seen */
} studio;

/* ---- this library ---- */

static double draw_here(studio *s, artist who) {
    static const double thin_colour[3] = {0.8, 0.5, 0.2};
    const algsurf_render_options options = {
        .size = sizeof options, .width = PEERS_WIDTH, .height = PEERS_HEIGHT, .threads = 1};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = s->pixels, .t = s->hits};
    algsurf_status status = algsurf_scene_set_thin(s->scene.scene, who == USUAL ? thin_colour : NULL);
    double seconds = 0;
    /* Twice: after fork() the first write to a page copies it, and another program has had the caches, for
     * all pictures but the one that follows another of ours. */
    for (int turn = 0; turn < 2 && status == ALGSURF_OK; turn++) {
        double begun = measure_cpu();
        status = algsurf_render(s->scene.scene, &options, &picture, NULL);
        seconds = measure_cpu() - begun;
    }
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "%s: %s", s->scene.name, algsurf_status_text(status));
    for (int i = 0; i < PIXELS; i++) s->shows[who][i] = (char)(isinf(s->hits[i]) == 0);
    return seconds;
}

/* ---- the others ---- */

static double children_cpu(void) {
    struct rusage usage;
    (void)getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/* Runs a program in the folder, its output going to the file `log`; returns its CPU seconds. */
static double run(const char *folder, char *const *argv) {
    double before = children_cpu();
    int status;
    pid_t child = fork();
    if (child == 0) {
        if (chdir(folder) == 0) {
            int in = open("/dev/null", O_RDONLY), out = open("log", O_WRONLY | O_CREAT | O_TRUNC, 0600);
            if (dup2(in, 0) >= 0 && dup2(out, 1) >= 0 && dup2(out, 2) >= 0) (void)execv(argv[0], argv);
        }
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) < 0) cli_fail(CLI_BROKEN, "%s: cannot be run", argv[0]);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) cli_fail(CLI_BROKEN, "%s: failed", argv[0]);
    return children_cpu() - before;
}

/* A number of a PPM's head, behind white space and comments. */
static int head_number(FILE *file) {
    int c = getc(file), number = 0;
    while (c == '#' || (c != EOF && c <= ' ')) {
        if (c == '#')
            while (c != '\n' && c != EOF) c = getc(file);
        c = getc(file);
    }
    for (; c >= '0' && c <= '9' && number < 100000; c = getc(file)) number = 10 * number + (c - '0');
    return number;
}

/* The background is pure blue, the surface is nowhere without red. */
static void read_picture(studio *s, const char *program, artist who) {
    FILE *file = results_open(s->programs->work, "picture.ppm", "rb");
    int magic = getc(file) == 'P' && getc(file) == '6';
    int width = head_number(file), height = head_number(file), most = head_number(file);
    if (!magic || width != PEERS_WIDTH || height != PEERS_HEIGHT || most != 255 ||
        fread(s->pixels, 3, PIXELS, file) != PIXELS)
        cli_fail(CLI_BROKEN, "%s: another picture of %s than was asked for", program, s->scene.name);
    fclose(file);
    for (int i = 0; i < PIXELS; i++) s->shows[who][i] = s->pixels[3 * i] > 0;
}

/* "Trace Time: ... with 0.123 CPU-seconds total", the parsing and the file left out. */
static double povray_seconds(const studio *s) {
    static char text[1 << 20];
    FILE *file = results_open(s->programs->work, "log", "r");
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    const char *line = strstr(text, "Trace Time:"), *with = line ? strstr(line, " with ") : NULL;
    if (!with) cli_fail(CLI_BROKEN, "%s: tells no time", s->programs->povray);
    return strtod(with + strlen(" with "), NULL);
}

static double draw_there(studio *s, artist who) {
    const peers_programs *programs = s->programs;
    const int surf = who == SURF || who == SURF_EMPTY;
    const char *program = surf ? programs->surf : programs->povray;
    char *by_surf[] = {(char *)program, "-q", "scene", NULL};
    char size[2][16];
    snprintf(size[0], sizeof size[0], "+W%d", PEERS_WIDTH);
    snprintf(size[1], sizeof size[1], "+H%d", PEERS_HEIGHT);
    char *by_povray[] = {(char *)program, "+Iscene", "+Opicture.ppm", "+FP",   "-D", "-P",
                         "+WT1",          "-A",      size[0],         size[1], NULL};
    FILE *file = results_open(programs->work, "scene", "w");
    if (surf)
        peers_write_surf(&s->scene, who == SURF_EMPTY, "picture.ppm", file);
    else
        peers_write_povray(&s->scene, who == POVRAY_STURM, file);
    results_finish(file, programs->work, "scene");
    fclose(results_open(programs->work, "picture.ppm",
                        "w")); /* surf ends well without a picture on a bad scene */
    double seconds = run(programs->work, surf ? by_surf : by_povray);
    read_picture(s, program, who);
    return surf ? seconds : povray_seconds(s);
}

/* ---- the exhibition ---- */

static int takes_part(const studio *s, artist who) {
    switch (who) {
    case SURF:
    case SURF_EMPTY:
        return s->programs->surf != NULL;
    case POVRAY:
        return s->programs->povray != NULL;
    case POVRAY_STURM: /* degree 2 has a form of its own, 5 and above always take Sturm's */
        return s->programs->povray != NULL && s->scene.degree > 2 && s->scene.degree < 5;
    default:
        return 1;
    }
}

static void compare(const studio *s, artist who, contest_row *row) {
    size_t truth = 0;
    for (int i = 0; i < PIXELS; i++) {
        int seen = s->shows[who][i], there = s->shows[THIN_NONE][i];
        truth += there != 0;
        row->count += seen != 0;
        row->missed += there && !seen;
        row->extra += seen && !there;
    }
    row->error = 100 * fabs((double)row->count - (double)truth) / (double)truth;
}

static void hang(const studio *s, const measure_takes takes[ARTISTS], contest_table *table) {
    const double nothing = measure_taken(&takes[SURF_EMPTY], 0.5);
    for (artist who = USUAL; who < ARTISTS; who++) {
        contest_row row = {.section = "pictures",
                           .task = s->scene.name,
                           .degree = s->scene.degree,
                           .program = artist_name[who],
                           .unit = "ms",
                           .takes = takes[who]};
        if (!takes_part(s, who) || who == SURF_EMPTY) continue;
        for (size_t i = 0; who == SURF && i < row.takes.count; i++) row.takes.seconds[i] -= nothing;
        compare(s, who, &row);
        contest_add(table, &row);
    }
}

void peers_pictures(const char *const *surfaces, int takes, const peers_programs *programs,
                    contest_table *table) {
    studio s = {.programs = programs,
                .pixels = must_allocate(PIXELS, 3),
                .hits = must_allocate(PIXELS, sizeof *s.hits)};
    for (int who = 0; who < ARTISTS; who++) s.shows[who] = must_allocate(PIXELS, 1);
    for (const char *const *name = surfaces; *name; name++) {
        measure_takes seconds[ARTISTS] = {{0}};
        peers_scene_open(&s.scene, catalogue_find(*name));
        for (int take = 0; take < takes; take++)
            for (artist who = USUAL; who < ARTISTS; who++)
                if (takes_part(&s, who))
                    measure_take(&seconds[who], who <= THIN_NONE ? draw_here(&s, who) : draw_there(&s, who));
        hang(&s, seconds, table);
        peers_scene_close(&s.scene);
    }
    for (int who = 0; who < ARTISTS; who++) free(s.shows[who]);
    free(s.hits);
    free(s.pixels);
}
