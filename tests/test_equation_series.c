/* test_equation_series.c - T_n(a), U_n(a), P_n(a) in equations: Chebyshev's polynomials and Legendre's.
 *
 * Each test says which breaks it catches.
 */
#include "equation_case.h"

static const char *const written[][2] = {
    {"T_0(x)+U_0(y)+P_0(z)+x", "3+x"},
    {"T_1(x)+U_1(y)+P_1(z)", "x+2y+z"},
    {"T_2(x)+U_2(y)+P_2(z)", "2x^2-1+4y^2-1+(3z^2-1)/2"},
    {"T_6(x)+T_6(y)+T_6(z)", "32x^6-48x^4+18x^2-1+32y^6-48y^4+18y^2-1+32z^6-48z^4+18z^2-1"},
    {"U_5(x)+y", "32x^5-32x^3+6x+y"},
    {"P_6(x)+y", "(231x^6-315x^4+105x^2-5)/16+y"},
    {"T_{3}(x)+T\u2083(y)+T_3[z]", "4x^3-3x+4y^3-3y+4z^3-3z"},
    {"T_3{x}+T_{3}\\left\\{ y\\right\\}", "4x^3-3x+4y^3-3y"},
    {"T\u2081\u2080(x)", "512x^10-1280x^8+1120x^6-400x^4+50x^2-1"},
    {"ChebyshevT[3,x]+ChebyshevU[2, y]+LegendreP[ 2 , z]", "4x^3-3x+4y^2-1+(3z^2-1)/2"},
    {"chebyshevT(3,x)+chebyshevU(2,y)+legendreP(2,z)", "4x^3-3x+4y^2-1+(3z^2-1)/2"},
    {"T_2 \\left( x \\right)-y", "2x^2-1-y"},
    {"2zT_2(x)yxU_1(y)", "2z(2x^2-1)y*x*2y"},
    {"T_2(x)^2=-T_2(y)/2", "(2x^2-1)^2+y^2-1/2"},
    {"T_3(x+y-1)", "4(x+y-1)^3-3(x+y-1)"},
    {"T_2(T_3(x))+y", "32x^6-48x^4+18x^2-1+y"},
    {"T_64(1)x+U_9(1)y+P_30(1)z", "x+10y+z"},
    {"w=T_2(x); w^2-y", "(2x^2-1)^2-y"},
    {"P_2(x,y,z)=x^2-y", "x^2-y"}, /* a name of what is zero */
};

/* Catches: a coefficient, a spelling, letters before a name that are lost, one kind taken for another. */
TEST(test_written) {
    for (size_t c = 0; c < sizeof written / sizeof *written; c++) same(written[c][0], written[c][1]);
    const algsurf_constant constants[] = {{"T_2", 3}, {"T", 5}, {"a", 7}};
    same_with("T_2(x)+y", constants, 1, "3x+y");
    same_with("T_{2}(x)+T\u2082(y)+ChebyshevT[2,z]", constants, 1, "2x^2-1+2y^2-1+2z^2-1");
    same_with("T_3(x)+T y+aT_2(z)", constants + 1, 2, "4x^3-3x+5y+7(2z^2-1)");
}

/* The value at 1 is 1, n+1, 1; the first coefficient is 2^(n-1), 2^n, C(2n,n)/2^n; whole numbers and halves
 * of them that are doubles are exact.  Catches: sums and fractions that lose digits, an error not accounted
 * for. */
TEST(test_degrees) {
    for (int n = 1; n <= ALGSURF_MAX_DEGREE; n++)
        for (int kind = 0; kind < 3; kind++) {
            char text[64];
            algsurf_term terms[ALGSURF_MAX_DEGREE + 1];
            sprintf(text, "%c_%d(x)", "TUP"[kind], n);
            algsurf_surface *s = parse(text);
            size_t count = algsurf_surface_term_count(s);
            assert_int_equal(count, n / 2 + 1);
            assert_ok(algsurf_surface_terms(s, terms));
            double lead = kind == 0 ? ldexp(1, n - 1) : ldexp(1, n), most = 0;
            for (int i = 1; kind == 2 && i <= n; i++) lead *= (n + i) / (4.0 * i);
            for (size_t t = 0; t < count; t++) {
                most = fmax(most, fabs(terms[t].a));
                if (terms[t].i != n) continue;
                if (fabs(terms[t].a - lead) > 0x1p-45 * lead) fail_msg("%s: %a", text, terms[t].a);
            }
            double rounding = algsurf_surface_rounding(s);
            int small = (kind < 2 && most < 0x1p53) || (kind == 2 && n <= 20);
            if (small ? rounding != 0 : rounding > 0x1p-52) fail_msg("%s: rounding %a", text, rounding);
            if (kind == 2) continue;
            sprintf(text, "%c_%d(1)x-%d*y", "TUP"[kind], n, kind ? n + 1 : 1);
            char same_as[64];
            sprintf(same_as, "%d(x-y)", kind ? n + 1 : 1);
            same(text, same_as);
        }
}

static const refused_text refused[] = {
    {"T_65(x)", "T_65", "degree"},
    {"y+U_33(x^2)", "U_33", "degree"},
    {"xP_9(y^9)", "P_9", "degree"},
    {"T_65(1)x", "T_65", "an index up to 64"},
    {"T_99999999999999999999(1)x", "T_99999999999999999999", "an index up to 64"},
    {"T_6 x", "T_6", "needs a value"},
    {"T_n(x)", "T_n", "needs a value"},
    {"T_6(x", "", "or ')'"},
    {"T_6(x,y)", ",", "no points or vectors"},
    {"LegendreP[x]", "LegendreP", "no function of this name"},
    {"V_6(x)", "V_6", "needs a value"},
};

/* Catches: degrees that are not seen before they are computed; indices that overflow. */
TEST(test_refused) {
    for (size_t c = 0; c < sizeof refused / sizeof *refused; c++) explained(&refused[c], NULL, 0);
}

/* Catches: a factor that is multiplied term by term though it is short as it is written. */
TEST(test_time) {
    static const char *const large[] = {"T_64(x+y+z)", "T_32(x+y+z)T_32(x+y-z+1)", "U_4((x+y+z+1)^16)",
                                        "T_8(x+y+z)^2(P_16(x+y+z+1)+x)^3",
                                        "T_2(T_2(T_2(T_2(T_2(x+y+z+1)))))"};
    for (size_t n = 0; n < sizeof large / sizeof *large; n++) {
        double begin = unit_seconds();
        (void)parse(large[n]);
        double seconds = unit_seconds() - begin;
        if (seconds > 2) fail_msg("%s: %g s", large[n], seconds);
    }
}
