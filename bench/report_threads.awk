# report_threads.awk - how many threads the pictures of pictures.csv by all of them had, for bench/report.
$(c("manner")) == "all" { threads = $(c("threads")) }
END { print threads }
