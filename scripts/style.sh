#!/usr/bin/env bash
# Checks (or with --fix, applies) clang-format; with --tidy runs clang-tidy-16 over what clang compiles.
cd "$(dirname "$0")/.." || exit 1
mapfile -t files < <(git ls-files --cached --others --exclude-standard '*.h' '*.cpp')  # new ones, too
case "${1:-}" in
--fix) exec clang-format -i "${files[@]}" ;;
--tidy)
    cmake --preset clang >/dev/null && ninja -C build/clang --quiet >/dev/null || exit 1
    exec run-clang-tidy-16 -quiet -p build/clang -extra-arg=-Wno-unknown-warning-option "$PWD/(core|warp|kernels|app)/.*\.cpp$" ;;
*) exec clang-format --dry-run --Werror "${files[@]}" ;;
esac
