# report_savings.awk - what Brent's method saves of a picture, for bench/report, from seed.csv.
$(c("picture_ms")) == "" { next }
{
    surface = $(c("surface"))
    if (!(surface in seen)) { seen[surface] = 1; surfaces[++n] = surface }
    ms[surface, $(c("method"))] = $(c("picture_ms"))
}
function saved(surface, other) {
    return sprintf("%.1f", 100 * (1 - ms[surface, "Brent"] / ms[surface, other]))
}
END {
    print "| picture | over bisection, % | over regula falsi, % |"
    print "|---|--:|--:|"
    for (i = 1; i <= n; i++)
        printf "| %s | %s | %s |\n", surfaces[i], saved(surfaces[i], "bisection"),
            saved(surfaces[i], "regula falsi")
    print "| Chuyeshov 2005, his six | 0.9 to 1.7 | 0 to 1.9 |"
}
