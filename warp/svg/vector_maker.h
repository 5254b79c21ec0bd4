#pragma once

#include <QRectF>
#include <QSize>
#include <pugixml.hpp>

#include "warp/vector_drawing.h"

namespace wend {

/// Returns a drawing as paths, whose view box is drawn as that many pixels. Throws InputError for what refers
/// to itself and for what is too deep or too much.
VectorDrawing vectorsOf(const pugi::xml_document& drawing, const QRectF& viewBox, const QSize& size);

/// Returns the box around an element of a drawing without style sheets, in its own coordinates, without pens,
/// clip paths and masks; a null one if it shows nothing.
QRectF boxOf(const pugi::xml_document& drawing, const pugi::xml_node& element, const QRectF& viewBox);

/// Returns whether an element is one of those that are drawn.
bool isDrawn(const pugi::xml_node& node);

/// Returns a document as text.
std::string textOf(const pugi::xml_document& document);

}  // namespace wend
