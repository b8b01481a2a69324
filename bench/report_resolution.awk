# report_resolution.awk - what bench/report says of resolution.csv.
{
    name = $(c("surface")); ns = $(c("ns_ray")); left = $(c("rows_percent")) + $(c("single_percent"))
    if (!(name in first)) { names[++n] = name; first[name] = ns; from = $(c("width")) }
    last[name] = ns; to = $(c("width")); rest[name] = left
}
END {
    printf "Tiles of pixels are proved empty, or to see one sheet of the surface, at once; outlines are left,\n"
    printf "which grow with the width of a picture, not with its area. From %s to %s pixels a row ", from, to
    printf "the time of a ray falls from"
    for (i = 1; i <= n; i++) {
        name = names[i]
        printf "%s %s to %s ns (%s)", (i > 1 ? "," : ""), number(first[name]), number(last[name]), name
    }
    printf ";\nin the last of these pictures tiles leave"
    for (i = 1; i <= n; i++) printf "%s %.3g %%", (i > 1 ? "," : ""), rest[names[i]]
    print " of the rays."
}
