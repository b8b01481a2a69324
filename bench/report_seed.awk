# report_seed.awk - what bench/report says of seed.csv.
$(c("evaluations")) == "" { next }
{
    way = $(c("method")); surface = $(c("surface"))
    if (!(surface in least) || $(c("solve_ns")) < least[surface] + 0) {
        least[surface] = $(c("solve_ns")); fastest[surface] = way
    }
    if (!(way in sum)) ways[++n] = way
    sum[way] += $(c("evaluations")); count[way]++
    wrong[way] += $(c("wrong_roots")); brackets[way] += $(c("brackets"))
    solve[way] += $(c("solve_ns"))
}
END {
    printf "From bracket to root they evaluate P, on average:"
    for (i = 1; i <= n; i++)
        printf "%s %s %.1f times", (i > 1 ? "," : ""), ways[i], sum[ways[i]] / count[ways[i]]
    printf " (default: of P and its derivative).\nThe whole solve takes %s as long by bisection as by the default method, and %s by Brent",
        times(solve["bisection"] / solve["default"]), times(solve["Brent"] / solve["default"])
    print ": isolation is the same for all."
    for (surface in fastest) won[fastest[surface]]++
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
