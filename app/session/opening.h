#pragma once

#include <QMap>
#include <QStringList>

#include "app/project/edits/recovery.h"
#include "core/base/error.h"
#include "warp/vector_drawing.h"

namespace wend {

/// A picture that is transparent everywhere.
class NothingToSee : public InputError {
  public:
    using InputError::InputError;
};

/// Reads a project, a picture or a mesh, distinguished by the extension, and makes a project of it. A spatial
/// mesh becomes a solid: tetrahedra are its mesh, a surface its boundary. Thread-safe. Throws InputError with
/// advice, and NothingToSee for a blank picture unless `evenIfBlank`. A drawing is drawn in the size `drawn`.
OpenedFile openFile(const QString& path, bool evenIfBlank = false, const DrawnSize& drawn = {});

/// Reads several pictures as the parts of one, the first one in front, each at its place in its own picture.
/// Throws as openFile(), and for files that are not pictures.
OpenedFile openTogether(const QStringList& paths);

/// Returns the absolute paths of the files that a project needs and that are missing.
QStringList missingFiles(const QString& project);
/// Opens a project with other files in the place of missing ones.
OpenedFile openMoved(const QString& project, const QMap<QString, QString>& found);

/// Work that was lost in a crash, as changes that are not saved yet. Throws as openFile().
OpenedFile openLost(const LostWork& work);

/// Returns the folder that is proposed for new files: the document's own, but never that of the samples.
QString proposedFolder(const Document& document);

/// Returns whether openFile() reads this kind of file, by its extension or, for pictures, by its first bytes.
bool mayBeOpened(const QString& path);

/// Return the patterns of a file dialog, "*.png *.tif …".
QString pictureExtensions();
QString meshExtensions();

/// Returns the sample projects, installed beside the program or in the source tree; pictures come first.
QStringList samplePaths();
/// The preview of an unopened project: its picture, or for a solid the picture of the same name beside it.
/// Empty if there is none or if the project cannot be read.
struct ProjectLook {
    QString picture;
    bool isSolid = false;
};
ProjectLook lookOf(const QString& project);

}  // namespace wend
