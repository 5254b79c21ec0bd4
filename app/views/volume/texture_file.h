#pragma once

#include <QImage>
#include <QStringList>
#include <vector>

#include "core/mesh/skin.h"

namespace wend {

/// Reads the pictures of the skin's materials, scaled to what every GPU supports; null if there is none or it
/// cannot be read. Empty without a skin. `unread` receives the unreadable files.
std::vector<QImage> texturesOf(const Skin* skin, QStringList* unread = nullptr);

}  // namespace wend
