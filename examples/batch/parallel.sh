#!/bin/bash
# A batch by GNU parallel, a shard for each core of this machine at a time, or on several machines:
#
#   examples/batch/parallel.sh JOB.yaml DIR SHARDS [PARALLEL OPTION...]     e.g. --jobs 4, --sshloginfile nodes.txt --workdir .
#
# A shard that fails, or whose machine does not answer, is tried again, elsewhere if there is another; what is made stays made.
# DIR lies on a disk that all machines see. DIR/log/shards.txt says how each try went. AMBLE is the program; without it the one
# on PATH, or this clone's.
set -euo pipefail
if [ $# -lt 3 ]; then
  sed -n '2,7s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
job=$1 dir=$2 shards=$3
shift 3
clone=$(cd "$(dirname "$0")/../.." && pwd)
export AMBLE=${AMBLE:-$(command -v amble || echo "$clone/build/release/app/amble")}
"$AMBLE" batch status "$job" -o "$dir" >/dev/null || [ $? = 1 ] || exit 2  # it says what is wrong
mkdir -p "$dir/log"
# --quote: names may have blanks. One thread a shard, since a shard has one core.
seq "$shards" | parallel --quote --retries 3 --joblog "$dir/log/shards.txt" "$@" \
  "$AMBLE" batch "$job" -o "$dir" --shard "{}/$shards" --threads 1
"$AMBLE" batch merge "$job" -o "$dir"
