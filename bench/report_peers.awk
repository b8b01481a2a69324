# report_peers.awk - what bench/report says of peers.csv.
{
    kind = $(c("section")); who = $(c("program")); key = kind SUBSEP who
    if (!(key in count)) { keys[++n] = key; name[key] = who; of[key] = kind }
    ratio[key, ++count[key]] = $(c("times"))
    wrong[key] += $(c("missed")) + $(c("extra"))
}
function tell(title, kind, unit,   i, k, key, list, some, middle) {
    printf "- %s:", title
    for (i = 1; i <= n; i++) {
        key = keys[i]
        if (of[key] != kind || name[key] == "algsurf") continue
        for (k = 1; k <= count[key]; k++) list[k] = ratio[key, k]
        middle = times(median(list, count[key])) # sorts
        printf "%s %s %s (%s to %s)", (some++ ? "," : ""), name[key], middle, times(list[1]),
            times(list[count[key]])
        if (wrong[key]) printf ", %d %s wrong", wrong[key], unit
    }
    print (some ? "." : " nothing is installed to compare with.")
}
END {
    print "The same tasks in one run, in units of the time of algsurf, median over tasks (least to most);"
    print "what the others get wrong is counted.\n"
    tell("Pictures", "pictures", "pixels")
    tell("First real roots", "first root", "roots")
    tell("All complex roots", "all roots", "roots")
}
