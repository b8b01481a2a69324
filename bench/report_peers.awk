# report_peers.awk - what bench/report says of peers.csv.
{
    kind = $(c("section")); who = $(c("program")); key = kind SUBSEP who
    if (!(key in count)) { keys[++n] = key; name[key] = who; of[key] = kind }
    ratio[key, ++count[key]] = $(c("times"))
    wrong[key] += $(c("missed")) + $(c("extra"))
}
function tell(title, kind, unit,   i, k, key, list, some) {
    printf "- %s:", title
    for (i = 1; i <= n; i++) {
        key = keys[i]
        if (of[key] != kind || name[key] == "algsurf") continue
        for (k = 1; k <= count[key]; k++) list[k] = ratio[key, k]
        printf "%s %s %s", (some++ ? "," : ""), name[key], times(median(list, count[key]))
        if (wrong[key]) printf " (%d %s wrong)", wrong[key], unit
    }
    print (some ? "." : " nothing is installed to compare with.")
}
END {
    print "The same tasks in one run, in units of the time of algsurf, median over tasks; what the others"
    print "get wrong is counted.\n"
    tell("Pictures", "pictures", "pixels")
    tell("First real roots", "first root", "roots")
    tell("All complex roots", "all roots", "roots")
}
