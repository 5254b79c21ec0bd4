# Sourced by .ci/run and scripts/check-all. Runs the tests under a sanitizer in the groups of scripts/sanitized.txt.

export ASAN_OPTIONS=detect_leaks=0:abort_on_error=0:allocator_may_return_null=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export QTEST_FUNCTION_TIMEOUT=3000000 # milliseconds: ten times the usual
export TSAN_OPTIONS=ignore_noninstrumented_modules=1:halt_on_error=1:second_deadlock_stack=1:suppressions=$root/scripts/tsan.supp

listed() { # KIND: prints the names on the lines of that kind
    sed -n "s/^$1 //p" "$root/scripts/sanitized.txt"
}

left_out() { # BUILD-FOLDER: prints the tests that do not run under its sanitizer
    listed "\(not\|not-$(basename "$1")\)"
}

tests_of() { # BUILD-FOLDER: prints the names of all tests
    ctest --test-dir "$1" -N | sed -n 's/^ *Test *#[0-9]*: //p'
}

# Prints the groups, one per line, each after the target that it needs: `wend` or nothing. The last group holds all tests that no
# line names; tests that are left out are in no group.
groups_of() { # BUILD-FOLDER [ci]: with ci only the groups of .ci/run
    local all named kind group
    all=$(tests_of "$1")
    named=" $(listed '\(group\|parts\|ci\)' | tr '\n' ' ') $(left_out "$1" | sed 's/ .*//' | tr '\n' ' ') "
    for kind in ${2:-ci parts group}; do
        while read -r -a group; do
            [ "$kind" = group ] && printf 'wend '
            for name in "${group[@]}"; do
                grep -qx "$name" <<<"$all" && ! left_out "$1" | grep -q "^$name " && printf '%s ' "$name"
            done
            echo
        done < <(listed "$kind")
    done
    [ -n "$2" ] && return
    printf 'wend '
    for name in $all; do case "$named" in *" $name "*) ;; *) printf '%s ' "$name" ;; esac; done
    echo
}

# Builds these targets within the given seconds and runs those that are tests; sets passed and failed. Fails without setting them
# if the build ran out of time: a slow machine keeps the results that it has.
run_group() { # BUILD-FOLDER SECONDS NAME…
    local folder=$1 time=$2 targets=(wend-tetgen wend-cage) status
    shift 2
    # A test without a program of its own is a script, or runs the program of another test again.
    mapfile -t -O 1 targets < <(ninja -C "$folder" -t targets all | sed 's/:.*//' | grep -xF -f <(printf '%s\n' "$@"))
    passed=0 failed=1
    NINJA_STATUS='[%f/%t] ' timeout --foreground "$time" ninja -C "$folder" "${targets[@]}" 2>&1 | narrate_build >&2
    status=${PIPESTATUS[0]}
    [ "$status" -eq 124 ] && { failed=0; return 1; }
    [ "$status" -eq 0 ] || return 0
    run_tests "$folder" -R "^($(IFS='|'; echo "$*"))\$"
    return 0
}

sanitize() { # PRESET LAST-MINUTE [ci]: names groups that are not built by then and skips them; sets all_passed and all_failed
    local folder=$root/build/$1 group left late=()
    all_passed=0 all_failed=0
    configure "$1" || { all_failed=1; return; }
    while read -r -a group; do
        [ "${#group[@]}" -eq 0 ] && continue
        left=$((60 * $2 - SECONDS))
        if [ "$left" -le 0 ] || ! run_group "$folder" "$left" "${group[@]}"; then late+=("${group[@]}"); continue; fi
        all_passed=$((all_passed + passed)) all_failed=$((all_failed + failed))
        echo "$1: $all_passed passed, $all_failed failed after $((SECONDS / 60)) minutes: ${group[*]}"
    done < <(groups_of "$folder" "$3")
    [ "${#late[@]}" -gt 0 ] && echo "$1: not run, for lack of time: ${late[*]}"
    [ -n "$3" ] && echo "$1: left to scripts/check-all: $(tests_of "$folder" | grep -vxF -f <(listed "$3" | tr ' ' '\n'; left_out "$folder" | sed 's/ .*//') | tr '\n' ' ')"
    left_out "$folder" | sed "s/^/$1: left out: /"
}
