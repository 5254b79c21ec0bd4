#!/usr/bin/env bash
# thumbnail.sh WEND: has the file managers' service make a picture of a project by resources/wend.thumbnailer. The service
# runs at the lowest priority, so this may take long.
set -eu
sources=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export HOME=$folder XDG_DATA_HOME=$folder/data XDG_CACHE_HOME=$folder/cache XDG_CONFIG_HOME=$folder/config XDG_DATA_DIRS=/usr/share
mkdir -p "$XDG_DATA_HOME/thumbnailers" "$XDG_DATA_HOME/mime/packages" "$folder/bin" "$folder/own projects"
ln -s "$1" "$folder/bin/wend"
export PATH=$folder/bin:/usr/bin:/bin
cp "$sources/resources/wend.thumbnailer" "$XDG_DATA_HOME/thumbnailers"
cp "$sources/resources/wend-mime.xml" "$XDG_DATA_HOME/mime/packages/wend.xml"
update-mime-database "$XDG_DATA_HOME/mime"
cp "$sources"/resources/samples/strip.{wend,png} "$folder/own projects"
uri="file://$folder/own%20projects/strip.wend"
thumbnail=$XDG_CACHE_HOME/thumbnails/normal/$(printf %s "$uri" | md5sum | cut -d' ' -f1).png
export uri thumbnail
dbus-run-session -- bash -c '
    gdbus call --session -d org.freedesktop.thumbnails.Thumbnailer1 -o /org/freedesktop/thumbnails/Thumbnailer1 \
        -m org.freedesktop.thumbnails.Thumbnailer1.Queue "[\"$uri\"]" "[\"application/x-wend\"]" normal foreground 0 >/dev/null
    for _ in $(seq 5000); do [ -s "$thumbnail" ] && exit; sleep 0.1; done; exit 1' 2>"$folder/log" || { cat "$folder/log"; echo "no thumbnail"; exit 1; }
"$1" info --json "$thumbnail" | grep -q '"width": 128' || { echo "the thumbnail has another size"; exit 1; }
echo "a thumbnail is made"
