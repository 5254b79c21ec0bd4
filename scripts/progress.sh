# Sourced by setup.sh. Reports the progress of a build: in one changing line on a terminal, elsewhere in a line for every tenth.
# The clock serves the reports only; nothing depends on it.

seconds_per_step=5 # of one core, measured without ccache; an estimate for the first line

minutes_of() { # STEPS: estimates their time on this machine in whole minutes
    awk -v steps="$1" -v each="$seconds_per_step" -v cores="$(nproc)" \
        'BEGIN {m = steps * each / cores / 60; print (m > 1 ? int(m + 0.5) : 1)}'
}

announce_build() { # STEPS WHEN: prints one line once the number of steps is known; nothing for a few files
    local minutes cores what="Building what changed"
    [ "$1" -lt 20 ] && return
    minutes=$(minutes_of "$1")
    cores=$(nproc)
    [ "$2" = first ] && what="First build"
    echo "$what: $1 steps, about $minutes minute$([ "$minutes" = 1 ] || echo s) on $cores core$([ "$cores" = 1 ] || echo s)" \
        "(less where ccache has seen them)."
}

step_name() { # DESCRIPTION: puts ninja's description of a step into plain words
    local text=$1
    case "$text" in
    "Building CXX object "*cmake_pch*) text="headers that most files include" ;;
    "Building CXX object "*/Unity/unity_*)
        text=${text#Building CXX object }
        text="several files of ${text%%/CMakeFiles/*}" ;;
    "Building CXX object "*)
        text=${text#Building CXX object }
        text=${text%.o}
        text=${text/CMakeFiles\/*.dir\//} ;;
    "Linking CXX executable "*) text="linking ${text#Linking CXX executable }" ;;
    "Linking CXX static library "*) text="linking ${text##*/}" ;;
    "Automatic MOC"*) text="Qt's code for ${text##* }" ;;
    esac
    echo "$text"
}

time_left() { # SECONDS DONE TOTAL: prints nothing until the pace is known
    [ "$2" -lt 20 ] || [ "$2" -ge "$3" ] && return
    local left=$(($1 * ($3 - $2) / $2))
    [ "$left" -lt 5 ] && return
    if [ "$left" -ge 90 ]; then echo ", about $(((left + 30) / 60)) minutes left"; else echo ", about $left seconds left"; fi
}

# Reads what ninja prints. Lines of "[n/m] what" become progress; all others (warnings, errors) stay as they are.
narrate_build() { # WHEN: first or again
    local line done_ total tenth=0 now begin=$SECONDS width=80 changing= announced=
    if [ -t 2 ]; then
        changing=1
        width=$(stty size <&2 2>/dev/null | cut -d ' ' -f 2)
        [ "${width:-0}" -gt 20 ] || width=80
    fi
    while IFS= read -r line; do
        if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\ (.*)$ ]]; then
            done_=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
            if [ -z "$announced" ] && [ "$total" -ge 20 ]; then
                announced=1
                [ -n "$changing" ] && printf '\r\033[K'
                announce_build "$total" "$1"
            fi
            if [ -n "$changing" ]; then
                now="[$done_/$total] $(step_name "${BASH_REMATCH[3]}")$(time_left $((SECONDS - begin)) "$done_" "$total")"
                printf '\r\033[K%s' "${now:0:$((width - 1))}"
            elif [ "$((10 * done_ / total))" -gt "$tenth" ] && [ "$total" -ge 20 ]; then
                tenth=$((10 * done_ / total))
                echo "Built $done_ of $total$(time_left $((SECONDS - begin)) "$done_" "$total")."
            fi
        elif [ "$line" != "ninja: no work to do." ] && [[ $line != "ninja: Entering directory"* ]]; then
            [ -n "$changing" ] && printf '\r\033[K'
            printf '%s\n' "$line"
        fi
    done
    [ -n "$changing" ] && printf '\r\033[K'
    return 0
}
