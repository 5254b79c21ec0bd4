#!/bin/sh
# Makes the manual's pictures from the samples with `wend run` (the window's: screenshots.sh).
# Usage: make.sh [WEND]   WEND: the program, by default the one on PATH. Needs ImageMagick, rsvg-convert, python3, ffmpeg and optipng.
set -eu
cd "$(dirname "$0")"
here=$PWD
wend=${1:-$(command -v wend)}
samples=$(realpath ../../resources/samples)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
paper='#eef1f4'
ink='#2b3038'

# run PROJECT OUT [options]: the warped picture at the end
run() {
    project=$1 out=$2
    shift 2
    "$wend" run "$project" --image "$out" --quiet "$@"
}

# label PICTURE TEXT: the text under the picture
label() {
    convert "$1" -background "$paper" -flatten -gravity south -splice 0x46 -fill "$ink" -font DejaVu-Sans -pointsize 26 -annotate +0+10 "$2" +repage "$1"
}

# finish OUT WIDTH: size and weight for the manual
finish() {
    convert "$1" -background "$paper" -flatten -filter Lanczos -resize "$2x>" -strip -depth 8 "$here/$3"
    optipng -quiet -o2 "$here/$3"
}

four_energies() {
    sample=$1 crop=$2 size=$3
    sed 's/"vertices": 5000/"vertices": 20000/; s#"'"$sample"'.png"#"'"$samples/$sample"'.png"#' "$samples/$sample.wend" >"$work/fine.wend"
    for phi in equia metr akvf conf; do
        case $phi in equia) name=Area ;; metr) name=Length ;; akvf) name=Rigid ;; *) name=Angle ;; esac
        run "$work/fine.wend" "$work/$phi.png" --phi $phi
        convert "$work/$phi.png" -crop "$crop" +repage -resize "$size" +repage "$work/$phi.png"
        label "$work/$phi.png" "$name"
    done
    convert "$work/equia.png" "$work/metr.png" "$work/akvf.png" "$work/conf.png" +append +repage "$work/all.png"
    finish "$work/all.png" 1800 "energies-$sample.png"
}

giraffe_steps() {
    "$wend" run "$samples/giraffe.wend" --frames "$work/step_#.png" --count 5 --quiet
    convert "$work"/step_*.png -crop 2060x2360+220+0 +repage -resize 360x +append +repage "$work/all.png"
    finish "$work/all.png" 1800 giraffe-steps.png
}

frames() {
    sed 's/"frame": "minimal"/"frame": "none"/; s#"giraffe.png"#"'"$samples"'/giraffe.png"#' "$samples/giraffe.wend" >"$work/none.wend"
    run "$work/none.wend" "$work/none.png"
    run "$samples/giraffe.wend" "$work/minimal.png"
    for frame in none minimal; do
        convert "$work/$frame.png" -crop 2060x1700+220+700 +repage -resize 640x "$work/$frame.png"
        label "$work/$frame.png" "frame: $frame"
    done
    convert "$work/none.png" "$work/minimal.png" +append +repage "$work/all.png"
    finish "$work/all.png" 1280 frames.png
}

# strip_with OUT REGIONS: the strip with other regions of the material
strip_with() {
    python3 - "$samples" "$work/with.wend" "$2" <<'PY'
import json, sys
samples, out, regions = sys.argv[1:]
project = json.load(open(f"{samples}/strip.wend"))
project["domain"]["image"] = f"{samples}/strip.png"
project["material"] = json.loads(regions)
json.dump(project, open(out, "w"))
PY
    run "$work/with.wend" "$1"
    convert "$1" -crop 960x1300+40+120 +repage -resize 560x "$1"
}

material() {
    strip_with "$work/blend.png" '{"phi": "metr", "regions": [{"shape": {"blend": {"from": [800, 1250], "to": [1200, 1250]}}, "phi": "conf"}]}'
    label "$work/blend.png" "from Length to Angle"
    finish "$work/blend.png" 560 material-phi.png
    strip_with "$work/plain.png" '{"phi": "metr"}'
    label "$work/plain.png" "the same all along"
    strip_with "$work/stiff.png" '{"phi": "metr", "regions": [{"shape": {"polygon": [[750, 1100], [1250, 1100], [1250, 1400], [750, 1400]]}, "feather": 60, "stiffness": {"axis": [1, 0], "ratio": 20}}]}'
    label "$work/stiff.png" "the middle 20 times stiffer lengthwise"
    convert "$work/plain.png" "$work/stiff.png" +append +repage "$work/all.png"
    finish "$work/all.png" 1120 material-stiffness.png
}

mesh() {
    "$wend" mesh "$samples/frog.wend" -o "$work/frog.obj" --quiet
    python3 - "$work/frog.obj" "$work/mesh.svg" <<'PY'
import sys
points, edges = [], set()
for line in open(sys.argv[1]):
    word = line.split()
    if word[:1] == ["v"]:
        points.append((float(word[1]), float(word[2])))
    elif word[:1] == ["f"]:
        ids = [int(w.split("/")[0]) - 1 for w in word[1:]]
        edges |= {tuple(sorted((ids[i - 1], ids[i]))) for i in range(len(ids))}
path = "".join(f"M{points[a][0]:.1f} {points[a][1]:.1f}L{points[b][0]:.1f} {points[b][1]:.1f}" for a, b in sorted(edges))
open(sys.argv[2], "w").write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2400 2400" width="2400" height="2400">'
                             f'<path d="{path}" fill="none" stroke="#12304a" stroke-width="2.2" opacity="0.75"/></svg>')
