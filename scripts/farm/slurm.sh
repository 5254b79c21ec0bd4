#!/usr/bin/env bash
# slurm.sh PROJECT PATTERN COUNT SHARDS [OPTION …]: submits three dependent jobs to Slurm. The first computes
# the states (PROJECT.states) and resumes when it is requeued, an array of SHARDS jobs renders the frames, and the last one
# names the shards that failed. Repeat those with `scripts/farm/frames.sh … SHARD`, or run this script again, which reuses the
# states. SBATCH_* variables, such as SBATCH_PARTITION, hold the settings of the cluster.
set -eu
if [ $# -lt 4 ]; then
    sed -n 's/^# \{0,1\}//p' "$0" | sed '1d' >&2
    exit 2
fi
project=$1 pattern=$2 count=$3 shards=$4
shift 4
here=$(dirname "$(readlink -f "$0")")
states=${project%.wend}.states
wend=${WEND:-wend}

submit() { sbatch --parsable --export=ALL "$@"; }
quoted() { [ $# -eq 0 ] || printf '%q ' "$@"; }

flow="if [ -e $(quoted "$states")]; then $(quoted "$wend" run "$project" --from "$states" --states "$states");
else $(quoted "$wend" run "$project" --states "$states"); fi"
first=$(submit --requeue --job-name=wend-states --wrap "$flow")
frames="$(quoted "$here/frames.sh" "$project" "$states" "$pattern" "$count" "$shards") \$SLURM_ARRAY_TASK_ID $(quoted "$@")"
second=$(submit --dependency="afterok:$first" --array="1-$shards" --job-name=wend-frames --wrap "$frames")
third=$(submit --dependency="afterany:$second" --job-name=wend-missing --output=wend-missing.txt \
    --wrap "$(quoted "$here/frames.sh" "$project" "$states" "$pattern" "$count" "$shards" missing)")
echo "states: job $first; frames: jobs ${second}_1 to ${second}_$shards; what is missing: job $third, in wend-missing.txt"
