#!/usr/bin/env bash
# parallel.sh PROJECT PATTERN COUNT SHARDS [OPTION …]: computes the states of a project, resuming an earlier run, and renders its
# frames with GNU parallel: on this machine, or on those that PARALLEL names (PARALLEL='--sshloginfile machines --wd .', with the
# files on a shared disk). Without GNU parallel, plain processes render the shards, one for each processor.
# Finally names the shards that failed and exits with 1 if there are any.
set -eu
if [ $# -lt 4 ]; then
    sed -n 's/^# \{0,1\}//p' "$0" | sed '1d' >&2
    exit 2
fi
project=$1 pattern=$2 count=$3 shards=$4
shift 4
here=$(dirname "$(readlink -f "$0")")
states=${project%.wend}.states

from=()
[ -e "$states" ] && from=(--from "$states")
"${WEND:-wend}" run "$project" "${from[@]}" --states "$states"

job=("$here/frames.sh" "$project" "$states" "$pattern" "$count" "$shards")
if command -v parallel >/dev/null; then
    seq "$shards" | parallel --quote "${job[@]}" {} --threads 1 "$@" || true
else
    seq "$shards" | xargs -P "$(nproc)" -I {} "${job[@]}" {} --threads 1 "$@" || true
fi
exec "${job[@]}" missing
