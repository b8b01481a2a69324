# report_verified_roots.awk - what bench/report says of verified_roots.csv.
$(c("cluster")) == "" { # clusters are told by their chart
    name = $(c("surface")); who = $(c("solver")) " " $(c("start"))
    us[who, name] = $(c("us50%")); degree[name] = $(c("degree"))
    count[who]++
    whole[who] += $(c("complete%"))
    ulps[who, count[who]] = $(c("ulps50%"))
    if (who == "robust cold") { names[++n] = name; note("us", us[who, name], name) }
}
function ratio(who, other,   i, k, list) { # median over what both have solved
    for (i = 1; i <= n; i++)
        if (((who, names[i]) in us) && us[other, names[i]] > 0)
            list[++k] = us[who, names[i]] / us[other, names[i]]
    return times(median(list, k))
}
function width(who,   i, list) {
    for (i = 1; i <= count[who]; i++) list[i] = ulps[who, i]
    return number(median(list, count[who]))
}
function told(name) { return number(us["robust cold", name]) " us (" name ", degree " degree[name] ")" }
END {
    printf "All complex roots of a polynomial in boxes that are proved to hold them, from %s ",
        told(least_at["us"])
    printf "to %s: complete for %.4g %% of the polynomials, ", told(most_at["us"]),
        whole["robust cold"] / count["robust cold"]
    printf "width of the boxes in units in the last place, median: %s.\n", width("robust cold")
    printf "The algorithm of Sanjuan-Estrada, Casado and Garcia takes %s as long, ",
        ratio("paper cold", "robust cold")
    printf "is complete for %.4g %%, ", whole["paper cold"] / count["paper cold"]
    printf "width of its boxes: %s units.\n", width("paper cold")
    printf "Starting with the roots of the neighbouring ray takes %s the time of a cold start, ",
        ratio("robust near", "robust cold")
    printf "for their algorithm %s.\n", ratio("paper near", "paper cold")
}
