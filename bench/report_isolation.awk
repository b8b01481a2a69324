# report_isolation.awk - what bench/report says of seed_isolation.csv.
{
    note("proved", $(c("isolation_ns"))); note("bare", $(c("bare_ns"))); wrong += $(c("bare_wrong"))
    note("idle", $(c("idle_ns"))); note("rival", $(c("rival_idle_ns")))
    list[++n] = $(c("isolation_ns")) / $(c("bare_ns"))
}
END {
    printf "Isolation alone takes %s ns a ray. Its algorithm with nothing proved ", range("proved")
    print "(Descartes' rule"
    printf "and halving of Bernstein coefficients in plain double) takes %s ns, ", range("bare")
    printf "the former %s as long (median), and\n", times(median(list, n))
    printf "its brackets are wrong on %d rays of these pictures. What the library does besides: ", wrong
    print "it bounds the"
    print "error of every sign, accepts coefficients of any scale and roots at an end, and checks and guards"
    print "each call. What that buys shows [at the extremes](#at-the-extremes); in packets, rays share it."
    printf "Likewise a call with nothing left to refine takes %s ns, one of the rivals' %s ns:\n",
        range("idle"), range("rival")
    print "the library checks its arguments, guards the floating-point environment and evaluates through"
    print "a pointer; the rivals do not. So one of them can be faster with more evaluations."
}
