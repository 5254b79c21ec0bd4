#pragma once

#include <QImage>

namespace wend {

/// Blurs a picture of associated RGBA by a Gaussian with these standard deviations, in pixels: by three means
/// in a row, as SVG's feGaussianBlur allows. Beyond its border it is transparent.
/// https://www.w3.org/TR/filter-effects-1/#feGaussianBlurElement
void blur(QImage& image, double acrossRows, double acrossColumns);

/// Returns how far such a blur reaches.
int reachOfBlur(double deviation);

}  // namespace wend
