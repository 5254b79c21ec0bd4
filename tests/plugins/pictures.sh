#!/usr/bin/env bash
# pictures.sh WEND BUILD: makes the pictures of docs/plugins.md inside the programs from the tests' drawings.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
sources=$(realpath "$here/../..") out=$(realpath "$here/../../docs/pictures")
WEND=$(realpath "$1") build=$(realpath "$2")
export WEND PATH=/usr/bin:/bin
python3 "$here/in_inkscape.py" "$WEND" "$sources/plugins/inkscape" "$sources/resources/samples" "$out/plugin-inkscape.png"
blender -b --factory-startup --python-exit-code 1 --python "$here/in_blender.py" -- "$sources/plugins/blender/wend_bend.py" "$out/plugin-blender.png"
xvfb-run -a pvpython "$here/in_paraview.py" "$build/plugins/wend_project.xml" "$sources/resources/samples/bar.wend" "$out/plugin-paraview.png"
"$here/in_krita.sh" "$WEND" "$sources/plugins/krita" "$sources/resources/samples" "$out/plugin-krita.png"
"$here/in_gimp.sh" "$WEND" "$build/plugins/wend-bend" "$sources/resources/samples" "$out/plugin-gimp.png"
