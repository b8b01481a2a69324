# report_table.awk - a small table as it is, for bench/report.
function row(   k, line, cell) {
    for (k = 1; k <= NF; k++) {
        cell = number($k)
        gsub(/[|]/, "\\\\|", cell)
        line = line "| " cell " "
    }
    print line "|"
}
FNR == 2 {
    for (k = 1; k <= NF; k++) { title = title "| " heading[k] " "; rule = rule "|---" }
    print title "|"; print rule "|"
}
{ row() }
