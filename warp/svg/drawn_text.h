#pragma once

#include <QRectF>
#include <string>
#include <vector>

#include "warp/svg_path.h"

namespace wend {

/// The outlines of letters of one colour.
struct TextOutlines {
    SvgPath path;
    std::string colour;  // #rrggbb
    double opacity = 1;
};

/// Returns the outlines of a drawing of text, in the coordinates of its view box.
std::vector<TextOutlines> textOutlines(const std::string& svg, const QRectF& viewBox);

}  // namespace wend
