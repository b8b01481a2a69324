# report_evaluations.awk - what bench/report says of seed_evaluations.csv.
{
    way = $(c("method")); surface = $(c("surface"))
    if (!(way in sum)) ways[++n] = way
    if (!(surface in seen)) {
        surfaces[++m] = surface; seen[surface]
        expected += 2 + log($(c("width")) / 2e-7) / log(2) + 0.5 # rounded up: half a step, on average
        note("width", $(c("width")))
        note("share", 100 * $(c("brackets")) / $(c("rays")))
    }
    sum[way] += $(c("a_root")); sum_ray[way] += $(c("a_ray")); each[way, surface] = $(c("a_root"))
}
function list_of(total,   i, text) {
    for (i = 1; i <= n; i++)
        text = text sprintf("%s %s %.1f", (i > 1 ? "," : ""), ways[i], total[ways[i]] / m)
    return text
}
function order(list, k, surface,   i, j, x) { # of the ways in list, least first; on a surface, or (0) all
    for (i = 2; i <= k; i++) {
        x = list[i]
        for (j = i - 1; j > 0 && at(list[j], surface) > at(x, surface); j--) list[j + 1] = list[j]
        list[j + 1] = x
    }
    x = list[1]
    for (i = 2; i <= k; i++) x = x ", " list[i]
    return x
}
function at(way, surface) { return surface == "" ? sum[way] : each[way, surface] }
function mixed(   i, text) { # surfaces with another order than overall
    for (i = 1; i <= m; i++)
        if (order(rival, k, surfaces[i]) != usual) text = text (text ? ", " : "") surfaces[i]
    return text
}
END {
    print "Counted from the bracket that isolation leaves until half of it is at most 1e-7, both ends"
    printf "included; "
    printf "lengths are in half chords (a ray inside the extent is 2 long), and brackets %s wide, ", range("width")
    print "geometric mean by surface."
    printf "For each root, mean over surfaces:%s.\n", list_of(sum)
    printf "Bisection has no choice: 2 + log2(width / 2e-7), rounded up, is %.1f for these widths.\n\n",
        expected / m
    printf "Averaged over all rays that meet the extent instead, of which %.0f to %.0f %% have a ",
        least["share"], most["share"]
    printf "bracket and the\nothers cost nothing here:%s. Counts *a ray*\n", list_of(sum_ray)
    print "compare with these, counts *a root* with those above; both depend on the view.\n"
    for (i = 1; i <= n; i++)
        if (ways[i] !~ /^(bisection|regula falsi|default)$/) rival[++k] = ways[i]
    if (k > 1) {
        usual = order(rival, k, "")
        other = mixed()
        printf "Least first: %s%s.\n", usual, other ? "; on " other " in another order" : ""
    }
    print "The default's count is of P with its derivative, about two evaluations of the others, which ask"
    print "for P alone. Regula falsi would count more: it stops where two points agree, near the root or not."
}
