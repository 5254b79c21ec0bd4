#!/usr/bin/env bash
# desktop_files.sh: checks the files for desktops and software centres against their specifications.
set -eu
cd "$(dirname "$0")/../resources"
desktop-file-validate wend.desktop
appstreamcli validate --no-net wend.metainfo.xml
# The MIME database knows the type of project files.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/mime/packages"
cp wend-mime.xml "$folder/mime/packages/wend.xml"
update-mime-database "$folder/mime"
grep -q '^60:application/x-wend:\*.wend$' "$folder/mime/globs2"
version=$(sed -n 's/^project(Wend VERSION \([0-9.]*\).*/\1/p' ../CMakeLists.txt)
grep -q "<release version=\"$version\"" wend.metainfo.xml || { echo "the release $version is missing in wend.metainfo.xml"; exit 1; }
