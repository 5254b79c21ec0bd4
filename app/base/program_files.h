#pragma once

#include <QString>

namespace wend {

/// Return folders of installed data, relative to the program so that it can be moved; in the source tree if
/// it is not installed. Empty if missing.
QString sampleFolder();
/// Returns the folder of the manual's pages, with its pictures in `pictures`.
QString manualFolder();

}  // namespace wend
