#!/bin/sh
# All icons at 16, 24 and 48 pixels on light and on dark, to look at. Usage: contact_sheet.sh OUT.png
# Needs rsvg-convert and ImageMagick.
set -eu
out=$(realpath "$1")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for tone in light:#f2f3f5:#22262b dark:#26292e:#e7e9ec; do
    name=${tone%%:*}; rest=${tone#*:}; paper=${rest%%:*}; ink=${rest#*:}
    for size in 16 24 48; do
        mkdir -p "$work/$name$size"
        for icon in *.svg; do
            [ "$icon" = wend.svg ] && continue
            sed "s/#000000/$ink/g" "$icon" | rsvg-convert -w $size -h $size -o "$work/$name$size/${icon%.svg}.png"
        done
        montage "$work/$name$size"/*.png -background "$paper" -tile 13x -geometry "${size}x${size}+10+10" "$work/$name$size.png"
    done
done
convert "$work"/light*.png "$work"/dark*.png -append "$out"
