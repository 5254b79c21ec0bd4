#!/usr/bin/env bash
# api-reference.sh [FOLDER]: writes the reference of libwend as web pages into FOLDER/html (default: build/reference). Fails on any warning.
cd "$(dirname "$0")/.." || exit 1
export WEND_REFERENCE=${1:-build/reference}
WEND_VERSION=$(sed -n 's/^project(Wend VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
export WEND_VERSION
command -v doxygen >/dev/null || { echo "doxygen is missing: apt-get install doxygen" >&2; exit 1; }
mkdir -p "$WEND_REFERENCE" && exec doxygen api/Doxyfile
