#pragma once

#include <QImage>
#include <QStringList>
#include <vector>

#include "core/mesh/skin.h"

namespace wend {

/// The pictures of the skin's materials, null where there is none or it cannot be read; no larger than what
/// every graphics card takes. No skin has none. `unread` gets the files that cannot be read.
std::vector<QImage> texturesOf(const Skin* skin, QStringList* unread = nullptr);

}  // namespace wend
