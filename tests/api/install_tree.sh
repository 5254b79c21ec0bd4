#!/usr/bin/env bash
# install_tree.sh CMAKE BUILD SOURCES [SANITIZERS]: installs the library, moves the folder, and builds and runs the example projects and
# the C++ examples of docs/library.md against it. Checks that libwend exports only the symbols that its headers mark, and that it
# links none of the libraries of the window or of pictures.
set -euo pipefail
cmake=$1 build=$2 sources=$3 flags="-Wall -Wextra -Werror ${4:-}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$cmake" --install "$build" --prefix "$work/first" >"$work/install.log" || { cat "$work/install.log"; exit 1; }
mv "$work/first" "$work/prefix"
prefix=$work/prefix

library=$(find "$prefix" -name 'libwend.so.0')
[ -L "$library" ] || { echo "libwend.so.0 is missing"; exit 1; }
shown=$(nm -DC --defined-only "$library" | cut -d' ' -f3- | grep -vE '^(WEND_0(@.*)?$|(void |typeinfo (name )?for |vtable for )?wend::)' || true)
[ -z "$shown" ] || { echo "libwend shows more than its headers say:"; echo "$shown"; exit 1; }
if readelf -d "$library" | grep NEEDED | grep -E 'Qt|OpenImageIO|OpenCL'; then echo "libwend.so.0 needs these"; exit 1; fi

for header in "$prefix"/include/wend/*.h; do # each header alone
    # shellcheck disable=SC2086
    echo "#include <wend/${header##*/}>" | c++ -std=c++20 $flags -I"$prefix/include" -fsyntax-only -x c++ -
done

run_project() { # FOLDER PROGRAM
    local made=$work/made/$(basename "$1")
    "$cmake" -S "$1" -B "$made" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="$flags" >"$work/log" 2>&1 &&
        "$cmake" --build "$made" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    (cd "$work" && "$made/$2") || { echo "$1: $2 ends with $?"; exit 1; }
}
for lists in "$sources"/examples/*/CMakeLists.txt; do
    run_project "$(dirname "$lists")" "$(sed -n 's/^project(\([a-z]*\).*/\1/p' "$lists")"
done

cp "$sources/resources/samples/strip.png" "$work"
awk -v folder="$work" '/^```cpp$/ { file = folder "/example" ++count ".cpp"; next } /^```$/ { file = "" } file { print > file }' \
    "$sources/docs/library.md"
[ -e "$work/example2.cpp" ] || { echo "docs/library.md has fewer than two examples in C++"; exit 1; }
for source in "$work"/example*.cpp; do
    name=$(basename "$source" .cpp)
    mkdir "$work/$name"
    mv "$source" "$work/$name/bend.cpp"
    awk '/^```cmake$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$sources/docs/library.md" |
        sed 's/wend::core/wend::core wend::warp/' >"$work/$name/CMakeLists.txt"
    run_project "$work/$name" bend
done
