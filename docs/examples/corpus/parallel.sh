#!/bin/bash
# Checks a folder of models by GNU parallel, on this machine or on several; docs/corpora.md.
#
#   docs/examples/corpus/parallel.sh MODELS FOUND [SHARDS [OPTION OF PARALLEL]...]
#   docs/examples/corpus/parallel.sh /data/models /data/found 400 --sshlogin node1,node2
#
# Without SHARDS there are eight for each processor.  Given again, it goes on where it was stopped; --retries takes a shard
# to another machine where one is lost.
set -eu
models=${1:?the folder of models} found=${2:?where the lines go} shards=${3:-$((8 * $(nproc)))}
shift $(($# < 3 ? $# : 3))

seq "$shards" | parallel --retries 3 --line-buffer "$@" \
  "${PLUMB:-plumb}" check "$(realpath "$models")" --shard "{}/$shards" --out "$(realpath -m "$found")" \
  --time-limit 600 --memory-limit 2048
"${PLUMB:-plumb}" collect "$found"
