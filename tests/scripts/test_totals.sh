#!/usr/bin/env bash
# Checks how the results of test runs are counted, for runs that are written here: no fault may count as passed.
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../../scripts/totals.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
passed=0 failed=0

check() { # NAME EXPECTED-LAST-LINE EXPECTED-STATUS CTEST-STATUS RESULTS LOG
    local out status
    printf '%s\n' "$5" >"$folder/tests.xml"
    printf '%s\n' "$6" >"$folder/tests.log"
    out=$(count_totals "$folder/tests.xml" "$folder/tests.log" "$4" && say_totals "$passed" "$failed")
    status=$?
    if [ "$(tail -n 1 <<<"$out")" = "$2" ] && [ "$status" = "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAIL!  : %s: status %s and\n%s\n' "$1" "$status" "$out"
    fi
}

good='Totals: 5 passed, 0 failed, 0 skipped, 0 blacklisted, 3ms
Totals: 7 passed, 0 failed, 0 skipped, 0 blacklisted, 3ms'
all='100% tests passed, 0 tests failed out of 2'
check "all is well" "12 passed, 0 failed" 0 0 "$good" "$all"
check "one test failed" "5 passed, 2 failed" 1 8 "Totals: 5 passed, 2 failed, 0 skipped, 0 blacklisted, 3ms" \
    "50% tests passed, 1 tests failed out of 2"
check "a program died" "5 passed, 1 failed" 1 8 "Totals: 5 passed, 0 failed, 0 skipped, 0 blacklisted, 3ms" \
    "50% tests passed, 1 tests failed out of 2"
check "a test was skipped" "5 passed, 3 failed" 1 0 "SKIP   : TestView::initTestCase() needs OpenGL
Totals: 5 passed, 0 failed, 3 skipped, 0 blacklisted, 3ms" "100% tests passed, 0 tests failed out of 1"
check "nothing ran" "0 passed, 1 failed" 1 8 "" "No tests were found!!!"
check "ctest failed without saying why" "12 passed, 1 failed" 1 8 "$good" "$all"

echo "Totals: $passed passed, $failed failed, 0 skipped"
[ "$failed" -eq 0 ]
