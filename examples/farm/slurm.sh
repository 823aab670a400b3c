#!/bin/sh
# Slurm array: one task for every ten frames of a shot file.
#
#     sbatch --array=1-200:10%20 examples/farm/slurm.sh shot.json 1-200
#
# The step of the array is the frames a task does, %20 how many tasks run at once. --within leaves out what the last task has too many,
# and a task that is sent again does only what is not done.
#SBATCH --job-name=burnish
#SBATCH --cpus-per-task=2
#SBATCH --time=01:00:00
set -eu
shot=$1 range=$2

first=$SLURM_ARRAY_TASK_ID
last=$((first + ${SLURM_ARRAY_TASK_STEP:-1} - 1))
exec burnish sequence "$shot" --frames "$first-$last" --within "$range" --threads "${SLURM_CPUS_PER_TASK:-0}"
