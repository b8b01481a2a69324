# report_accuracy.awk - what bench/report says of accuracy.csv.
$(c("method")) == "regula-falsi" { falsi += $(c("wrong")); next }
{ wrong += $(c("wrong")) }
$(c("tolerance")) == 0 && $(c("method")) == "default" && $(c("tier")) == "certified" {
    way = $(c("way"))
    if (!(way in most)) ways[++n] = way
    note(way, $(c("ns_median")))
    note("error", $(c("error_99.9")))
}
END {
    printf "All a double can tell of a ray, by the default method in the certified tier, takes"
    for (i = 1; i <= n; i++)
        printf "%s %s ns (%s)", (i > 1 ? "," : ""), range(ways[i]), ways[i]
    printf "; 99.9 %% of the hits are then within %s of the exact place, ", number(most["error"])
    print "on the worst surface."
    printf "Wrong answers, all tolerances together: regula falsi %d; the other methods %d.\n", falsi, wrong
}
