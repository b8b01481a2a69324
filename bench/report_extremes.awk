# report_extremes.awk - what bench/report says of extremes.csv.
{
    at = $(c("sweep")); how = $(c("manner"))
    if (!(at in rays)) { sweeps[++n] = at; rays[at] = 0 }
    if (how == "certified") {
        rays[at] += $(c("rays")); all += $(c("rays"))
        note(at, $(c("error_max")))
    }
    left[how, at] += $(c("undecided")); lefts[how] += $(c("undecided"))
}
END {
    printf "%d sweeps, each towards an edge of what doubles can say, %d rays in all: ", n, all
    print "a far eye, huge and tiny surfaces, roots close together, high degrees, singular points."
    printf "Doubles alone, the bounded tier, leave %.2g %% of them open, ", 100 * lefts["bounded"] / all
    printf "the certified tier %.2g %%. None of their answers, nor of packets, is wrong.\n\n",
        100 * lefts["certified"] / all
    print "| sweep | rays | open, bounded | open, certified | largest error, certified |"
    print "|---|--:|--:|--:|--:|"
    for (i = 1; i <= n; i++) {
        at = sweeps[i]
        printf "| %s | %d | %d | %d | %s |\n", at, rays[at], left["bounded", at], left["certified", at],
            number(most[at] + 0)
    }
    print "\nThe error of t is in units of u kappa |t|, u = 2^-53: what rounding the coefficients and t alone"
    print "may change."
}
