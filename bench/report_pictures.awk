# report_pictures.awk - what bench/report says of pictures.csv; size: of the pictures.
{
    way = $(c("manner")); name = $(c("surface"))
    if (FNR == 2) first = way
    if (way == first) { names[++n] = name; degree[name] = $(c("degree")); note("ms", $(c("ms50%")), name) }
    ms[way, name] = $(c("ms50%"))
    threads[way] = $(c("threads"))
}
function ratio(way,   i, list) { # median over surfaces
    for (i = 1; i <= n; i++) list[i] = ms[way, names[i]] / ms[first, names[i]]
    return times(median(list, n))
}
function told(name) { return number(ms[first, name]) " ms (" name ", degree " degree[name] ")" }
END {
    printf "A picture of %s pixels by %s on one thread takes from ", size, first
    printf "%s to %s.\n", told(least_at["ms"]), told(most_at["ms"])
    printf "Compared with that, surface by surface, median: "
    printf "the bounded tier takes %s, %d threads %s, ", ratio("bounded"), threads["all"], ratio("all")
    printf "the instructions every processor has %s, ", ratio("baseline")
    printf "going ray by ray %s.\n", ratio("single")
    printf "Nine samples a pixel take %s, nine on edges only %s", ratio("antialias"), ratio("adaptive")
    print ((("full", names[1]) in ms) ? ", area lights with shadows " ratio("full") "." : ".")
}
