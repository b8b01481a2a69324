#!/bin/sh
# slurm_rows.sh - a picture drawn by many machines: a Slurm array, each task of which draws a slice of rows.
#
#     array=$(sbatch --parsable --array=0-15 slurm_rows.sh slices 16 8192x8192 barth --quality full)
#     sbatch --dependency=afterok:$array --wrap 'render --join --output barth.png slices/slice-*.ppm'
#
# Arguments: a folder that all machines see, the number of slices, the size, and what render is to draw.
# Task K draws slice K, from 0.  What a broken task leaves out, render --join tells; it is drawn by
# sbatch --array=K with the same arguments.  RENDER names the program where it is not on the path.
#SBATCH --job-name=algsurf-rows
#SBATCH --cpus-per-task=4
#SBATCH --time=01:00:00
set -eu
folder=$1 slices=$2 size=$3
shift 3
height=${size#*x}
first=$((SLURM_ARRAY_TASK_ID * height / slices))
end=$(((SLURM_ARRAY_TASK_ID + 1) * height / slices))
[ "$first" -lt "$end" ] || exit 0 # more slices than rows
mkdir -p "$folder"
exec "${RENDER:-render}" "$@" --size "$size" --rows "$first:$end" --threads "${SLURM_CPUS_PER_TASK:-1}" \
    --progress never --output "$folder/slice-$SLURM_ARRAY_TASK_ID.ppm" --hits "$folder/slice-$SLURM_ARRAY_TASK_ID.hits"
