#!/usr/bin/env bash
# completion.sh WEND: checks that every option of the program's help is in its manual page, in the script for zsh, and in
# the completions of bash and fish (if installed), and that man prints no warnings.
set -eu
wend=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; exit 1; }
mkdir "$folder/man"
"$wend" reference --man "$folder/man"
for shell in bash zsh fish; do "$wend" reference --completion $shell >"$folder/wend.$shell"; done
. "$folder/wend.bash"
bash_offers() { # WORD…: prints the completions of the last word
    COMP_WORDS=(wend "$@") COMP_CWORD=$#
    compopt() { :; }
    _wend
    printf '%s\n' "${COMPREPLY[@]}"
}

mapfile -t commands < <("$wend" --help | sed -n 's/^    \([a-z]\+\) .*/\1/p')
[ "${#commands[@]}" -ge 6 ] || fail "the overview names ${commands[*]} only"
for command in "${commands[@]}"; do
    page=$folder/man/wend-$command.1
    [ -s "$page" ] || fail "wend-$command(1) is missing"
    bash_offers "${command:0:2}" | grep -qx "$command" || fail "bash does not complete $command"
    mapfile -t flags < <("$wend" "$command" --help | sed -n 's/^  \(--[a-z-]\+\).*/\1/p')
    offered=$(bash_offers "$command" --)
    for flag in "${flags[@]}"; do
        grep -qF "\\fB${flag//-/\\-}\\fR" "$page" || grep -qF ", ${flag//-/\\-}\\fR" "$page" || fail "$flag is missing in wend-$command(1)"
        grep -qx -- "$flag" <<<"$offered" || fail "bash does not complete wend $command $flag"
    done
    if command -v fish >/dev/null; then
        offered=$(HOME=$folder fish -N -c "source $folder/wend.fish; complete -C 'wend $command --'")
        for flag in "${flags[@]}"; do grep -q "^$flag\b" <<<"$offered" || fail "fish does not complete wend $command $flag"; done
    fi
    for flag in "${flags[@]}"; do grep -q -- "$flag\b" "$folder/wend.zsh" || fail "zsh is not told of wend $command $flag"; done
done
[ "$(bash_offers run --solver mul)" = multigrid ] || fail "bash does not complete choices"
[ "$(bash_offers run --solver = mul)" = multigrid ] || fail "bash does not complete choices behind ="
[ -z "$(bash_offers run --image f | tr -d '\n')" ] || fail "bash does not leave file names to readline"
if command -v fish >/dev/null; then
    HOME=$folder fish -N -c "source $folder/wend.fish; complete -C 'wend run --solver '" | grep -q '^multigrid' || fail "fish does not complete choices"
fi
for page in "$folder"/man/*.1; do
    [ -s "$page" ] || fail "$page is empty"
    if command -v man >/dev/null; then
        warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null)
        [ -z "$warnings" ] || fail "$page: $warnings"
    fi
done
echo "$(ls "$folder/man" | wc -l) manual pages; completion works"
