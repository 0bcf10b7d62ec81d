#!/bin/bash
# A batch as an array of Slurm jobs, a shard each:
#
#   sbatch --array=1-20 examples/batch/slurm.sh JOB.yaml DIR      DIR lies on a disk that all nodes see
#
# The array's numbers are 1 to the number of shards. A job whose node dies, or that is preempted, goes back into the queue
# (--requeue) and makes what is missing; so does one that is submitted again. AMBLE is the program, where it is not on PATH.
#SBATCH --job-name=amble-batch
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --cpus-per-task=1
set -euo pipefail
if [ $# != 2 ] || [ -z "${SLURM_ARRAY_TASK_COUNT:-}" ] || [ "$SLURM_ARRAY_TASK_MIN" != 1 ] ||
  [ "$SLURM_ARRAY_TASK_MAX" != "$SLURM_ARRAY_TASK_COUNT" ]; then
  echo "sbatch --array=1-SHARDS $(basename "$0") JOB.yaml DIR" >&2
  exit 2
fi
exec "${AMBLE:-amble}" batch "$1" -o "$2" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --threads "${SLURM_CPUS_PER_TASK:-1}"
