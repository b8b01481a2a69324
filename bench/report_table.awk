# report_table.awk - a small table as it is, for bench/report; heads: its headings in words.
function row(   k, line, cell) {
    for (k = 1; k <= NF; k++) {
        cell = number($k)
        gsub(/[|]/, "\\\\|", cell)
        line = line "| " cell " "
    }
    print line "|"
}
FNR == 2 {
    for (k = 1; k <= NF; k++) {
        title = title "| " head(heading[k]) " "
        rule = rule ($k ~ /^[-+.0-9]/ ? "|--:" : "|---")
    }
    print title "|"; print rule "|"
}
{ row() }
