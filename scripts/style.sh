#!/usr/bin/env bash
# Checks clang-format and the subjects of commits (--fix applies the format); --tidy runs clang-tidy-16 over what clang compiles.
cd "$(dirname "$0")/.." || exit 1

# Prints the subjects since release 0.3.0 that exceed 72 characters, and fails if there are any.
long_subjects() {
    local base
    base=$(git rev-parse --quiet --verify 'v0.3.0^{commit}') || base=da52c1eca213
    git merge-base --is-ancestor "$base" HEAD 2>/dev/null || return 1  # in a shallow clone or without a repository
    git log --no-merges --format='%h %s' "$base..HEAD" |
        python3 -c 'import sys
long = [line for line in sys.stdin.read().splitlines() if len(line.split(" ", 1)[1]) > 72]
print(*("subject over 72 characters: " + line for line in long), sep="\n", end="\n" if long else "")
sys.exit(not long)'
}

mapfile -t files < <(git ls-files --cached --others --exclude-standard '*.h' '*.cpp')  # including new files
case "${1:-}" in
--fix) exec clang-format -i "${files[@]}" ;;
--tidy)
    cmake --preset clang >/dev/null && ninja -C build/clang --quiet >/dev/null || exit 1
    exec run-clang-tidy-16 -quiet -p build/clang -extra-arg=-Wno-unknown-warning-option "$PWD/(core|warp|kernels|app)/.*\.cpp$" ;;
*)
    long_subjects && exit 1
    exec clang-format --dry-run --Werror "${files[@]}" ;;
esac
