/* jsurf_file.c - see jsurf_file.h.
 *
 * Sources: java.util.Properties, for the lines: '#' and '!' begin comments, a backslash at the end joins a
 * line with the next one, backslashes escape, the key ends at the first '=', ':' or blank.  IMAGINARY's
 * jsurf, FileFormat and RayCreator, for the keys.
 */
#include "jsurf_file.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"

typedef struct matrix {
    double m[16]; /* row by row */
} matrix;

static const matrix identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};

typedef struct reader {
    jsurf_file *to;
    jsurf_error *error;
    cli_line line;
    size_t begin; /* the number of the line that the property begins at */
    char *text;   /* of the property, its lines joined */
    size_t length, capacity;
    matrix transform, rotation, surface_transform;
    double scale; /* scale_factor */
} reader;

static int refuse(reader *r, size_t line, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r->error->message, sizeof r->error->message, format, arguments);
    va_end(arguments);
    r->error->line = line;
    return -1;
}

static int refuse_for_memory(reader *r) {
    r->error->no_memory = 1;
    return refuse(r, 0, "out of memory");
}

/* ---- values ---- */

static int bad_value(reader *r, const char *key, const char *expected, const char *value) {
    return refuse(r, r->begin, "%.32s: expected %s, got '%s'", key, expected, cli_quote(value).text);
}

/* Finite numbers between blanks. */
static int read_numbers(const char *text, int count, double *x) {
    for (int i = 0; i < count; i++) {
        char *end;
        x[i] = strtod(text, &end);
        if (end == text || !isfinite(x[i])) return 0;
        text = end;
    }
    return text[strspn(text, " \t")] == '\0';
}

static int take_colour(reader *r, const char *key, const char *value, css_colour *c) {
    double rgb[3];
    if (!read_numbers(value, 3, rgb)) return bad_value(r, key, "red, green and blue", value);
    for (int i = 0; i < 3; i++) c->srgb[i] = (uint8_t)lrint(255 * fmin(fmax(rgb[i], 0), 1));
    c->given = 1;
    return 0;
}

static int take_number(reader *r, const char *key, const char *value, double low, double high, double *x) {
    if (read_numbers(value, 1, x) && *x >= low && *x <= high) return 0;
    char expected[64];
    snprintf(expected, sizeof expected, "a number from %g to %g", low, high);
    return bad_value(r, key, expected, value);
}

static int take_matrix(reader *r, const char *key, const char *value, matrix *m) {
    return read_numbers(value, 16, m->m) ? 0 : bad_value(r, key, "16 numbers", value);
}

static int take_camera(reader *r, const char *key, const char *value) {
    r->to->perspective = strcmp(value, "PERSPECTIVE_CAMERA") == 0;
    if (r->to->perspective || strcmp(value, "ORTHOGRAPHIC_CAMERA") == 0) return 0;
    return bad_value(r, key, "PERSPECTIVE_CAMERA or ORTHOGRAPHIC_CAMERA", value);
}

static char *copy_of(const char *text) {
    char *copy = malloc(strlen(text) + 1);
    return copy ? strcpy(copy, text) : NULL;
}

static int take_equation(reader *r, const char *value) {
    free(r->to->equation);
    r->to->equation = copy_of(value);
    return r->to->equation ? 0 : refuse_for_memory(r);
}

/* A key that is there twice has the value of the last one, as with Java. */
static int take_parameter(reader *r, const char *name, const char *value) {
    jsurf_file *to = r->to;
    double number;
    if (!read_numbers(value, 1, &number)) return bad_value(r, "surface_parameter", "a number", value);
    char *text = copy_of(value);
    if (!text) return refuse_for_memory(r);
    for (size_t i = 0; i < to->parameter_count; i++) {
        if (strcmp(to->parameters[i].name, name) != 0) continue;
        free(to->parameters[i].value);
        to->parameters[i].value = text;
        return 0;
    }
    char *copy = copy_of(name);
    jsurf_parameter *all = realloc(to->parameters, (to->parameter_count + 1) * sizeof *all);
    if (all) to->parameters = all;
    if (!copy || !all) {
        free(copy);
        free(text);
        return refuse_for_memory(r);
    }
    all[to->parameter_count++] = (jsurf_parameter){copy, text};
    return 0;
}

/* light_WHAT_N, N from 0 to 7; other keys that begin so are skipped. */
static int take_light(reader *r, const char *key, const char *value) {
    const char *number = strrchr(key, '_') + 1;
    size_t length = (size_t)(number - key);
    if (number[0] < '0' || number[0] >= '0' + JSURF_LIGHTS || number[1]) return 0;
    jsurf_light *light = &r->to->lights[number[0] - '0'];
    if (strncmp(key, "light_status_", length) == 0) {
        light->on = strcmp(value, "ON") == 0;
        return light->on || strcmp(value, "OFF") == 0 ? 0 : bad_value(r, key, "ON or OFF", value);
    }
    if (strncmp(key, "light_color_", length) == 0) return take_colour(r, key, value, &light->colour);
    if (strncmp(key, "light_intensity_", length) == 0)
        return take_number(r, key, value, 0, 100, &light->intensity);
    if (strncmp(key, "light_position_", length) != 0) return 0;
    light->placed = read_numbers(value, 3, light->place);
    for (int i = 0; i < 3; i++)
        if (!(fabs(light->place[i]) <= 1e6)) light->placed = 0;
    return light->placed ? 0 : bad_value(r, key, "three numbers up to 1e6", value);
}

