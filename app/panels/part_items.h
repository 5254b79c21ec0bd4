#pragma once

#include <QIcon>
#include <QString>

#include "app/document/part.h"

class QPalette;

namespace wend {

struct Image;

/// Returns the tooltip and accessible description of a part's line.
QString describedPart(const PicturePart& part);

/// Returns a small picture of what is opaque in a part's picture, with the sign of links if the part is
/// joined to another one. Null without a picture.
QIcon partIcon(const PicturePart& part, const Image* picture, const QPalette& palette);

/// The sides of that picture, in pixels of the screen.
inline constexpr int kPartIcon = 28;

}  // namespace wend
