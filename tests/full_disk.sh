#!/usr/bin/env bash
# full_disk.sh WEND: writes every kind of file onto a disk (a tmpfs) that is 0 to 4 pages too small for it and holds an old file
# of that name. With enough room the file must have the same bytes as elsewhere. Otherwise the program must print one line with the
# free space, exit with 5, and leave only the old file. Mounting needs root, or the right to be root in a user namespace.
set -u
if [ -z "${own_mounts:-}" ]; then
    for way in --mount "--mount --map-root-user"; do
        # shellcheck disable=SC2086  # two words
        unshare $way true 2>/dev/null && exec env own_mounts=yes unshare $way "$0" "$@"
    done
fi
wend=$(readlink -f "${1:?which program?}")
work=$(mktemp -d)
disk=$work/disk
mounted=
finish() {
    [ -n "$mounted" ] && umount "$disk"
    rm -rf "$work"
}
trap finish EXIT
mkdir "$disk"
if ! mount -t tmpfs -o size=4k none "$disk" 2>/dev/null; then
    echo "not run: a small disk cannot be mounted here"
    exit 0
fi
umount "$disk"

cd "$work" || exit 1
python3 - <<'PY'
import struct, zlib
w, h = 160, 120
rows = b''.join(b'\0' + bytes(v for x in range(w) for v in ((x * 7 + y * 13) % 256, (x * y) % 256, (x ^ y) % 256)) for y in range(h))
def chunk(kind, data):
    return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
open('photo.png', 'wb').write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', w, h, 8, 2, 0, 0, 0)) +
                              chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))
PY
echo '{"format": "wend", "version": 1, "domain": {"image": "photo.png", "vertices": 400}}' >photo.wend

runs=0 lost=0
fail() {
    echo "FAILED: $*"
    lost=$((lost + 1))
}

# pages FILE…: prints the number of pages of the files, each rounded up
pages() {
    local sum=0 size file
    for file in "$@"; do
        size=$(stat -c %s "$file")
        sum=$((sum + (size + 4095) / 4096))
    done
    echo "$sum"
}

# attempt KEPT OPTIONS…: writes an output to the disk; KEPT is the name of the old file there.
attempt() {
    local kept=$1 missing need room said code
    shift
    rm -rf reference && mkdir reference
    "$wend" run photo.wend --quiet "${@//DISK/reference}" || fail "$*: nothing to compare with"
    need=$(pages reference/*)
    for missing in 0 1 2 3 4; do
        room=$((need + 1 - missing)) # and one page for the old file
        [ "$room" -gt 1 ] || continue
        runs=$((runs + 1))
        mount -t tmpfs -o size=$((room * 4096)) none "$disk" || exit 1
        mounted=yes
        echo old >"$disk/$kept"
        said=$("$wend" run photo.wend --quiet "${@//DISK/$disk}" 2>&1)
        code=$?
        if [ "$missing" -eq 0 ]; then
            [ "$code" -eq 0 ] || fail "$kept with room enough: exit $code, $said"
            # OpenEXR and TIFF files hold the time when they were made.
            for file in reference/*; do
                case $file in
                *.exr | *.tif) [ "$(stat -c %s "$file")" -eq "$(stat -c %s "$disk/${file#*/}")" ] ;;
                *.json) python3 -m json.tool "$disk/${file#*/}" >/dev/null ;; # it contains the duration of the run
                *) cmp "$file" "$disk/${file#*/}" ;;
                esac || fail "${file#*/} with room enough: another file"
            done
        else
            [ "$code" -eq 5 ] && [[ $said == wend:*"the disk is full, only "*" are free" ]] && [ "$(wc -l <<<"$said")" -eq 1 ] || fail "$kept, $missing pages short: exit $code, $said"
            [ "$(cat "$disk/$kept")" = old ] || fail "$kept, $missing pages short: the old file is gone"
            [ "$(ls -A "$disk")" = "$kept" ] || fail "$kept, $missing pages short: left $(ls -A "$disk")"
        fi
        umount "$disk" && mounted=
    done
}

for format in png jpg tif exr webp bmp tga jp2 hdr ppm; do attempt "out.$format" --image "DISK/out.$format"; done
for format in obj ply stl off vtu vtk msh mesh inp node; do attempt "out.$format" --mesh "DISK/out.$format"; done
for format in csv vtu; do attempt "out.$format" --velocity "DISK/out.$format"; done
attempt out.json --report DISK/out.json
for part in phi stiffness direction; do attempt "$part.png" "--$part-picture" "DISK/$part.png"; done
for format in exr tif; do attempt "map.$format" --stmap "DISK/map.$format"; done
for format in png exr tif obj vtu; do attempt "f_1.$format" --frames "DISK/f_#.$format" --count 3; done
attempt film.webp --frames DISK/film.webp --count 3
for format in mp4 webm mov gif png webp; do attempt "film.$format" --film "DISK/film.$format" --count 3; done

echo "$runs runs on disks 0 to 4 pages too small: $lost failed"
[ "$lost" -eq 0 ]
