#pragma once

class QMenu;

namespace wend {

/// Sees to it that a letter opens one entry of a menu and does not go round among several, whatever the
/// language: where a letter is taken already, the entry gets another one of its text. So in the menus below.
void makeLettersUnique(QMenu& menu);

}  // namespace wend
