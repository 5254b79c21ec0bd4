#!/usr/bin/env bash
# Makes the manual's website and checks its links; if Chromium is installed, also its search, without a server.
set -eu
sources=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
/usr/bin/python3 "$sources/scripts/website/make.py" "$folder/site"
command -v chromium >/dev/null || exit 0
shown() { # PAGE?QUERY
    chromium --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" --dump-dom "file://$folder/site/$1" 2>/dev/null
}
found=$(shown 'energies.html?q=minimal%20frame' | sed -n '/id="results"/,/<\/ul>/p')
[[ $found == *'href="curves-and-frames.html#frames"'*'<mark>frame</mark>'* ]] || { echo "the search does not find frames: $found"; exit 1; }
[[ $(shown 'index.html?q=xyzzyq') == *"Nothing found."* ]] || { echo "the search finds what is not there"; exit 1; }
echo "the search works in Chromium"
