#!/bin/sh
# Draws the sample pictures: art/*.py -> *.svg (the sources that one edits) -> *.png (what the projects use).
# Usage: render.sh [--art]   with --art the SVG files are made again from the scripts, too.
# Needs rsvg-convert (librsvg2-bin) and optipng; --art needs python3.
set -eu
cd "$(dirname "$0")"
if [ "${1-}" = --art ]; then
    for script in art/*.py; do
        name=$(basename "$script" .py)
        [ "$name" = draw ] || python3 "$script" "$name.svg"
    done
fi
for picture in *.svg; do
    name=${picture%.svg}
    rsvg-convert "$picture" -o "$name.png"
    optipng -quiet -o2 -strip all "$name.png"
done
