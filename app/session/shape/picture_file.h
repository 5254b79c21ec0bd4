#pragma once

#include <QImage>
#include <string>

namespace wend {

/// The picture of a file as Qt draws it, colours not multiplied with alpha; null if it cannot be read. Qt's
/// own readers are not asked: files of others come in through readImage() alone.
QImage pictureOfFile(const std::string& path);

}  // namespace wend
