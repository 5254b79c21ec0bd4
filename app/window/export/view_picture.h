#pragma once

#include <QImage>
#include <QString>

#include "app/window/export/picture_dialog.h"

namespace wend {

class SolidCanvas;

/// Returns a picture of the view. Null if memory is insufficient.
QImage viewPicture(SolidCanvas& canvas, const PictureChoice& choice);

/// Writes the view as a file, by extension; formats without alpha get the view's background. The picture is
/// drawn and written in strips with progress; returns false if it was cancelled. A film is drawn frame by
/// frame over the whole motion. Throws InputError, also if memory is insufficient.
bool writeViewPicture(const QString& path, SolidCanvas& canvas, PictureChoice choice);

}  // namespace wend
