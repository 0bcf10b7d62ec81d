#!/bin/bash
# A fuzz target from its seeds.   run.sh PROGRAM NAME SECONDS FOUND [LIBFUZZER OPTION...]
# FOUND keeps what new ways through the code were found, and crash-* where one ended badly.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) program=$1 name=$2 seconds=$3 found=$4
shift 4
mkdir -p "$found"
dict=()
[ ! -e "$here/$name.dict" ] || dict=("-dict=$here/$name.dict")
exec "$program" "$found" "$here/corpus/$name" "${dict[@]}" -artifact_prefix="$found/" -seed=1 \
  -max_total_time="$seconds" -max_len=8192 -timeout=60 -rss_limit_mb=1024 -print_final_stats=1 \
  -verbosity=0 "$@"
