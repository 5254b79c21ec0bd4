#pragma once

#include <QImage>
#include <QString>

#include "app/view/picture_dialog.h"

namespace wend {

class SolidCanvas;

/// The view as a picture with what was chosen. Null where the memory does not suffice.
QImage viewPicture(SolidCanvas& canvas, const PictureChoice& choice);

/// The same as a file, by extension; formats without alpha get the view's background. Throws InputError.
void writeViewPicture(const QString& path, SolidCanvas& canvas, PictureChoice choice);

}  // namespace wend
