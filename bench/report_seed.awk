# report_seed.awk - what bench/report says of seed.csv.
$(c("evaluations")) == "" { next }
{
    way = $(c("method")); surface = $(c("surface")); ns = $(c("solve_ns")) + 0
    if (!(surface in least)) surfaces[++m] = surface
    if (!(surface in least) || ns < least[surface]) { least[surface] = ns; fastest[surface] = way }
    if (way !~ /^(bisection|regula falsi)$/ && ns > most[surface]) most[surface] = ns
    if (!(way in solve)) ways[++n] = way
    wrong[way] += $(c("wrong_roots")); brackets[way] += $(c("brackets"))
    solve[way] += ns
}
END {
    printf "The whole solve takes %s as long by bisection as by the default method, and %s by Brent: ",
        times(solve["bisection"] / solve["default"]), times(solve["Brent"] / solve["default"])
    print "isolation\nis the same for all."
    for (i = 1; i <= m; i++) {
        list[i] = 100 * (1 - least[surfaces[i]] / most[surfaces[i]])
        won[fastest[surfaces[i]]]++
    }
    printf "Bisection and regula falsi apart, the choice of a method is worth %.0f %% of it, ",
        median(list, m)
    print "median over surfaces."
    printf "Fastest:"
    for (i = 1; i <= n; i++)
        if (won[ways[i]])
            printf "%s %s on %d", (told++ ? "," : ""), ways[i], won[ways[i]]
    print "."
    printf "Wrong roots:"
    for (i = 1; i <= n; i++)
        if (wrong[ways[i]])
            printf "%s %s %d of %d", (some++ ? "," : ""), ways[i], wrong[ways[i]], brackets[ways[i]]
    print (some ? "; the others none." : " none, by any of them.")
}
