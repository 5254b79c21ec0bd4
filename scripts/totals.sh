# Sourced by ./test and .ci/run. Runs tests and counts their results.

# Qt Test prints "Totals: N passed, N failed, N skipped, …" per program; a program that fails without this line counts once. A
# skipped test counts as failed, and so does a program that did not run.
count_totals() { # RESULTS.xml LOG STATUS: sets passed and failed
    local skipped programs
    read -r passed failed skipped < <(grep -h '^Totals: ' "$1" 2>/dev/null |
        awk '{p += $2; f += $4; s += $6} END {print p + 0, f + 0, s + 0}')
    programs=$(sed -n 's/.* \([0-9][0-9]*\) tests* failed out of.*/\1/p' "$2" | tail -n 1)
    [ "${programs:-1}" -gt "$failed" ] && failed=${programs:-1}
    [ "$3" -ne 0 ] && [ "$failed" -eq 0 ] && failed=1
    if [ "$skipped" -gt 0 ]; then
        echo "$skipped skipped, which counts as failed:"
        grep -h '^SKIP ' "$1" | sort -u
        failed=$((failed + skipped))
    fi
}

say_totals() { # PASSED FAILED: prints the last line of a run; succeeds if nothing failed and something passed
    echo "$1 passed, $2 failed"
    [ "$2" -eq 0 ] && [ "$1" -gt 0 ]
}

run_tests() { # BUILD-FOLDER CTEST-ARGUMENT…: runs ctest without a display; sets passed and failed
    local folder=$1 status
    shift
    export QT_QPA_PLATFORM=offscreen
    export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$folder/run}
    mkdir -p -m 700 "$XDG_RUNTIME_DIR"
    rm -f "$folder/tests.xml"
    ctest --test-dir "$folder" -j "$(nproc)" --output-on-failure --test-output-size-passed 10000000 \
        --output-junit "$folder/tests.xml" "$@" 2>&1 | tee "$folder/tests.log"
    status=${PIPESTATUS[0]}
    count_totals "$folder/tests.xml" "$folder/tests.log" "$status"
}
