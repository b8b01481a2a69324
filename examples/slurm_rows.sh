#!/bin/sh
# slurm_rows.sh - a picture drawn by many machines: a Slurm array, each task of which draws a slice of rows.
#
#     array=$(sbatch --parsable --array=0-15 slurm_rows.sh slices 16 8192x8192 barth --quality full)
#     sbatch --dependency=afterok:$array --wrap 'render --join --output barth.png slices/slice-*.ppm'
#
# Arguments: a folder that all machines see, the number of slices, the size, and what render is to draw.
# Task K draws slice K, from 0.  What a broken task leaves out, render --join tells; it is drawn by
# sbatch --array=K with the same arguments.  RENDER names the program where it is not on the path.  Bad
# arguments: one line on standard error, exit status 2.
#SBATCH --job-name=algsurf-rows
#SBATCH --cpus-per-task=4
#SBATCH --time=01:00:00
set -eu
usage() {
    echo "usage: slurm_rows.sh FOLDER SLICES WIDTHxHEIGHT SURFACE [OPTION ...], as a Slurm array: $1" >&2
    exit 2
}
whole() { case $1 in '' | *[!0-9]* | 0?* | ??????*) return 1 ;; esac; } # 0 to 99999, read as decimal below

[ $# -ge 4 ] && [ -n "$1" ] || usage "$# arguments"
folder=$1 slices=$2 size=$3
shift 3
width=${size%%x*} height=${size#*x}
whole "$slices" && [ "$slices" -gt 0 ] || usage "SLICES is not a number from 1 to 99999"
[ "${width}x$height" = "$size" ] && whole "$width" && whole "$height" && [ "$width" -gt 0 ] &&
    [ "$height" -gt 0 ] || usage "WIDTHxHEIGHT is not a size"
whole "${SLURM_ARRAY_TASK_ID-}" && [ "$SLURM_ARRAY_TASK_ID" -lt "$slices" ] ||
    usage "SLURM_ARRAY_TASK_ID is not a number below SLICES"
first=$((SLURM_ARRAY_TASK_ID * height / slices))
end=$(((SLURM_ARRAY_TASK_ID + 1) * height / slices))
[ "$first" -lt "$end" ] || exit 0 # more slices than rows
mkdir -p "$folder"
slice=$folder/slice-$SLURM_ARRAY_TASK_ID
"${RENDER:-render}" "$@" --size "$size" --rows "$first:$end" --threads "${SLURM_CPUS_PER_TASK:-1}" \
    --progress never --output "$slice.ppm" --hits "$slice.hits" || {
    status=$?
    rmdir "$folder" 2>/dev/null || : # a refusal leaves nothing; a folder with other tasks' slices stays
    exit $status
}
