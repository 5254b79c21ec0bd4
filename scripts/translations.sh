#!/usr/bin/env bash
# Updates translations/*.ts from the strings in app/ and the sentences of core/ and warp/.
cd "$(dirname "$0")/.." || exit 1
lupdate=$(command -v lupdate6 || echo /usr/lib/qt6/bin/lupdate)
exec "$lupdate" -tr-function-alias QT_TRANSLATE_NOOP+=sentence -no-obsolete -locations none -I . app core warp -ts translations/wend_*.ts
