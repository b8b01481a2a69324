/* equation.c - fuzzes algsurf_surface_from_equation: "EQUATION ; NAME=VALUE ; NAME=VALUE", with ";;" for each
 * ';' that the equation has.
 *
 * What is accepted is evaluated again, straight from the text and in rational numbers, at points of small
 * coordinates, and must agree with the surface's terms: up to the rounding of each coefficient to a double,
 * and to a share 2^-85 of the same expression with magnitudes only, which bounds what double-double loses.
 */
#include "algsurf/surface.h"
#include "exact.h"
#include "fuzz.h"

enum { MOST_CONSTANTS = 4, MOST_DEFINITIONS = 8, MOST_BITS = 20000 };

/* A number, and the sum of magnitudes of all that was added up to get it. */
typedef struct value {
    mpq_t v, size;
} value;

/* A name that the text gives to a value. */
typedef struct definition {
    const char *name;
    size_t length;
    value value;
} definition;

typedef struct reader {
    const char *at, *letters_end;
    definition defined[MOST_DEFINITIONS];
    int definitions;
    const algsurf_constant *constants;
    size_t count;
    const mpq_t *point;
    int given_up; /* too long for a quick check */
} reader;

static void value_init(value *a) { mpq_inits(a->v, a->size, NULL); }
static void value_clear(value *a) { mpq_clears(a->v, a->size, NULL); }

static void give_up(reader *r, value *a) {
    r->given_up = 1;
    mpq_set_ui(a->v, 1, 1), mpq_set_ui(a->size, 1, 1);
}

static size_t bits_of(const mpq_t q) {
    return mpz_sizeinbase(mpq_numref(q), 2) + mpz_sizeinbase(mpq_denref(q), 2);
}

/* After every operation, so that nothing grows without end. */
static void limit(reader *r, value *a) {
    if (r->given_up || bits_of(a->v) > MOST_BITS || bits_of(a->size) > MOST_BITS) give_up(r, a);
}

/* What a sign beyond ASCII may be, or a command of LaTeX; ASCII but for letters is itself. */
enum { OTHER, ROOT, PI, SUPERSCRIPT, LETTER, SQRT, FRACTION, SINE, COSINE };
enum { RAISED = 14, LOWERED, QUARTER, HALF, QUARTERS };

/* Signs that mean the same are read as the same, written from the documentation in surface.h. */
static const struct {
    const char *text;
    char as;
} signs[] = {{"**", '^'},           {"==", '='},           {"\u00b7", '*'},     {"\u00d7", '*'},
             {"\u22c5", '*'},       {"\u2217", '*'},       {"\u2062", '*'},     {"\u2212", '-'},
             {"\u2010", '-'},       {"\u2011", '-'},       {"\u2012", '-'},     {"\u2013", '-'},
             {"\u2014", '-'},       {"\u2015", '-'},       {"\u00f7", '/'},     {"\u2215", '/'},
             {"\u2044", '/'},       {"\u221a", ROOT},      {"\u03c0", PI},      {"\\cdot", '*'},
             {"\\times", '*'},      {"\\ast", '*'},        {"\\div", '/'},      {"\\{", '{'},
             {"\\}", '}'},          {"\\pi", PI},          {"\\sqrt", SQRT},    {"\\frac", FRACTION},
             {"\\dfrac", FRACTION}, {"\\tfrac", FRACTION}, {"\\sin", SINE},     {"\\cos", COSINE},
             {".^", '^'},           {".*", '*'},           {"./", '/'},         {"&=", '='},
             {"<sup>", RAISED},     {"</sup>", LOWERED},   {"\u00bc", QUARTER}, {"\u00bd", HALF},
             {"\u00be", QUARTERS}};
