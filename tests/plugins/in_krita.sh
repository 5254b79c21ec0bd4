#!/usr/bin/env bash
# in_krita.sh WEND PLUGIN SAMPLES [PICTURE]: bends a layer in Krita with the sample strip.wend. The new layer must equal the output
# of `wend run`, a group must bend as its picture does, the docker must have its buttons, and a document of another size must be
# refused.
set -eu
wend=$(realpath "$1") samples=$(realpath "$3")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export WEND=$wend HOME=$folder XDG_DATA_HOME=$folder/data XDG_CONFIG_HOME=$folder/config XDG_RUNTIME_DIR=$folder \
    QT_QPA_PLATFORM=offscreen PYTHONDONTWRITEBYTECODE=1
mkdir -p "$XDG_DATA_HOME/krita/pykrita"
cp -r "$2"/* "$XDG_DATA_HOME/krita/pykrita/"
cat >"$XDG_DATA_HOME/krita/pykrita/try_wend.py" <<END
import os
import sys
import traceback

from krita import Krita
from PyQt5.QtGui import QImage
from PyQt5.QtWidgets import QPushButton

sys.path.insert(0, os.environ["XDG_DATA_HOME"] + "/krita/pykrita")
from wend_bend import bending, docker

SAMPLES, FOLDER = "$samples", "$folder"


def saved(document, layer, name):
    width, height = document.width(), document.height()
    image = QImage(layer.projectionPixelData(0, 0, width, height), width, height, QImage.Format_ARGB32)
    assert image.save(f"{FOLDER}/{name}.png")


def work():
    document = Krita.instance().openDocument(SAMPLES + "/strip.png")
    document.setBatchmode(True)
    root = document.rootNode()
    layer = root.childNodes()[0]
    saved(document, bending.bend(document, layer, SAMPLES + "/strip.wend"), "end")
    half = bending.bend(document, layer, SAMPLES + "/strip.wend", 0.5)
    saved(document, half, "half")
    assert [node.name() for node in root.childNodes()] == [layer.name()] + 2 * [layer.name() + ", bent"]
    group = document.createGroupLayer("group")
    root.addChildNode(group, None)
    group.addChildNode(layer.clone(), None)
    document.refreshProjection()
    document.waitForDone()
    saved(document, bending.bend(document, group, SAMPLES + "/strip.wend"), "group")
    small = Krita.instance().createDocument(200, 150, "small", "RGBA", "U8", "", 72)
    try:
        bending.bend(small, small.rootNode().childNodes()[0], SAMPLES + "/strip.wend")
    except bending.Failure as failure:
        assert "The project bends a picture of 2000 × 1500 pixels; this document has 200 × 150" in str(failure)
    else:
        raise AssertionError("a document of another size")
    bend_docker = docker.BendDocker()
    texts = [button.text() for button in bend_docker.findChildren(QPushButton)]
    assert texts == ["Bend Layer", "Set Pins in Wend…"], texts


def __main__(arguments):
    try:
        work()
        print("all is well", file=open(FOLDER + "/result", "w"))
    except BaseException:
        traceback.print_exc(file=open(FOLDER + "/result", "w"))
END
PYTHONPATH=$XDG_DATA_HOME/krita/pykrita kritarunner -s try_wend >"$folder/log" 2>&1 || true
grep -q 'all is well' "$folder/result" || { cat "$folder/result" "$folder/log"; exit 1; }
"$wend" run "$samples/strip.wend" --quiet --image "$folder/own-end.png"
"$wend" run "$samples/strip.wend" --quiet --at 0.5 --image "$folder/own-half.png"
same() { # A B: compares two pictures where either is not transparent
    /usr/bin/python3 - "$1" "$2" <<'END'
import sys
from PIL import Image, ImageChops
one, other = (Image.open(name).convert("RGBa") for name in sys.argv[1:])
worst = max(high for _low, high in ImageChops.difference(one, other).getextrema())
sys.exit(worst > 1 and f"{sys.argv[1]} is off by {worst}")
END
}
same "$folder/end.png" "$folder/own-end.png"
same "$folder/half.png" "$folder/own-half.png"
same "$folder/group.png" "$folder/own-end.png"
if [ $# -gt 3 ]; then convert "$samples/strip.png" "$folder/half.png" "$folder/end.png" -background white -alpha remove -resize 400x +append "$4"; fi
echo "the layer bent in Krita"