PY
    rsvg-convert "$work/mesh.svg" -o "$work/lines.png"
    convert "$samples/frog.png" -background "$paper" -flatten -fill "$paper" -colorize 45 "$work/lines.png" -composite \
        -crop 1150x1000+300+750 +repage "$work/all.png"
    finish "$work/all.png" 900 mesh-frog.png
    convert "$here/mesh-frog.png" +dither -colors 128 "$here/mesh-frog.png"
    optipng -quiet -o2 "$here/mesh-frog.png"
}

bent() {
    python3 bent.py "$wend" "$work"
    for name in knot vase chain bolt fern; do
        convert "$work/$name-rest.png" "$work/$name-bent.png" -background "$paper" +append -flatten -trim -bordercolor "$paper" -border 24 +repage "$work/all.png"
        finish "$work/all.png" 960 "bent-$name.png"
        convert "$here/bent-$name.png" +dither -colors 192 "$here/bent-$name.png"
        optipng -quiet -o2 "$here/bent-$name.png"
    done
}

# A character in layers, at rest and posed.
parts() {
    python3 character.py "$work/character.ora"
    cp character.wend "$work"
    run "$work/character.wend" "$work/rest.png" --at 0
    run "$work/character.wend" "$work/posed.png"
    convert "$work/rest.png" "$work/posed.png" -background "$paper" +append +repage -flatten "$work/all.png"
    finish "$work/all.png" 960 parts.png
    convert "$here/parts.png" +dither -colors 64 "$here/parts.png"
    optipng -quiet -o2 "$here/parts.png"
}

# A drawing at rest and bent, and a piece of the bent one eight times as large.
drawing() {
    cp fish.svg fish.wend "$work"
    "$wend" run "$work/fish.wend" --image "$work/bent-fish.svg" --canvas fit --quiet
    rsvg-convert -w 900 fish.svg -o "$work/rest.png"
    rsvg-convert -w 900 "$work/bent-fish.svg" -o "$work/bent.png"
    rsvg-convert -w 7200 "$work/bent-fish.svg" -o "$work/large.png"
    convert "$work/large.png" -crop 900x580+5850+2750 +repage "$work/piece.png"
    convert "$work/rest.png" "$work/bent.png" "$work/piece.png" -background "$paper" -gravity center +append +repage -flatten "$work/all.png"
    finish "$work/all.png" 1500 drawing.png
    optipng -quiet -o2 "$here/drawing.png"
}

# The walk that loops: eight of its poses side by side.
walk() {
    "$wend" run "$samples/walker.wend" --frames "$work/walk_#.png" --count 9 --width 480 --quiet
    convert "$work"/walk_[0-7].png -background "$paper" -crop 340x480+60+0 +repage +append +repage -flatten "$work/all.png"
    finish "$work/all.png" 1800 walk.png
    convert "$here/walk.png" +dither -colors 96 "$here/walk.png"
    optipng -quiet -o2 "$here/walk.png"
}

# film PROJECT NAME WIDTH [options]: a WebP film
film() {
    project=$1 name=$2 width=$3
    shift 3
    "$wend" run "$project" --film "$here/$name.webp" --webp lossy --width "$width" --outside "$paper" --quiet "$@"
}

# sheet NAME PATTERN: pictures side by side
sheet() {
    name=$1
    shift
    convert "$@" -background "$paper" +repage +append +repage -flatten "$work/all.png"
    finish "$work/all.png" 1800 "$name.png"
    convert "$here/$name.png" +dither -colors 96 "$here/$name.png"
    optipng -quiet -o2 "$here/$name.png"
}

# Films, and sheets of their poses: the walk; a wave and a nod, recorded in the window over each other; a solid's swim.
films() {
    film "$samples/walker.wend" walk 320 --loop --fps 16
    python3 character.py "$work/character.ora"
    cp wave.wend "$work"
    film "$work/wave.wend" wave 240 --fps 12 --canvas=-90,0,570,640
    "$wend" run "$work/wave.wend" --frames "$work/wave_#.png" --count 8 --canvas=-90,0,570,640 --width 300 --quiet
    sheet wave "$work"/wave_*.png
    python3 swim.py "$wend" "$work"
    mogrify -background "$paper" -alpha remove "$work"/swim_*.png
    ffmpeg -y -v error -framerate 12 -i "$work/swim_%02d.png" -loop 0 -quality 80 "$here/swim.webp"
    sheet swim "$work"/swim_00.png "$work"/swim_03.png "$work"/swim_06.png "$work"/swim_09.png
}

# The grid at a wing's root, at rest and moved.
wing() {
    python3 wing.py "$work"
    "$wend" run "$work/wing.wend" --mesh "$work/moved.inp" --quiet
    python3 wing_section.py "$work/wing.inp" "$work/moved.inp" "$work/wing.svg"
    rsvg-convert "$work/wing.svg" -o "$work/wing.png"
    convert "$work/wing.png" -strip -depth 8 +dither -colors 48 "$here/wing.png"
    optipng -quiet -o2 "$here/wing.png"
}

four_energies strip 960x1300+40+120 450x
four_energies giraffe 2060x1600+220+760 450x
giraffe_steps
frames
material
mesh
bent
parts
drawing
walk
films
wing