static const char *const superscripts[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                           "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
static const char *const blanks[] = {
    "\u00a0", "\u1680",  "\u2000", "\u2001", "\u3000", "\u2002", "\u2003", "\u2004",  "\u2005",
    "\u2006", "\u2007",  "\u2008", "\u2009", "\u200a", "\u200b", "\u202f", "\u205f",  "\ufeff",
    "~",      "\\,",     "\\;",    "\\:",    "\\!",    "\\ ",    "\\quad", "\\qquad", "\\displaystyle",
    "\\left", "\\right", "\\bigl", "\\bigr", "\\Bigl", "\\Bigr", "\\big",  "\\Big"};
/* Greek letters that names have: two or three spellings of the same. */
static const char *const greek[][3] = {
    {"\u03b1", "\\alpha"},    {"\u03b2", "\\beta"},   {"\u03b3", "\\gamma"},   {"\u03b4", "\\delta"},
    {"\u03b5", "\\epsilon"},  {"\u03b6", "\\zeta"},   {"\u03b7", "\\eta"},     {"\u03b8", "\\theta"},
    {"\u03b9", "\\iota"},     {"\u03ba", "\\kappa"},  {"\u03bb", "\\lambda"},  {"\u03bc", "\\mu", "\u00b5"},
    {"\u03bd", "\\nu"},       {"\u03be", "\\xi"},     {"\u03bf", "\\omicron"}, {"\u03c1", "\\rho"},
    {"\u03c2", "\\varsigma"}, {"\u03c3", "\\sigma"},  {"\u03c4", "\\tau"},     {"\u03c5", "\\upsilon"},
    {"\u03c6", "\\phi"},      {"\u03c7", "\\chi"},    {"\u03c8", "\\psi"},     {"\u03c9", "\\omega"},
    {"\u0391", "\\Alpha"},    {"\u0392", "\\Beta"},   {"\u0393", "\\Gamma"},   {"\u0394", "\\Delta"},
    {"\u0395", "\\Epsilon"},  {"\u0396", "\\Zeta"},   {"\u0397", "\\Eta"},     {"\u0398", "\\Theta"},
    {"\u0399", "\\Iota"},     {"\u039a", "\\Kappa"},  {"\u039b", "\\Lambda"},  {"\u039c", "\\Mu"},
    {"\u039d", "\\Nu"},       {"\u039e", "\\Xi"},     {"\u039f", "\\Omicron"}, {"\u03a0", "\\Pi"},
    {"\u03a1", "\\Rho"},      {"\u03a3", "\\Sigma"},  {"\u03a4", "\\Tau"},     {"\u03a5", "\\Upsilon"},
    {"\u03a6", "\\Phi"},      {"\u03a7", "\\Chi"},    {"\u03a8", "\\Psi"},     {"\u03a9", "\\Omega"},
    {"\u03d1", "\\vartheta"}, {"\u03d5", "\\varphi"}, {"\u03f1", "\\varrho"},  {"\u03f5", "\\varepsilon"},
};

static size_t starts(const char *text, const char *with) {
    size_t length = strlen(with);
    return strncmp(text, with, length) == 0 ? length : 0;
}

static int digit_above(const char *text) {
    for (int d = 0; d < 10; d++)
        if (starts(text, superscripts[d])) return d;
    return -1;
}

static int is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static int is_digit(char c) { return c >= '0' && c <= '9'; }

/* Which letter the text starts with: the character, or 256 and the row of a Greek one; 0 for none. */
static int letter_at(const char *text, size_t *width) {
    *width = 1;
    if (is_latin(*text)) return *text;
    for (int row = 0; row < (int)(sizeof greek / sizeof *greek); row++)
        for (int spelling = 0; spelling < 3 && greek[row][spelling]; spelling++)
            if ((*width = starts(text, greek[row][spelling])) && (*text != '\\' || !is_latin(text[*width])))
                return 256 + row;
    *width = 0;
    return 0;
}

/* A letter, a digit, an underscore. */
static int part_at(const char *text, size_t *width) {
    *width = 1;
    return is_digit(*text) || *text == '_' ? *text : letter_at(text, width);
}

static size_t name_length(const char *text) {
    size_t n = 0, width;
    if (!letter_at(text, &width)) return 0;
    while (part_at(text + n, &width)) n += width;
    return n;
}

/* The sign at r->at, behind blanks; *width is its length in bytes. */
static char sign_at(reader *r, size_t *width) {
    for (size_t i = 0, n; i < sizeof blanks / sizeof *blanks; i++)
        if ((n = starts(r->at, blanks[i])) || *r->at == ' ' || (*r->at >= '\t' && *r->at <= '\r'))
            r->at += n ? n : 1, i = (size_t)-1;
    if (letter_at(r->at, width)) return LETTER;
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if ((*width = starts(r->at, signs[i].text))) return signs[i].as;
    *width = *r->at != '\0';
    if (digit_above(r->at) < 0) return *r->at;
    *width = strlen(superscripts[digit_above(r->at)]);
    return SUPERSCRIPT;
}

static char peek(reader *r) {
    size_t width;
    return sign_at(r, &width);
}

static void take(reader *r) {
    size_t width;
    (void)sign_at(r, &width);
    r->at += width;
}

static int digit_of(char c, int hexadecimal) {
    if (is_digit(c)) return c - '0';
    if (!hexadecimal) return -1;
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* A decimal or hexadecimal exponent at `at`, or 0 when there is none. */
static long exponent_at(reader *r, char letter) {
    const char *c = r->at;
    if ((*c | 32) != letter) return 0;
    int negative = c[1] == '-';
    c += 1 + (c[1] == '-' || c[1] == '+');
    if (!is_digit(*c)) return 0;
    long e = 0;
    for (; is_digit(*c); c++) e = e < 100000 ? 10 * e + (*c - '0') : e;
    r->at = c;
    return negative ? -e : e;
}

static void number(reader *r, value *a) {
    int hexadecimal = r->at[0] == '0' && (r->at[1] | 32) == 'x' &&
                      (digit_of(r->at[2], 1) >= 0 || (r->at[2] == '.' && digit_of(r->at[3], 1) >= 0));
    long places = 0, base = hexadecimal ? 16 : 10;
    mpz_t digits;
    mpz_init(digits);
    if (hexadecimal) r->at += 2;
    for (int point = 0;; r->at++) {
        int digit = digit_of(*r->at, hexadecimal);
        if (*r->at == '.' && !point) {
            point = 1;
            continue;
        }
        if (digit < 0) break;
        mpz_mul_si(digits, digits, base), mpz_add_ui(digits, digits, (unsigned long)digit);
        places += point;
    }
    long e = exponent_at(r, hexadecimal ? 'p' : 'e'), over = hexadecimal ? 4 * places - e : places - e;
    mpq_set_z(a->v, digits);
    if (labs(over) > 380) { /* smaller numbers may be zero */
        give_up(r, a);
    } else {
        mpz_ui_pow_ui(digits, hexadecimal ? 2 : 10, (unsigned long)labs(over));
        mpq_t scale;
        mpq_init(scale), mpq_set_z(scale, digits);
        if (over > 0)
            mpq_div(a->v, a->v, scale);
        else
            mpq_mul(a->v, a->v, scale);
        mpq_clear(scale), mpq_set(a->size, a->v);
    }
    mpz_clear(digits);
    limit(r, a);
}

static void sum(reader *r, value *a);
static void with_sign(reader *r, value *a);

static void parenthesis(reader *r, value *a) {
    char open = peek(r);
    take(r);
    sum(r, a);
    fuzz_check(r->given_up || peek(r) == (open == '(' ? ')' : open == '[' ? ']' : '}'));
    take(r);
}

/* To some 400 bits, which is as good as exact here; near zero the error counts. */
static void square_root(reader *r, value *a) {
    mpf_t f;
    if (mpq_sgn(a->v) == 0) return;
    mpq_t least;
    mpq_init(least), mpq_div_2exp(least, a->size, 60);
    if (mpq_sgn(a->v) < 0 || mpq_cmp(a->v, least) < 0) {
        give_up(r, a);
    } else {
        mpf_init2(f, 500), mpf_set_q(f, a->v), mpf_sqrt(f, f);
        mpq_div(least, a->size, a->v); /* relative errors are halved */
        mpq_set_f(a->v, f), mpq_mul(a->size, least, a->v);
        mpf_clear(f);
    }
    mpq_clear(least);
    limit(r, a);
}

/* To some 600 bits: Taylor's series at |x| <= 101, with all the bits that it cancels. */
static void sine(value *a, int is_cosine) {
    enum { BITS = 1200, TERMS = 700 };
    mpf_t x, term, sum;
    mpf_init2(x, BITS), mpf_init2(term, BITS), mpf_init2(sum, BITS);
    mpf_set_q(x, a->v), mpf_mul(x, x, x), mpf_neg(x, x);
    mpf_set_ui(term, 1), mpf_set_ui(sum, 1);
    for (unsigned long n = is_cosine ? 1 : 2; n < TERMS; n += 2) {
        mpf_mul(term, term, x), mpf_div_ui(term, term, n), mpf_div_ui(term, term, n + 1);
        mpf_add(sum, sum, term);
    }
    if (!is_cosine) mpf_set_q(x, a->v), mpf_mul(sum, sum, x);
    mpf_set_prec(term, 600), mpf_set(term, sum);
    mpq_set_f(a->v, term);
    mpq_t one;
    mpq_init(one), mpq_set_ui(one, 1, 1), mpq_add(a->size, a->size, one), mpq_clear(one);
    mpf_clears(x, term, sum, NULL);
}

static int is_same_name(const char *a, const char *b, size_t length) {
    for (const char *end = b + length; b < end;) {
        size_t of_a, of_b;
        if (part_at(a, &of_a) != part_at(b, &of_b)) return 0;
        a += of_a, b += of_b;
    }
    return !*a;
}

static int constant_named(reader *r, const char *name, size_t length, value *a) {
    for (int d = 0; d < r->definitions; d++) {
        const definition *by = &r->defined[d];
        char own[64];
        if (by->length >= sizeof own) continue;
        snprintf(own, sizeof own, "%.*s", (int)by->length, by->name);
        if (!is_same_name(own, name, length)) continue;
        mpq_set(a->v, by->value.v), mpq_set(a->size, by->value.size);
        return 1;
    }
    for (size_t i = 0; i < r->count; i++) {
        if (!is_same_name(r->constants[i].name, name, length)) continue;
        exact_set(a->v, r->constants[i].value), mpq_abs(a->size, a->v);
        return 1;
    }
    return 0;
}

static void pi(value *a) {
    mpq_set_str(a->v,
                "31415926535897932384626433832795028841971693993751/10000000000000000000000000000000000000000"
                "000000000",
                10);
    mpq_set(a->size, a->v);
}

static int is_digits(const char *text, size_t n) {
    for (size_t i = 0; i < n; i++)
        if (!is_digit(text[i])) return 0;
    return n > 0;
}

/* Is T_n( or another name with its index and bracket at r->at?  Then *kind is 0, 1, 2 for T, U, P. */
static const char *series_at(reader *r, int *kind, int *n) {
    static const char *const words[] = {"ChebyshevT", "ChebyshevU", "LegendreP",
                                        "chebyshevT", "chebyshevU", "legendreP"};
    const char *start = r->at, *at = start + 1, *letter = strchr("TUP", *start);
    char index[64] = "";
    size_t digits = 0, length = name_length(start);
    *kind = letter && *start ? (int)(letter - "TUP") : -1;
    for (int w = 0; w < 6; w++)
        if (length == strlen(words[w]) && starts(start, words[w])) *kind = w % 3, at = start + length;
    int word = at > start + 1;
    if (*kind < 0) return NULL;
    if (!word && *at == '_') {
        int braced = at[1] == '{';
        at += 1 + braced;
        while (is_digit(at[digits])) digits++;
        snprintf(index, sizeof index, "%.*s", (int)digits, at);
        at += digits;
        if (braced && *at++ != '}') return NULL;
    } else if (!word) {
        for (; at[0] == '\xe2' && at[1] == '\x82' && (at[2] & 0xff) >= 0x80 && (at[2] & 0xff) < 0x8a; at += 3)
            if (digits < 9) index[digits++] = (char)((at[2] & 0xff) - 0x80 + '0');
    }
    r->at = at;
    char c = peek(r);
    int opens = c == '(' || c == '[' || c == '{';
    if (opens) take(r);
    if (word && peek(r)) {
        while (is_digit(r->at[digits])) digits++;
        snprintf(index, sizeof index, "%.*s", (int)digits, r->at);
        r->at += digits;
        if (peek(r) != ',') digits = 0;
        r->at++;
    }
    at = r->at, r->at = start;
    *n = atoi(index);
    return opens && is_digits(index, strlen(index)) ? at : NULL;
}

static void times(reader *r, value *a, const value *b);

/* The k-th coefficient of the polynomial of a kind and degree n, by its recurrence:
 * (m+1) P_{m+1} = (2m+1) x P_m - m P_{m-1}, and T and U with 1, 2, 1. */
static void series_coefficients(int kind, int n, mpq_t c[65]) {
    mpq_t older[65], next, part;
    mpq_inits(next, part, NULL);
    for (int i = 0; i <= 64; i++) mpq_init(older[i]);
    mpq_set_ui(c[0], 1, 1);
    for (int m = 0; m < n; m++) {
        unsigned long by = kind == 2 ? 2 * (unsigned long)m + 1 : m == 0 && kind == 0 ? 1 : 2;
        unsigned long less = kind == 2 ? (unsigned long)m : m > 0,
                      over = kind == 2 ? (unsigned long)m + 1 : 1;
        for (int i = n; i >= 0; i--) {
            mpq_set_ui(part, by, over);
            mpq_canonicalize(part);
            mpq_set_ui(next, 0, 1);
            if (i > 0) mpq_mul(next, c[i - 1], part);
            mpq_set_ui(part, less, over);
            mpq_canonicalize(part);
            mpq_mul(part, part, older[i]);
            mpq_sub(next, next, part);
            mpq_set(older[i], c[i]);
            mpq_set(c[i], next);
        }
    }
    for (int i = 0; i <= 64; i++) mpq_clear(older[i]);
    mpq_clears(next, part, NULL);
}

static void series(reader *r, const char *inside, int kind, int n, value *a) {
    char close = inside[0];
    for (const char *c = inside - 1; close != ')' && close != ']' && close != '}'; c--)
        close = *c == '(' ? ')' : *c == '[' ? ']' : *c == '{' ? '}' : close;
    value x;
    mpq_t c[65];
    value_init(&x);
    r->at = inside;
    sum(r, &x);
    fuzz_check(r->given_up || (peek(r) == close && n <= 64));
    take(r);
    for (int i = 0; i <= 64; i++) mpq_init(c[i]);
    if (!r->given_up) series_coefficients(kind, n, c);
    mpq_set_ui(a->v, 0, 1), mpq_set_ui(a->size, 0, 1);
    for (int i = n; i >= 0 && !r->given_up; i--) {
        times(r, a, &x);
        mpq_add(a->v, a->v, c[i]);
        mpq_abs(c[i], c[i]);
        mpq_add(a->size, a->size, c[i]);
    }
    if (r->given_up) give_up(r, a);
    for (int i = 0; i <= 64; i++) mpq_clear(c[i]);
    value_clear(&x);
}

static void name(reader *r, value *a);

/* A part of a product written as one name: x, y, z, the longest of the constants and pi, X, Y, Z. */
static void factor(reader *r, value *a) {
    const char *start = r->at;
    int kind, index;
    if (series_at(r, &kind, &index)) {
        r->letters_end = start;
        name(r, a);
        return;
    }
    size_t longest = 0, width;
    for (size_t n = 0; start + n < r->letters_end;) {
        (void)part_at(start + n, &width), n += width;
        if (constant_named(r, start, n, a)) longest = n;
    }
    char variable = *start >= 'a' ? *start : (char)(*start + 32);
    if (variable >= 'x' && is_latin(*start) && (*start >= 'a' || !longest)) {
        r->at++;
        mpq_set(a->v, r->point[variable - 'x']), mpq_abs(a->size, a->v);
        return;
    }
    int is_pi = (start[0] | 32) == 'p' && (start[1] | 32) == 'i';
    r->at = start + longest;
    if (longest > (size_t)is_pi && constant_named(r, start, longest, a)) return;
    fuzz_check(is_pi);
    r->at = start + 2;
    pi(a);
}

static void primary(reader *r, value *a);

/* The sine or cosine of what follows. */
static void sine_of(reader *r, int is_cosine, value *a) {
    primary(r, a);
    if (!r->given_up) sine(a, is_cosine);
    limit(r, a);
}

static void name(reader *r, value *a) {
    const char *start = r->at;
    if (start >= r->letters_end) {
        size_t length = name_length(start);
        r->at += length;
        if (constant_named(r, start, length, a)) return;
        if (length == 4 && (starts(start, "sqrt") || starts(start, "Sqrt"))) {
            (void)peek(r);
            parenthesis(r, a);
            if (!r->given_up) square_root(r, a);
            return;
        }
        int is_sine = length == 3 && (starts(start, "sin") || starts(start, "Sin"));
        if (is_sine || (length == 3 && (starts(start, "cos") || starts(start, "Cos")))) {
            sine_of(r, !is_sine, a);
            return;
        }
        r->at = start;
        int kind, n;
        const char *inside = series_at(r, &kind, &n);
        if (inside) {
            series(r, inside, kind, n, a);
            return;
        }
        r->letters_end = start + length;
        r->at = start;
    }
    factor(r, a);
}

static void over(reader *r, value *a, value *b);

/* Of a command: a bracket, or one digit. */
static void argument(reader *r, value *a) {
    char c = peek(r);
    if (!is_digit(c)) {
        fuzz_check(c == '{' || c == '(');
        parenthesis(r, a);
        return;
    }
    take(r);
    mpq_set_ui(a->v, (unsigned long)(c - '0'), 1), mpq_set(a->size, a->v);
}

static void command(reader *r, char kind, value *a) {
    take(r);
    if (kind == SINE || kind == COSINE) {
        sine_of(r, kind == COSINE, a);
        return;
    }
    argument(r, a);
    if (kind == SQRT && !r->given_up) square_root(r, a);
    if (kind == FRACTION && !r->given_up) {
        value b;
        value_init(&b);
        argument(r, &b);
        if (!r->given_up) over(r, a, &b);
        value_clear(&b);
    }
}

static void primary(reader *r, value *a) {
    char c = peek(r);
    if (is_digit(c) || c == '.') {
        number(r, a);
    } else if (c == LETTER) {
        name(r, a);
    } else if (c == SQRT || c == FRACTION || c == SINE || c == COSINE) {
        command(r, c, a);
    } else if (c == ROOT) {
        take(r);
        primary(r, a);
        if (!r->given_up) square_root(r, a);
    } else if (c == PI) {
        take(r);
        pi(a);
    } else if (c >= QUARTER && c <= QUARTERS) {
        take(r);
        mpq_set_ui(a->v, (unsigned long)(c - QUARTER + 1), 4), mpq_canonicalize(a->v), mpq_set(a->size, a->v);
    } else {
        parenthesis(r, a);
    }
}

static void times(reader *r, value *a, const value *b) {
    if (r->given_up) return;
    mpq_mul(a->v, a->v, b->v), mpq_mul(a->size, a->size, b->size);
    limit(r, a);
}

/* A divisor's relative error is its size's. */
static void over(reader *r, value *a, value *b) {
    if (mpq_sgn(b->v) == 0) {
        give_up(r, a);
        return;
    }
    mpq_div(a->v, a->v, b->v), mpq_div(a->size, a->size, b->v);
    mpq_mul(a->size, a->size, b->size), mpq_div(a->size, a->size, b->v);
    mpq_abs(a->size, a->size);
    limit(r, a);
}

/* The exponent behind a power's base. */
static int exponent(reader *r) {
    value e;
    int n = 0;
    if (peek(r) == SUPERSCRIPT) {
        for (int d = digit_above(r->at); d >= 0; take(r), d = digit_above(r->at))
            n = n <= 64 ? 10 * n + d : n;
        return n;
    }
    int raised = peek(r) == RAISED;
    take(r);
    value_init(&e);
    if (raised)
        sum(r, &e), take(r);
    else
        with_sign(r, &e);
    n = (int)lround(mpq_get_d(e.v));
    value_clear(&e);
    return n;
}

static void power(reader *r, value *a) {
    primary(r, a);
    if (r->given_up || (peek(r) != '^' && peek(r) != SUPERSCRIPT && peek(r) != RAISED)) return;
    value one;
    value_init(&one);
    int n = exponent(r);
    fuzz_check(r->given_up || (n >= -64 && n <= 64));
    mpq_set_ui(one.v, 1, 1), mpq_set_ui(one.size, 1, 1);
    for (int i = 0; i < abs(n) && !r->given_up; i++) times(r, &one, a);
    if (n < 0) {
        mpq_set_ui(a->v, 1, 1), mpq_set_ui(a->size, 1, 1);
        over(r, a, &one);
    } else {
        mpq_set(a->v, one.v), mpq_set(a->size, one.size);
    }
    value_clear(&one);
}

static void with_sign(reader *r, value *a) {
    int negative = 0;
    for (char c = peek(r); c == '+' || c == '-'; take(r), c = peek(r)) negative ^= c == '-';
    power(r, a);
    if (negative) mpq_neg(a->v, a->v);
}

static int begins_factor(char c) {
    return c == '(' || c == '[' || c == '{' || c == ROOT || c == PI || (c >= LETTER && c <= COSINE);
}

static void product(reader *r, value *a) {
    value b;
    value_init(&b);
    with_sign(r, a);
    for (char c = peek(r); !r->given_up && (c == '*' || c == '/' || begins_factor(c)); c = peek(r)) {
        if (c == '*' || c == '/')
            take(r), with_sign(r, &b);
        else
            power(r, &b);
        if (c == '/')
            over(r, a, &b);
        else
            times(r, a, &b);
    }
    value_clear(&b);
}

static void sum(reader *r, value *a) {
    value b;
    value_init(&b);
    product(r, a);
    for (char c = peek(r); !r->given_up && (c == '+' || c == '-'); c = peek(r)) {
        take(r), product(r, &b);
        if (c == '-') mpq_neg(b.v, b.v);
        mpq_add(a->v, a->v, b.v), mpq_add(a->size, a->size, b.size);
        limit(r, a);
    }
    value_clear(&b);
}

/* P(x,y,z) = before an equation, where it is there. */
static int head(reader *r) {
    const char *start = (peek(r), r->at);
    r->at += name_length(start);
    for (const char *sign = "(x,y,z)="; *sign && r->at > start; sign++) {
        char c = peek(r);
        if (c == LETTER && is_latin(*r->at)) c = *r->at >= 'a' ? *r->at : (char)(*r->at + 32);
        if (c != *sign) r->at = start;
        if (c == *sign) take(r);
    }
    return r->at > start;
}

/* NAME = SUM ; with more behind.  Returns whether that is there. */
static int define(reader *r) {
    const char *start = (peek(r), r->at), *end = start, *c;
    size_t length = name_length(start), width;
    int others = 0;
    for (size_t i = 0; i < length; i += width) others |= !strchr("xyzXYZ", part_at(start + i, &width) & 0xff);
    r->at = start + length;
    for (; *end && *end != ';'; end++) end += *end == '\\' && end[1];
    reader behind = *r;
    behind.at = end + (*end != '\0');
    if (!length || !others || peek(r) != '=' || !*end || peek(&behind) == '\0' ||
        (length == 4 && starts(start, "sqrt"))) {
        r->at = start;
        return 0;
    }
    take(r);
    value v;
    value_init(&v);
    sum(r, &v);
    fuzz_check(r->given_up || (c = (peek(r), r->at), *c == ';'));
    r->at++;
    if (r->given_up || r->definitions == MOST_DEFINITIONS) {
        r->given_up = 1;
        value_clear(&v);
    } else {
        r->defined[r->definitions++] = (definition){start, length, v};
    }
    return !r->given_up;
}

/* A polynomial of POV-Ray: poly and others, from its name on. */
static int povray(reader *r, value *a) {
    static const char *const solids[] = {"poly", "quadric", "cubic", "quartic"};
    static const int quadric[10][3] = {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1},
                                       {0, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    const char *start = (peek(r), r->at);
    size_t length = name_length(start);
    int kind = -1, order = 0, count = 0;
    for (int s = 0; s < 4; s++)
        if (length == strlen(solids[s]) && starts(start, solids[s])) kind = s;
    r->at += length;
    if (kind < 0 || peek(r) != '{') return r->at = start, 0;
    r->at++;
    value c, power;
    value_init(&c), value_init(&power);
    if (kind == 0) order = (peek(r), (int)strtol(r->at, (char **)(uintptr_t)&r->at, 10));
    if (kind > 1) order = kind == 2 ? 3 : 4;
    mpq_set_ui(a->v, 0, 1), mpq_set_ui(a->size, 0, 1);
    for (int i = order; i >= 0 && !r->given_up; i--)
        for (int j = order - i; j >= 0 && !r->given_up; j--)
            for (int k = order - i - j; k >= 0 && !r->given_up; k--)
                for (int last = kind == 1 ? 10 : 1; last > 0 && !r->given_up; last--, count++) {
                    const int of[3] = {i, j, k}, *e = kind == 1 ? quadric[count] : of;
                    while (peek(r) == ',' || *r->at == '<' || *r->at == '>') r->at++;
                    sum(r, &c);
                    for (int axis = 0; axis < 3; axis++)
                        for (int n = 0; n < e[axis]; n++) {
                            mpq_set(power.v, r->point[axis]), mpq_abs(power.size, power.v);
                            times(r, &c, &power);
                        }
                    mpq_add(a->v, a->v, c.v), mpq_add(a->size, a->size, c.size);
                }
    while (peek(r) == ',' || *r->at == '<' || *r->at == '>') r->at++;
    if (starts(r->at, "sturm")) r->at += 5;
    fuzz_check(r->given_up || peek(r) == '}');
    take(r);
    value_clear(&c), value_clear(&power);
    if (r->given_up) give_up(r, a);
    return 1;
}

/* A full stop or a comma behind an equation. */
static void stop(reader *r) {
    char c = peek(r);
    if (c == '.' || c == ',') r->at++;
}

/* function { or function(x,y,z) {, of POV-Ray. */
static int function(reader *r) {
    const char *start = r->at, *rest = "(x,y,z){";
    if (!starts(r->at, "function")) return 0;
    r->at += strlen("function");
    (void)peek(r);
    if (*r->at == '{') rest += strlen("(x,y,z)");
    for (; *rest; rest++, r->at++) {
        (void)peek(r);
        if (*r->at == *rest) continue;
        r->at = start;
        return 0;
    }
    return 1;
}

static void equation(reader *r, value *a) {
    static const char *const pairs[][2] = {{"$$", "$$"},
                                           {"$", "$"},
                                           {"\\(", "\\)"},
                                           {"\\[", "\\]"},
                                           {"\\begin{equation}", "\\end{equation}"},
                                           {"\\begin{equation*}", "\\end{equation*}"},
                                           {"\\begin{align}", "\\end{align}"},
                                           {"\\begin{align*}", "\\end{align*}"},
                                           {"\\begin{displaymath}", "\\end{displaymath}"},
                                           {"\\begin{math}", "\\end{math}"}};
    enum { PAIRS = sizeof pairs / sizeof *pairs };
    const char *close = NULL;
    value b;
    value_init(&b);
    (void)peek(r);
    for (int pair = 0; pair < PAIRS && !close; pair++)
        if (starts(r->at, pairs[pair][0])) r->at += strlen(pairs[pair][0]), close = pairs[pair][1];
    if (!close && function(r)) close = "}";
    while (define(r)) {
    }
    if (r->given_up) {
        give_up(r, a);
    } else if (!povray(r, a)) {
        if (!head(r) && peek(r) == '=') take(r);
        sum(r, a);
        if (!r->given_up && peek(r) == '=') {
            take(r), sum(r, &b);
            mpq_sub(a->v, a->v, b.v), mpq_add(a->size, a->size, b.size);
        }
    }
    stop(r);
    (void)peek(r);
    fuzz_check(r->given_up || !close || starts(r->at, close));
    if (close && !r->given_up) r->at += strlen(close);
    stop(r);
    if (!r->given_up && peek(r) == ';') take(r);
    fuzz_check(r->given_up || peek(r) == '\0');
    value_clear(&b);
}

/* v becomes P(point), slack what the rounding of its coefficients may change. */
static void add_terms(const algsurf_term *terms, size_t count, const mpq_t point[3], mpq_t v, mpq_t slack) {
    mpq_t term, half;
    mpq_inits(term, half, NULL);
    for (size_t t = 0; t < count; t++) {
        const int e[3] = {terms[t].i, terms[t].j, terms[t].k};
        mpq_set_ui(term, 1, 1);
        for (int axis = 0; axis < 3; axis++)
            for (int i = 0; i < e[axis]; i++) mpq_mul(term, term, point[axis]);
        double u = nextafter(fabs(terms[t].a), INFINITY) - fabs(terms[t].a);
        exact_set(half, isfinite(u) ? u / 2 : 0x1p970);
        mpq_mul(half, half, term), mpq_abs(half, half), mpq_add(slack, slack, half);
        exact_set(half, terms[t].a), mpq_mul(term, term, half), mpq_add(v, v, term);
    }
    mpq_clears(term, half, NULL);
}

static void check_value(const char *text, const algsurf_constant *constants, size_t count,
                        const algsurf_term *terms, size_t term_count, const mpq_t point[3]) {
    reader r = {.at = text, .letters_end = text, .constants = constants, .count = count, .point = point};
    value a;
    mpq_t v, slack;
    value_init(&a), mpq_inits(v, slack, NULL);
    equation(&r, &a);
    if (!r.given_up) {
        add_terms(terms, term_count, point, v, slack);
        mpq_div_2exp(a.size, a.size, 85), mpq_add(slack, slack, a.size);
        mpq_set_ui(a.size, 1, 1), mpq_div_2exp(a.size, a.size, 960); /* coefficients that underflow */
        mpq_add(slack, slack, a.size);
        mpq_sub(a.v, a.v, v), mpq_abs(a.v, a.v);
        if (mpq_cmp(a.v, slack) > 0) exact_print("difference", a.v), exact_print("allowed", slack);
        fuzz_check(mpq_cmp(a.v, slack) <= 0);
    }
    for (int d = 0; d < r.definitions; d++) value_clear(&r.defined[d].value);
    value_clear(&a), mpq_clears(v, slack, NULL);
}

static void check_surface(const char *text, const algsurf_constant *constants, size_t count,
                          const algsurf_surface *surface) {
    static const long points[][6] = {{1, 2, -3, 4, 1, 8}, {0, 1, 1, 1, 0, 1}, {-1, 1, 5, 4, 3, 1}};
    size_t term_count = algsurf_surface_term_count(surface);
    algsurf_term *terms = malloc((term_count + 1) * sizeof *terms);
    fuzz_check(terms && term_count > 0);
    fuzz_check(algsurf_surface_terms(surface, terms) == ALGSURF_OK);
    int degree = 0;
    for (size_t i = 0; i < term_count; i++) {
        int total = terms[i].i + terms[i].j + terms[i].k;
        fuzz_check(isfinite(terms[i].a) && terms[i].a != 0);
        fuzz_check(terms[i].i >= 0 && terms[i].j >= 0 && terms[i].k >= 0 && total <= ALGSURF_MAX_DEGREE);
        degree = total > degree ? total : degree;
    }
    fuzz_check(degree == algsurf_surface_degree(surface));
    for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
        mpq_t point[3];
        for (int axis = 0; axis < 3; axis++) {
            mpq_init(point[axis]);
            mpq_set_si(point[axis], points[i][2 * axis], (unsigned long)points[i][2 * axis + 1]);
        }
        check_value(text, constants, count, terms, term_count, (const mpq_t *)point);
        for (int axis = 0; axis < 3; axis++) mpq_clear(point[axis]);
    }
    free(terms);
}

static void check_refusal(algsurf_status status, const char *text, const algsurf_parse_error *error) {
    fuzz_check(status < 0);
    int told = status == ALGSURF_E_SYNTAX || status == ALGSURF_E_NAME || status == ALGSURF_E_DEGREE ||
               status == ALGSURF_E_RANGE;
    fuzz_check(told == (error->message != NULL));
    if (told) fuzz_check(error->offset + error->length <= strlen(text) && error->message[0]);
    size_t width;
    if (status == ALGSURF_E_NAME)
        fuzz_check(letter_at(text + error->offset, &width) && error->length >= width);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    char *text = fuzz_string(data, size), *rest = text;
    algsurf_constant constants[MOST_CONSTANTS];
    size_t count = 0;
    for (; *rest && (*rest != ';' || rest[1] == ';'); rest++) {
        if (*rest == '\\' && rest[1])
            rest++; /* a blank of LaTeX */
        else if (*rest == ';')
            memmove(rest, rest + 1, strlen(rest));
    }
    if (!*rest) rest = NULL;
    while (rest && count < MOST_CONSTANTS) {
        *rest++ = '\0';
        rest += strspn(rest, " \n");
        char *equals = strchr(rest, '=');
        if (!equals) break;
        constants[count].name = rest;
        *equals = '\0';
        constants[count++].value = strtod(equals + 1, &rest);
        rest = strchr(rest, ';');
    }
    algsurf_surface *const untouched = (algsurf_surface *)(void *)&text, *surface = untouched;
    algsurf_parse_error error = {0, 0, NULL};
    algsurf_status status = algsurf_surface_from_equation(text, constants, count, &surface, &error);
    if (status == ALGSURF_OK) {
        check_surface(text, constants, count, surface);
        algsurf_surface_free(surface);
    } else {
        fuzz_check(surface == untouched);
        check_refusal(status, text, &error);
    }
    free(text);
    return 0;
}
