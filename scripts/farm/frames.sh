#!/usr/bin/env bash
# frames.sh PROJECT STATES PATTERN COUNT SHARDS WHICH [OPTION …]: writes a part of COUNT frames from the states of a finished run
# (`wend run PROJECT --states STATES`). PATTERN has #### for the number. WHICH is
#   1 … SHARDS   that part
#   rank         the part of this process under mpirun or srun, one process for each part
#   missing      names the parts with missing frames, writes nothing, and exits with 1 if there are any
# Options go to `wend run`, such as --canvas fit. The program is $WEND, or wend.
set -eu
if [ $# -lt 6 ]; then
    sed -n 's/^# \{0,1\}//p' "$0" | sed '1d' >&2
    exit 2
fi
project=$1 states=$2 pattern=$3 count=$4 shards=$5 which=$6
shift 6

# Divides the frames as `wend run --shard` does.
first_of() { echo $((($1 - 1) * count / shards)); }
name_of() { # the last sequence of # stands for the number
    local digits before after width
    after=${pattern##*\#}
    before=${pattern%"$after"}
    digits=${before##*[!#]}
    before=${before%"$digits"}
    width=${#digits}
    printf "%s%0${width}d%s" "$before" "$1" "$after"
}

if [ "$which" = missing ]; then
    lost=0
    for ((shard = 1; shard <= shards; ++shard)); do
        first=$(first_of "$shard") end=$(first_of $((shard + 1)))
        for ((frame = first; frame < end; ++frame)); do
            [ -s "$(name_of "$frame")" ] && continue
            echo "shard $shard of $shards: frames $first to $((end - 1)) are missing"
            lost=1
            break
        done
    done
    exit "$lost"
fi
if [ "$which" = rank ]; then
    rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${PMIX_RANK:-${SLURM_PROCID:-}}}}
    [ -n "$rank" ] || { echo "frames.sh: there is no rank: not started by mpirun or srun" >&2; exit 2; }
    which=$((rank + 1))
fi
exec "${WEND:-wend}" run "$project" --from "$states" --frames "$pattern" --count "$count" --shard "$which/$shards" "$@"
