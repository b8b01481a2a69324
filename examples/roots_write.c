/* roots_write.c - see roots_write.h. */
#include "roots_write.h"

#include "roots_outward.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static char *room_for(roots_text *to, size_t more) {
    if (to->capacity - to->length < more) {
        to->capacity = 2 * to->capacity + more + 1024;
        to->text = realloc(to->text, to->capacity);
        if (!to->text) cli_no_memory();
    }
    return to->text + to->length;
}

static void add_text(roots_text *to, const char *text) {
    size_t length = strlen(text);
    memcpy(room_for(to, length), text, length);
    to->length += length;
}

void roots_add(roots_text *to, const char *format, ...) {
    enum { MOST = 512 };
    va_list values;
    va_start(values, format);
    int length = vsnprintf(room_for(to, MOST), MOST, format, values);
    va_end(values);
    to->length += length < MOST ? (size_t)length : MOST - 1;
}

void roots_add_number(roots_text *to, const shortest_powers *powers, double x) {
    to->length += (size_t)shortest_write(powers, x, room_for(to, SHORTEST_ROOM));
}

static void add_whole(roots_text *to, size_t n) {
    char digit[24], *at = digit + sizeof digit;
    *--at = 0;
    do {
        *--at = (char)('0' + n % 10);
    } while (n /= 10);
    add_text(to, at);
}

void roots_write_columns(roots_text *to, const shortest_powers *powers, size_t line, const roots_row *rows,
                         int count) {
    for (int i = 0; i < count; i++) {
        const roots_row *r = &rows[i];
        const double numbers[6] = {r->value.re,  r->value.im,  r->box.re.lo,
                                   r->box.re.hi, r->box.im.lo, r->box.im.hi};
        add_whole(to, line);
        add_text(to, "\t");
        add_whole(to, (size_t)i + 1);
        for (int k = 0; k < 6; k++) {
            add_text(to, "\t");
            roots_add_number(to, powers, numbers[k]);
        }
        add_text(to, "\t");
        add_whole(to, (size_t)r->multiplicity);
        add_text(to, "\t1\n");
    }
}

static void add_interval(roots_text *to, algsurf_interval x) {
    char text[ROOTS_OUTWARD_ROOM];
    roots_outward(x, text);
    add_text(to, text);
}

void roots_write_sentence(roots_text *to, const shortest_powers *powers, int index, const roots_row *row,
                          int exact, int rounded) {
    int real = row->box.im.lo == 0 && row->box.im.hi == 0;
    roots_add(to, "%5d  %-7s  ", index, real ? "real" : "complex");
    roots_add_number(to, powers, row->value.re);
    if (!real) {
        add_text(to, signbit(row->value.im) ? " " : " +");
        roots_add_number(to, powers, row->value.im);
        add_text(to, " i");
    }
    add_text(to, exact ? "   exactly" : "   in ");
    if (!exact) add_interval(to, row->box.re);
    if (!real) {
        add_text(to, " + ");
        add_interval(to, row->box.im);
        add_text(to, " i");
    }
    if (row->multiplicity > 1) roots_add(to, ", %d roots", row->multiplicity);
    add_text(to, rounded ? ", verified for the rounded polynomial\n" : ", verified\n");
}

void roots_write_decimal_columns(roots_text *to, size_t line, int index, const roots_decimals *re,
                                 const roots_decimals *im, int multiplicity) {
    const char *const numbers[6] = {re->value, im->value, re->lo, re->hi, im->lo, im->hi};
    add_whole(to, line);
    add_text(to, "\t");
    add_whole(to, (size_t)index);
    for (int k = 0; k < 6; k++) add_text(to, "\t"), add_text(to, numbers[k]);
    roots_add(to, "\t%d\t1\n", multiplicity);
}

static void add_decimals(roots_text *to, const roots_decimals *d) {
    add_text(to, "[");
    add_text(to, d->lo);
    add_text(to, ", ");
    add_text(to, d->hi);
    add_text(to, "]");
}

static int is_one(const roots_decimals *d) { return strcmp(d->lo, d->hi) == 0; }

void roots_write_decimal_sentence(roots_text *to, int index, const roots_decimals *re,
                                  const roots_decimals *im, int real, int multiplicity) {
    const int exact = is_one(re) && is_one(im);
    roots_add(to, "%5d  %-7s  ", index, real ? "real" : "complex");
    add_text(to, re->value);
    if (!real) {
        add_text(to, im->value[0] == '-' ? " " : " +");
        add_text(to, im->value);
        add_text(to, " i");
    }
    add_text(to, exact ? "   exactly" : "   in ");
    if (!exact) add_decimals(to, re);
    if (!real && !exact) {
        add_text(to, " + ");
        add_decimals(to, im);
        add_text(to, " i");
    }
    if (multiplicity > 1) roots_add(to, ", %d roots", multiplicity);
    add_text(to, ", verified\n");
}
