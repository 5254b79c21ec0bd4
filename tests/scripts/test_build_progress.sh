#!/usr/bin/env bash
# Checks the progress of a build without a terminal: few lines, in order, and the complete output of the compiler.
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../../scripts/progress.sh"
passed=0 failed=0

expect() { # NAME ACTUAL EXPECTED
    if [ "$2" = "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAIL!  : %s\n   is:\n%s\n   should be:\n%s\n' "$1" "$2" "$3"
    fi
}

ninja_says() {
    echo "[0/2] Re-checking globbed directories..."
    for i in $(seq 1 30); do
        echo "[$i/30] Building CXX object core/mesh/CMakeFiles/wend_mesh.dir/part_$i.cpp.o"
        [ "$i" = 13 ] && printf 'FAILED: part_13.cpp.o\npart_13.cpp:7:  error: "x" [was]  not * declared\\n\n'
    done
    echo "ninja: build stopped: subcommand failed."
}

told=$(time_left() { :; }; nproc() { echo 2; }; ninja_says | narrate_build first 2>/dev/null)
expect "announced, tenths and errors" "$told" 'First build: 30 steps, about 1 minute on 2 cores (less where ccache has seen them).
Built 3 of 30.
Built 6 of 30.
Built 9 of 30.
Built 12 of 30.
FAILED: part_13.cpp.o
part_13.cpp:7:  error: "x" [was]  not * declared\n
Built 15 of 30.
Built 18 of 30.
Built 21 of 30.
Built 24 of 30.
Built 27 of 30.
Built 30 of 30.
ninja: build stopped: subcommand failed.'
expect "nothing to do is not told" "$(echo "ninja: no work to do." | narrate_build 2>/dev/null)" ""
expect "a file by its path" "$(step_name "Building CXX object app/view/CMakeFiles/wend_view.dir/canvas/canvas.cpp.o")" "app/view/canvas/canvas.cpp"
expect "several files" "$(step_name "Building CXX object app/view/CMakeFiles/wend_view.dir/Unity/unity_3_cxx.cxx.o")" "several files of app/view"
expect "headers" "$(step_name "Building CXX object CMakeFiles/wend_pch_qt.dir/cmake_pch.hxx.gch")" "headers that most files include"
expect "a pace" "$(time_left 60 100 400)" ", about 3 minutes left"
expect "no pace yet" "$(time_left 10 5 400)" ""
nproc() { echo 2; }
expect "first line" "$(announce_build 400 first)" \
    "First build: 400 steps, about 17 minutes on 2 cores (less where ccache has seen them)."
expect "a few files are not announced" "$(announce_build 7 again)" ""

echo "Totals: $passed passed, $failed failed, 0 skipped"
[ "$failed" -eq 0 ]
