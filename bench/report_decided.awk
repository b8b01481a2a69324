# report_decided.awk - what bench/report says of decided.csv.
{
    kind = $(c("kind")); rays += $(c("rays")); left += $(c("open"))
    if (kind == "clear" || $(c("times")) == "-") next
    if (!(kind in n)) kinds[++m] = kind
    ratio[kind, ++n[kind]] = $(c("times"))
}
END {
    printf "%d rays whose answers are known from how they were made: clear ones, and rays ", rays
    print "that begin at the double before their root,"
    print "meet two roots 2^-20, 2^-60 and 2^-200 apart, touch, meet only double roots (P = Q^2), lie in"
    printf "the surface, or in an extent that is the surface. All are decided, with multiplicities; "
    printf "doubles alone leave %.3g %%\nof them open. In units of the time of a clear ray ", 100 * left / rays
    printf "by doubles alone, median over degrees:"
    for (i = 1; i <= m; i++) {
        for (k = 1; k <= n[kinds[i]]; k++) list[k] = ratio[kinds[i], k]
        printf "%s %s %s", (i > 1 ? "," : ""), kinds[i], times(median(list, n[kinds[i]]))
    }
    print "."
}
