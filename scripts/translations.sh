#!/usr/bin/env bash
# Brings translations/*.ts up to date with the strings in app/.
cd "$(dirname "$0")/.." || exit 1
lupdate=$(command -v lupdate6 || echo /usr/lib/qt6/bin/lupdate)
exec "$lupdate" -no-obsolete -locations none -I . app -ts translations/wend_*.ts
