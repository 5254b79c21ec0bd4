#pragma once

#include <QString>
#include <array>

#include "core/motion/handle.h"

namespace wend {

/// In the order of menus and lists.
inline constexpr std::array kEases = {Ease::Linear, Ease::In, Ease::Out, Ease::InOut};
/// For a menu, with a key.
QString easeName(Ease ease);

}  // namespace wend
