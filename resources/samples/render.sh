#!/bin/sh
# Draws the sample pictures: art/*.py -> *.svg (the sources that one edits) -> *.png or *.ora (what the projects use).
# Usage: render.sh [--art]   with --art the SVG files are made again from the scripts, too.
#                   and the solids (art/solids/*.py -> *.obj) with their pictures for the start page, which show the bent shape
# Needs rsvg-convert (librsvg2-bin), python3 and optipng; --art needs the built program, too.
set -eu
cd "$(dirname "$0")"
if [ "${1-}" = --art ]; then
    for script in art/*.py; do
        name=$(basename "$script" .py)
        case $name in draw | layers) ;; *) python3 "$script" "$name.svg" ;; esac
    done
    solid() {  # NAME ANGLE TILT COLOUR
        python3 "art/solids/$1.py" "$1.obj"
        ../../wend run "$1.wend" --mesh "$work/$1.obj"
        python3 art/solids/portrait.py "$work/$1.obj" "$1.png" "$2" "$3" "$4"
        optipng -quiet -o2 -strip all "$1.png"
    }
    work=$(mktemp -d)
    cp eagle-feathers.mtl "$work"
    python3 art/solids/eagle_feathers.py eagle-feathers.obj
    python3 art/solids/plumage.py eagle-plumage.svg
    rsvg-convert eagle-plumage.svg -o eagle-plumage.png
    cp eagle-plumage.png "$work"
    solid eagle -150 14 0.86,0.66,0.42
    solid bar 20 -20 0.45,0.62,0.78
    rm -r "$work"
fi
python3 art/layers.py walker.svg walker.ora
for picture in *.svg; do
    name=${picture%.svg}
    [ "$name" = walker ] && continue
    rsvg-convert "$picture" -o "$name.png"
    optipng -quiet -o2 -strip all "$name.png"
done
