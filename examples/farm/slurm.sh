#!/bin/bash
# A campaign in eight parts on Slurm: sbatch slurm.sh, from this folder.
#SBATCH --job-name=radcomp
#SBATCH --array=1-8
#SBATCH --cpus-per-task=4
#SBATCH --time=02:00:00
#SBATCH --requeue
set -eu
export DEVICE=${DEVICE:-builtin} PROFILE=${PROFILE:-seed-mill} LEVEL=${LEVEL:-2} REPORTS=${REPORTS:-reports}

sh shard.sh "$SLURM_ARRAY_TASK_ID" "$SLURM_ARRAY_TASK_COUNT"
