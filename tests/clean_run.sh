#!/usr/bin/env bash
# clean_run.sh PROGRAM ARGUMENT…: runs a test, and fails also if it leaves temporary files, or settings of the program in the
# user's home. The places of Qt's own dialogs, which Qt stores, are ignored.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -m 700 "$work/temporary" "$work/settings" "$work/runtime"
TMPDIR=$work/temporary XDG_CONFIG_HOME=$work/settings XDG_RUNTIME_DIR=$work/runtime "$@" || exit
left=$(cd "$work" && find temporary settings -mindepth 1 ! -name QtProject.conf)
[ -z "$left" ] && exit
echo "FAIL!  : this is left behind:"
echo "$left"
exit 1
