# report_contest.awk - what bench/report says of peers.csv and roots.csv: a line for each section.
BEGIN {
    split("pictures:Pictures:pixels;first root:First real roots:roots;interval:All real roots in an interval:roots;" \
        "isolated:Real roots on the line, isolated:polynomials;counted:Real roots counted:polynomials;" \
        "all roots:All complex roots:roots;real families:All complex roots of families with real roots:roots;" \
        "families:All complex roots of other families:roots;complex pictures:Pictures of complex space:", word, ";")
    for (i in word) {
        split(word[i], part, ":")
        title[part[1]] = part[2]
        unit[part[1]] = part[3]
    }
}
{
    kind = $(c("section")); who = $(c("program")); key = kind SUBSEP who
    if (!(kind in seen)) { kinds[++m] = kind; seen[kind] }
    if (!(key in count)) { keys[++n] = key; name[key] = who; of[key] = kind }
    ratio[key, ++count[key]] = $(c("times"))
    wrong[key] += $(c("missed")) + $(c("extra"))
}
function tell(kind,   i, k, key, list, some, middle) {
    printf "- %s:", title[kind]
    for (i = 1; i <= n; i++) {
        key = keys[i]
        if (of[key] != kind || name[key] == "algsurf") continue
        for (k = 1; k <= count[key]; k++) list[k] = ratio[key, k]
        middle = times(median(list, count[key])) # sorts
        printf "%s %s %s (%s to %s)", (some++ ? ";" : ""), name[key], middle, times(list[1]),
            times(list[count[key]])
        if (wrong[key] && unit[kind]) printf ", %d %s wrong", wrong[key], unit[kind]
    }
    print (some ? "." : " nothing is installed to compare with.")
}
END {
    print "The same tasks in one run, in units of the time of algsurf, median over tasks (least to most);"
    print "what the others get wrong is counted.\n"
    for (i = 1; i <= m; i++) tell(kinds[i])
}
