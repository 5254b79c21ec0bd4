#!/usr/bin/env bash
# Takes the screenshots of the window that README and manual show, or the one that is named; with --every FOLDER, into that folder,
# every step of a picture and of a solid, light and dark, at 100 and 200 %, to be looked at. Needs Debian's xvfb, xdotool and imagemagick.
set -e
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=$here only=$1 every=
[ "$only" = --every ] && every=yes only= folder=$(realpath "$2")
export DISPLAY=:78 HOME XDG_RUNTIME_DIR
scratch=$(mktemp -d) XDG_RUNTIME_DIR=$(mktemp -d)
Xvfb "$DISPLAY" -screen 0 2880x1800x24 >/dev/null 2>&1 &
server=$!
trap 'kill $program $server 2>/dev/null; rm -rf "$scratch" "$XDG_RUNTIME_DIR"' EXIT
sleep 1

# NAME ARGUMENT…: opens the window, waits, sends the keys in KEYS, waits for PAUSE, clicks at CLICKS (x,y …), sends the keys in THEN, drags along DRAG (x y x y), takes a picture
# of it; dark if DARK says so, SCALE times as large
shot() {
    local name=$1
    shift
    [ -z "$only" ] || [ "$only" = "$name" ] || return 0
    HOME=$scratch/$name  # of its own: what one leaves unsaved is not offered to the next
    mkdir -p "$HOME/.config/Wend"
    local width=$((1440 * ${SCALE:-1})) height=$((900 * ${SCALE:-1}))
    printf '[General]\ntipsDone=7\n%s\n' "${DARK:+appearance=2}" >"$HOME/.config/Wend/Wend.conf"  # no tips
    QT_SCALE_FACTOR=${SCALE:-1} "$root/build/release/wend" "$@" >/dev/null 2>&1 &
    program=$!
    local window
    window=$(xdotool search --sync --onlyvisible --pid "$program" | tail -n 1)
    xdotool windowmove "$window" 0 0 windowsize "$window" "$width" "$height" || true  # a solid makes it anew meanwhile
    sleep "${WAIT:-8}"
    window=$(xdotool search --onlyvisible --pid "$program" | tail -n 1)
    xdotool windowmove "$window" 0 0 windowsize "$window" "$width" "$height" windowfocus "$window"
    sleep 1
    for key in $KEYS; do
        xdotool key "$key"
        sleep 0.5
    done
    sleep "${PAUSE:-0}"
    for place in $CLICKS; do
        xdotool mousemove "${place%,*}" "${place#*,}"
        sleep 0.3
        xdotool click 1
        sleep 0.7
    done
    for key in $THEN; do
        xdotool key "$key"
        sleep 1
    done
    if [ -n "$DRAG" ]; then
        local from_x from_y to_x to_y
        read -r from_x from_y to_x to_y <<<"$DRAG"
        xdotool mousemove "$from_x" "$from_y" mousedown 1
        for i in $(seq 1 20); do
            xdotool mousemove $((from_x + (to_x - from_x) * i / 20)) $((from_y + (to_y - from_y) * i / 20))
        done
        xdotool mouseup 1
        sleep "${WAIT:-8}"
    fi
    xdotool mousemove $((width * 35 / 72)) 12  # beside the menus, where nothing has a tip
    sleep 1
    import -window root -crop "${width}x$height+0+0" +repage "$folder/$name"
    kill "$program"
    wait "$program" 2>/dev/null || true
}

if [ "$every" ]; then
    for SCALE in 1 2; do
        for DARK in "" yes; do
            for sample in giraffe bar; do
                for step in 1 2 3 4 5; do
                    KEYS="ctrl+$step" shot "$sample-$step-${DARK:+dark-}${SCALE}00.png" "$root/resources/samples/$sample.wend"
                done
            done
            shot "start-${DARK:+dark-}${SCALE}00.png"
        done
    done
    exit
fi