static int take_property(reader *r, const char *key, const char *value) {
    static const char parameter[] = "surface_parameter_";
    jsurf_file *to = r->to;
    if (strcmp(key, "surface_equation") == 0) return take_equation(r, value);
    if (strncmp(key, parameter, strlen(parameter)) == 0)
        return take_parameter(r, key + strlen(parameter), value);
    if (strcmp(key, "scale_factor") == 0) return take_number(r, key, value, -100, 100, &r->scale);
    if (strcmp(key, "rotation_matrix") == 0) return take_matrix(r, key, value, &r->rotation);
    if (strcmp(key, "transform_matrix") == 0) return take_matrix(r, key, value, &r->transform);
    if (strcmp(key, "surface_transform_matrix") == 0)
        return take_matrix(r, key, value, &r->surface_transform);
    if (strcmp(key, "camera_type") == 0) return take_camera(r, key, value);
    if (strcmp(key, "camera_fov_y") == 0) return take_number(r, key, value, 1e-3, 179, &to->fov);
    if (strcmp(key, "camera_height") == 0) return take_number(r, key, value, 1e-6, 1e6, &to->height);
    if (strcmp(key, "front_material_color") == 0) return take_colour(r, key, value, &to->front);
    if (strcmp(key, "back_material_color") == 0) return take_colour(r, key, value, &to->inside);
    if (strcmp(key, "background_color") == 0) return take_colour(r, key, value, &to->background);
    if (strncmp(key, "light_", strlen("light_")) == 0) return take_light(r, key, value);
    return 0;
}

/* ---- lines ---- */

static int append(reader *r, const char *text, size_t length) {
    if (r->capacity - r->length <= length) {
        size_t capacity = 2 * (r->length + length) + 64;
        char *room = realloc(r->text, capacity);
        if (!room) return refuse_for_memory(r);
        r->text = room;
        r->capacity = capacity;
    }
    memcpy(r->text + r->length, text, length);
    r->length += length;
    r->text[r->length] = '\0';
    return 0;
}

static char *put_utf8(char *to, unsigned code) {
    if (code < 0x80) {
        *to++ = (char)code;
    } else if (code < 0x800) {
        *to++ = (char)(0xc0 | code >> 6);
        *to++ = (char)(0x80 | (code & 0x3f));
    } else {
        *to++ = (char)(0xe0 | code >> 12);
        *to++ = (char)(0x80 | (code >> 6 & 0x3f));
        *to++ = (char)(0x80 | (code & 0x3f));
    }
    return to;
}

/* The character an escape stands for, in place: no escape is shorter than what it stands for. */
static char *unescape(const char **from, char *to) {
    static const char letters[] = "tnrf", meant[] = "\t\n\r\f";
    char c = *(*from)++;
    const char *at = c ? strchr(letters, c) : NULL;
    if (c == '\0') return (*from)--, to;
    if (at) c = meant[at - letters];
    char digits[5] = "";
    strncpy(digits, *from, 4);
    if (c == 'u' && strspn(digits, "0123456789abcdefABCDEF") == 4) {
        *from += 4;
        unsigned code = (unsigned)strtoul(digits, NULL, 16);
        return put_utf8(to, code ? code : ' ');
    }
    *to++ = c;
    return to;
}

/* Cuts the property at the end of its key, in place, and hands key and value on. */
static int take_text(reader *r) {
    char *to = r->text, *value = NULL;
    const char *from = r->text;
    while (*from) {
        if (*from == '\\') {
            from++;
            to = unescape(&from, to);
        } else if (!value && strchr("=: \t", *from)) {
            from += strspn(from, " \t");
            if (*from == '=' || *from == ':') from++;
            from += strspn(from, " \t");
            *to++ = '\0';
            value = to;
        } else {
            *to++ = *from++;
        }
    }
    *to = '\0';
    while (value && to > value && (to[-1] == ' ' || to[-1] == '\t')) *--to = '\0';
    return value ? take_property(r, r->text, value) : 0;
}

/* Java writes and reads the bytes of ISO 8859-1; a text that is UTF-8 was written by other means. */
static int is_utf8(const char *text) {
    for (const unsigned char *c = (const unsigned char *)text; *c;) {
        int more = *c < 0x80                 ? 0
                   : *c >= 0xc2 && *c < 0xe0 ? 1
                   : *c >= 0xe0 && *c < 0xf0 ? 2
                   : *c >= 0xf0              ? 3
                                             : -1;
        if (more < 0) return 0;
        for (c++; more > 0; more--, c++)
            if ((*c & 0xc0) != 0x80) return 0;
    }
    return 1;
}

