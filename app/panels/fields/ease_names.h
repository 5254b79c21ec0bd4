#pragma once

#include <QString>
#include <array>

#include "core/motion/handle.h"

namespace wend {

/// The order in menus and lists.
inline constexpr std::array kEases = {Ease::Linear, Ease::In, Ease::Out, Ease::InOut};
/// Returns the name for a menu, with a mnemonic.
QString easeName(Ease ease);

}  // namespace wend