shot start.png
KEYS="alt+h t" PAUSE=20 DRAG="414 762 414 762" shot tutorial.png
shot window.png "$root/resources/samples/giraffe.wend"
WAIT=12 KEYS="y d" shot compare.png "$root/resources/samples/giraffe.wend"
sed -e 's|"octopus.png"|"'"$root"'/resources/samples/octopus.png"|' -e 's|"name": "right .* arm"|"group": "Right arms", &|' -e 's|"name": "left .* arm"|"group": "Left arms", &|' \
    -e 's|"name": ".* middle arm"|"link": 1, &|' -e 's|"name": "head"|"locked": true, &|' "$root/resources/samples/octopus.wend" >"$scratch/arms.wend"
WAIT=10 KEYS=v DRAG="740 500 830 575" shot pin-list.png "$scratch/arms.wend"
python3 - "$root/resources/samples/giraffe.wend" "$root/resources/samples/giraffe.png" "$scratch/film.wend" <<'END'
import json, sys
project = json.load(open(sys.argv[1]))
project["domain"]["image"] = sys.argv[2]
own = {handle["name"]: handle for handle in project["handles"]}
own["head"]["motion"][0].update(time=[0.4, 2.4], ease="inOut")
for name, by, begin in (("front hoof", [60, -200], 0), ("far front hoof", [90, -160], 0.5), ("rump", [-60, -60], 1.2)):
    own[name]["motion"] = [{"kind": "translate", "by": by, "time": [begin, begin + 1], "ease": "inOut"}]
project["time"]["end"] = 3
json.dump(project, open(sys.argv[3], "w"))
END
WAIT=12 KEYS="ctrl+4 shift+n" DRAG="600 858 600 858" shot film.png "$scratch/film.wend"
WAIT=12 KEYS="ctrl+4" DRAG="520 690 520 690" shot keys.png "$root/resources/samples/walker.wend"
WAIT=12 KEYS="ctrl+4" CLICKS="390,780" THEN="e" DRAG="1018 420 1018 316" shot easing.png "$root/resources/samples/walker.wend"
WAIT=10 KEYS="ctrl+4 p" CLICKS="580,620 610,500" DRAG="700 450 780 470" shot pen.png "$root/resources/samples/giraffe.wend"
WAIT=10 KEYS="ctrl+5 c" DRAG="310 380 880 800" shot export.png "$root/resources/samples/giraffe.wend"
WAIT=10 KEYS="ctrl+3 n" DRAG="690 490 760 595" shot painting.png "$root/resources/samples/octopus.wend"
WAIT=20 KEYS="f" shot solid-detail.png "$root/resources/samples/eagle.wend"
WAIT=20 KEYS="d f" shot solid-window.png "$root/resources/samples/eagle.wend"
WAIT=20 KEYS="m d c" shot solid-cut.png "$root/resources/samples/eagle.wend"
WAIT=15 KEYS="ctrl+a" shot solid-curve.png "$root/resources/samples/bar.wend"
echo '{"format": "wend", "version": 1, "domain": {"surface": "'"$root"'/resources/samples/bar.obj", "vertices": 3000, "refineSurface": true}}' >"$scratch/bar.wend"
WAIT=15 KEYS="shift+a m f bracketright bracketright" DRAG="310 400 620 505" shot solid-sizes.png "$scratch/bar.wend"
# A knot in a cage, and a vase with holes, seen from outside.
(cd "$scratch" && PYTHONDONTWRITEBYTECODE=1 python3 -c 'import sys; sys.path.insert(0, sys.argv[1]); import bent; bent.knot().write("knot.obj"); bent.vase().write("inside.obj")' "$here" &&
    awk '$1 == "f" {print $1, $2, $4, $3; next} 1' inside.obj >vase.obj)
echo '{"format": "wend", "version": 1, "domain": {"surface": "knot.obj", "cage": true, "vertices": 4000}}' >"$scratch/knot.wend"
WAIT=15 KEYS="ctrl+1" CLICKS="1205,609" shot facts.png "$scratch/knot.wend"
WAIT=15 KEYS="ctrl+1" DRAG="1228 535 1228 535" shot repair.png "$scratch/vase.obj"
