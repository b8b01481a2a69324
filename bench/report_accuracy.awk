# report_accuracy.awk - what bench/report says of accuracy.csv.
$(c("method")) == "regula-falsi" { falsi += $(c("wrong")); next }
{ wrong += $(c("wrong")) }
$(c("tolerance")) == 0 && $(c("method")) == "default" && $(c("tier")) == "certified" {
    way = $(c("way")); ns = $(c("ns_median")) + 0
    if (!(way in most)) { ways[++n] = way; least[way] = ns }
    if (ns < least[way]) least[way] = ns
    if (ns > most[way]) most[way] = ns
    if ($(c("error_99.9")) + 0 > worst) worst = $(c("error_99.9")) + 0
}
END {
    printf "All a double can tell of a ray, by the default method in the certified tier, takes"
    for (i = 1; i <= n; i++)
        printf "%s %s to %s ns (%s)", (i > 1 ? "," : ""), number(least[ways[i]]), number(most[ways[i]]),
            ways[i]
    printf "; 99.9 %% of the hits are then within %s of the exact place, ", number(worst)
    print "on the worst surface."
    printf "Wrong answers, all tolerances together: regula falsi %d; the other methods %d.\n", falsi, wrong
}
