#!/usr/bin/env bash
# Checks (or with --fix, applies) clang-format; with --tidy also runs clang-tidy-16 over build/dev's compile commands.
cd "$(dirname "$0")/.." || exit 1
mapfile -t files < <(git ls-files '*.h' '*.cpp')
case "${1:-}" in
--fix) exec clang-format -i "${files[@]}" ;;
--tidy)
    cmake --preset dev >/dev/null && ninja -C build/dev --quiet >/dev/null || exit 1
    exec run-clang-tidy-16 -quiet -p build/dev -extra-arg=-Wno-unknown-warning-option "$PWD/(core|warp|kernels|app)/.*\.cpp$" ;;
*) exec clang-format --dry-run --Werror "${files[@]}" ;;
esac
