#pragma once

class QMenu;

namespace wend {

/// Makes mnemonics of a menu and its submenus unique in any language: an entry whose letter is taken gets
/// another letter of its text.
void makeLettersUnique(QMenu& menu);

}  // namespace wend
