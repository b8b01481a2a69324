# report_pivot.awk - for bench/report: a line for each value of column `row`, a column for each of column
# `across` but `without`, in them column `value`, where it is not empty and, if `where` names a column, that
# one is `is`; heads: columns in words.
$(c(value)) == "" || $(c(across)) == without || (where != "" && $(c(where)) != is) { next }
{
    this = $(c(row)); that = $(c(across))
    if (!(this in line)) { line[this] = 1; lines[++n] = this }
    if (!(that in over)) { over[that] = 1; overs[++m] = that }
    cell[this, that] = $(c(value))
}
END {
    title = "| " head(row) " "; rule = "|---"
    for (k = 1; k <= m; k++) { title = title "| " head(overs[k]) " "; rule = rule "|--:" }
    print title "|"; print rule "|"
    for (i = 1; i <= n; i++) {
        text = "| " lines[i] " "
        for (k = 1; k <= m; k++) text = text "| " number(cell[lines[i], overs[k]]) " "
        print text "|"
    }
}
