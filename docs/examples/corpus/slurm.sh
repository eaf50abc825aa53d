#!/bin/bash
# Checks a folder of models as an array of Slurm, one shard a task; docs/corpora.md.
#
#   export MODELS=/data/models FOUND=/data/found SHARDS=400
#   sbatch --array=1-400 docs/examples/corpus/slurm.sh
#
# A task that was ended (its time, its machine) goes on where it was when it is given again, alone too (--array=7,31): what
# is done is not done twice.  --requeue lets Slurm do that by itself where a machine is lost.
#SBATCH --job-name=plumb-corpus
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --mem=3G
#SBATCH --time=04:00:00
#SBATCH --requeue
#SBATCH --output=plumb-%A-%a.txt

set -eu
: "${MODELS:?is the folder of models}" "${FOUND:?is where the lines go}" "${SHARDS:?is how many}"

# Below --mem, so that a model that takes too much is a line and not the end of the task.
exec "${PLUMB:-plumb}" check "$MODELS" --shard "$SLURM_ARRAY_TASK_ID/$SHARDS" --out "$FOUND" \
  --time-limit 600 --memory-limit 2048
