# report_floor.awk - what bench/report says of pictures_floor.csv.
FNR == 2 { first = $(c("kernel")) }
$(c("kernel")) == first { list[++n] = $(c("ratio")) }
END {
    print "Solving a ray takes " times(median(list, n)) " the least it can: a chord, coefficients and their signs."
}
