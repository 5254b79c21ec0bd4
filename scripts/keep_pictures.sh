#!/bin/sh
# Makes the pictures of the choices of “Keep” (resources/keep/*.png) with the program itself: a spotted disc, held at the left
# and pulled at the right, deformed with each of the four energies. Volume in solids uses the picture of area.
# Usage: keep_pictures.sh [WEND]   WEND: the program, by default the one on PATH. Needs ImageMagick and optipng.
set -eu
wend=$(realpath "${1:-$(command -v wend)}")
out=$(cd "$(dirname "$0")/../resources/keep" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# disc FILL SPOT: rings of spots, which show growth and rotation
disc() {
    spots=$(awk 'BEGIN { print "circle 310,500 346,500"
        for (ring = 1; ring <= 2; ++ring) for (i = 0; i < 6 * ring; ++i) {
            a = 6.283185307 * i / (6 * ring); x = 310 + 96 * ring * cos(a); y = 500 + 96 * ring * sin(a)
            printf "circle %.2f,%.2f %.2f,%.2f\n", x, y, x + 30, y } }')
    convert -size 920x1000 xc:none -fill "$1" -draw 'circle 310,500 570,500' -fill "$2" -draw "$spots" disc.png
}

# keep NAME PHI FILL SPOT
keep() {
    disc "$3" "$4"
    cat > disc.wend <<PROJECT
{"format": "wend", "version": 1,
 "domain": {"image": "disc.png", "outline": {"from": "alpha", "threshold": 0.5, "margin": 2}, "vertices": 6000},
 "material": {"phi": "$2"},
 "handles": [
  {"name": "left", "at": {"region": {"circle": {"centre": [80, 500], "radius": 34}}}},
  {"name": "right", "at": {"region": {"circle": {"centre": [540, 500], "radius": 34}}},
   "motion": [{"kind": "curve", "interpolation": "bezier", "points": [[540, 500], [620, 500], [700, 500], [780, 500]], "time": [0, 1]}]}],
 "time": {"end": 1}}
PROJECT
    "$wend" run disc.wend --image bent.png --quiet
    convert bent.png -resize 184x -depth 8 -strip -define png:compression-level=9 -define png:exclude-chunks=all "$out/$1.png"
    ! command -v optipng > /dev/null || optipng -quiet -o2 -strip all "$out/$1.png"
}

keep area equia '#e2ab2c' '#fff7e0'
keep length metr '#3f9d86' '#e8fbf5'
keep rigid akvf '#2e77ae' '#e3f2ff'
keep angle conf '#6d3aa0' '#f3e8ff'
