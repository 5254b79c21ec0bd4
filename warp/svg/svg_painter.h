#pragma once

#include <QImage>
#include <QRectF>
#include <QSize>
#include <pugixml.hpp>

namespace wend {

/// Draws a document, whose view box is drawn as that many pixels, premultiplied. What Qt's library lacks is
/// composited here: clip paths and masks, and the opacity of what overlaps itself.
QImage paintedSvg(const pugi::xml_document& drawing, const QRectF& viewBox, const QSize& size);

}  // namespace wend
