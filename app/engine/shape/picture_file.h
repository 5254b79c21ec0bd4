#pragma once

#include <QImage>
#include <string>

namespace wend {

/// Returns the picture of a file for Qt, with unassociated alpha; null if it cannot be read. Only readImage()
/// reads foreign files, never Qt's own readers.
QImage pictureOfFile(const std::string& path);

}  // namespace wend
