#!/usr/bin/env bash
# in_gimp.sh WEND PLUGIN SAMPLES [PICTURE]: bends a layer in GIMP with the sample strip.wend. The layer must equal the output of
# `wend run`, a layer with an offset must bend in its place, and an image of another size must be refused.
set -eu
wend=$(realpath "$1") samples=$(realpath "$3")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export WEND=$wend GIMP2_DIRECTORY=$folder/profile PATH=/usr/bin:/bin
mkdir -p "$folder/profile/plug-ins/wend-bend"
cp "$2" "$folder/profile/plug-ins/wend-bend/"
cat >"$folder/script.scm" <<END
(define (saved image layer name) (file-png-save RUN-NONINTERACTIVE image layer name name 0 9 0 0 0 0 0))
(let* ((image (car (gimp-file-load RUN-NONINTERACTIVE "$samples/strip.png" "strip.png")))
       (drawable (car (gimp-image-get-active-drawable image))))
  (saved image (car (plug-in-wend-bend RUN-NONINTERACTIVE image drawable "$samples/strip.wend" -1)) "$folder/end.png")
  (saved image (car (plug-in-wend-bend RUN-NONINTERACTIVE image drawable "$samples/strip.wend" 0.5)) "$folder/half.png")
  (plug-in-autocrop-layer RUN-NONINTERACTIVE image drawable)
  (saved image (car (plug-in-wend-bend RUN-NONINTERACTIVE image drawable "$samples/strip.wend" -1)) "$folder/cropped.png")
  (gimp-image-scale image 200 150)
  (plug-in-wend-bend RUN-NONINTERACTIVE image drawable "$samples/strip.wend" -1))
END
gimp -i -d -f -b "(load \"$folder/script.scm\")" -b '(gimp-quit 1)' >"$folder/log" 2>&1 || true
grep -q 'The project bends a picture of 2000 × 1500 pixels; this image has 200 × 150' "$folder/log" || { cat "$folder/log"; exit 1; }
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
same "$folder/cropped.png" "$folder/own-end.png"
if [ $# -gt 3 ]; then convert "$samples/strip.png" "$folder/half.png" "$folder/end.png" -background white -alpha remove -resize 400x +append "$4"; fi
echo "the layer bent in GIMP"
