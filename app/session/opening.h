#pragma once

#include <QStringList>

#include "app/document/document.h"

namespace wend {

/// Reads a project, a picture, a mesh or a surface, told apart by the file's extension, and makes a project
/// of it. Runs in any thread. Throws InputError with what to do about it.
OpenedFile openFile(const QString& path);

/// Patterns of a file dialog, "*.png *.tif …".
QString pictureExtensions();
QString meshExtensions();
bool looksOpenable(const QString& path);

/// Sample projects: installed beside the program, or those of the source tree.
QStringList samplePaths();
/// The picture that a project shows, for a thumbnail; empty if it has none.
QString picturePathOf(const QString& project);

}  // namespace wend
