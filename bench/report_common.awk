# report_common.awk - tables for bench/report: columns by their names, numbers as people write them.
function c(name) { # $(c("name")) is the cell in the column of that name
    if (!(name in column)) {
        print FILENAME ": no column " name >"/dev/stderr"
        exit 3
    }
    return column[name]
}
function number(x, size) {
    if (x !~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/) return x
    size = x < 0 ? -x : x
    if (size < 1e7 && (size == int(size) || size >= 100)) return sprintf("%.0f", x)
    return sprintf("%.3g", x)
}
function median(list, n,   i, j, x) {
    for (i = 2; i <= n; i++) {
        x = list[i]
        for (j = i - 1; j > 0 && list[j] + 0 > x + 0; j--) list[j + 1] = list[j]
        list[j + 1] = x
    }
    return n % 2 ? list[(n + 1) / 2] : (list[n / 2] + list[n / 2 + 1]) / 2
}
function note(what, x, at) { # the least and the largest of it, and at which they are
    if (!(what in least) || x + 0 < least[what] + 0) { least[what] = x; least_at[what] = at }
    if (!(what in most) || x + 0 > most[what] + 0) { most[what] = x; most_at[what] = at }
}
function range(what) { return number(least[what]) " to " number(most[what]) }
function times(x) { return sprintf(x < 10 ? "%.2fx" : x < 100 ? "%.1fx" : "%.0fx", x) }
function head(name,   i, k, pair) { # in words, if heads, "name=words;name=words", has any
    if (!told_heads++)
        for (i = split(heads, pair, ";"); i > 0; i--) {
            k = index(pair[i], "=")
            words[substr(pair[i], 1, k - 1)] = substr(pair[i], k + 1)
        }
    return name in words ? words[name] : name
}
FNR == 1 { for (i = 1; i <= NF; i++) column[heading[i] = $i] = i; next }