static int append_line(reader *r, const char *text, size_t length) {
    if (is_utf8(text)) return append(r, text, length);
    for (size_t i = 0; i < length; i++) {
        char bytes[4];
        size_t count = (size_t)(put_utf8(bytes, (unsigned char)text[i]) - bytes);
        if (append(r, bytes, count) != 0) return -1;
    }
    return 0;
}

/* The line that was just read: a part of a property, or its end. */
static int take_line(reader *r) {
    char *text = r->line.text + strspn(r->line.text, " \t\f");
    size_t length = strlen(text), slashes = 0;
    if (strlen(r->line.text) != r->line.length)
        return refuse(r, r->line.number, "a NUL byte: not a text file");
    if (r->length == 0) {
        if (*text == '#' || *text == '!' || *text == '\0') return 0;
        r->begin = r->line.number;
    }
    while (slashes < length && text[length - 1 - slashes] == '\\') slashes++;
    int goes_on = slashes % 2 == 1;
    if (goes_on) text[--length] = '\0';
    if (append_line(r, text, length) != 0) return -1;
    if (goes_on) return 0;
    int result = take_text(r);
    r->length = 0;
    return result;
}

/* ---- the view ---- */

static matrix times(const matrix *a, const matrix *b) {
    matrix c;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            c.m[4 * i + j] = 0;
            for (int k = 0; k < 4; k++) c.m[4 * i + j] += a->m[4 * i + k] * b->m[4 * k + j];
        }
    return c;
}

/* Rotations in such files have the digits of floats. */
static const double CLOSE = 1e-3;

/* Is it times a rotation, without a move?  *scale becomes the factor. */
static int is_rotation(const matrix *a, double *scale) {
    const double *m = a->m;
    *scale = hypot(hypot(m[0], m[4]), m[8]);
    double least = CLOSE * *scale * *scale;
    if (!(*scale > 0) || !isfinite(*scale)) return 0;
    for (int i = 0; i < 3; i++) {
        if (fabs(m[4 * i + 3]) > CLOSE * *scale || fabs(m[12 + i]) > CLOSE) return 0;
        for (int j = 0; j < 3; j++) {
            double product = m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
            if (!(fabs(product - (i == j) * *scale * *scale) <= least)) return 0;
        }
    }
    return fabs(m[15] - 1) <= CLOSE;
}

static int find_view(reader *r) {
    matrix turned = times(&r->transform, &r->rotation), all = times(&r->surface_transform, &turned);
    double turn, scale;
    if (!is_rotation(&turned, &turn) || fabs(turn - 1) > CLOSE)
        return refuse(r, 0, "rotation_matrix: expected a rotation");
    if (!is_rotation(&all, &scale))
        return refuse(r, 0, "surface_transform_matrix: expected a scale and a rotation");
    r->to->radius = scale * pow(10, r->scale);
    if (!(r->to->radius > 1e-100 && r->to->radius < 1e100)) return refuse(r, 0, "scale_factor: out of range");
    for (int i = 0; i < 3; i++) {
        r->to->up[i] = all.m[4 * i + 1] / scale;
        r->to->back[i] = all.m[4 * i + 2] / scale;
    }
    return 0;
}

static int read_lines(reader *r, FILE *file) {
    for (;;) {
        cli_line_result got = cli_read_line(file, &r->line);
        if (got == CLI_LINE_NO_MEMORY) return refuse_for_memory(r);
        if (got == CLI_LINE_TOO_LONG) return refuse(r, r->line.number + 1, "the line is too long");
        if (ferror(file)) return refuse(r, 0, "%s", strerror(errno));
        if (got == CLI_LINE_END) break;
        if (take_line(r) != 0) return -1;
    }
    if (r->length > 0 && take_text(r) != 0) return -1; /* the last line ended in a backslash */
    if (!r->to->equation) return refuse(r, 0, "no surface_equation: not a file of SURFER");
    return find_view(r);
}

int jsurf_read(FILE *file, jsurf_file *read, jsurf_error *error) {
    jsurf_file to = {.fov = 60, .height = 2};
    for (int i = 0; i < JSURF_LIGHTS; i++)
        to.lights[i] = (jsurf_light){.intensity = 1, .colour = {.srgb = {255, 255, 255}, .given = 1}};
    reader r = {.to = &to,
                .error = error,
                .transform = identity,
                .rotation = identity,
                .surface_transform = identity};
    *error = (jsurf_error){0};
    int result = read_lines(&r, file);
    free(r.text);
    free(r.line.text);
    if (result == 0)
        *read = to;
    else
        jsurf_release(&to);
    return result;
}

void jsurf_release(jsurf_file *read) {
    for (size_t i = 0; i < read->parameter_count; i++) {
        free(read->parameters[i].name);
        free(read->parameters[i].value);
    }
    free(read->parameters);
    free(read->equation);
    *read = (jsurf_file){.equation = NULL};
}

int jsurf_is_name(const char *path) {
    static const char ending[] = ".jsurf";
    size_t length = strlen(path), n = strlen(ending);
    if (length <= n) return 0;
    for (size_t i = 0; i < n; i++)
        if (tolower((unsigned char)path[length - n + i]) != ending[i]) return 0;
    return 1;
}
