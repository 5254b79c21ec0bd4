#pragma once

#include <QImage>
#include <QString>

#include "app/view/export/picture_dialog.h"

namespace wend {

class SolidCanvas;

/// The view as a picture with what was chosen. Null where the memory does not suffice.
QImage viewPicture(SolidCanvas& canvas, const PictureChoice& choice);

/// The same as a file, by extension; formats without alpha get the view's background. Drawn and written strip
/// by strip, the writing in another thread, with progress and a way to cancel; returns when it is done, false
/// if it was cancelled. A film is drawn so frame by frame, from the start of the motion to its end. Throws
/// InputError, also where the memory does not suffice.
bool writeViewPicture(const QString& path, SolidCanvas& canvas, PictureChoice choice);

}  // namespace wend
