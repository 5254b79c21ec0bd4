#pragma once

#include <QMap>
#include <QStringList>

#include "app/document/edits/recovery.h"
#include "core/mesh/error.h"

namespace wend {

/// A picture that is transparent everywhere.
class NothingToSee : public InputError {
  public:
    using InputError::InputError;
};

/// Reads a project, a picture or a mesh, told apart by the file's extension, and makes a project of it; a
/// mesh in space becomes a project in space: tetrahedra its mesh, a surface its surface. Runs
/// in any thread. Throws InputError with what to do about it, NothingToSee unless `evenIfBlank`.
OpenedFile openFile(const QString& path, bool evenIfBlank = false);

/// The files that a project needs and that are not there, by their absolute paths.
QStringList missingFiles(const QString& project);
/// The project with other files in the place of those.
OpenedFile openMoved(const QString& project, const QMap<QString, QString>& found);

/// Work that was lost in a crash, as changes that are not saved yet. Throws as openFile().
OpenedFile openLost(const LostWork& work);

/// Where new files of a document are proposed: beside its own, but not among the samples.
QString proposedFolder(const Document& document);

/// Whether that is a file of a kind that openFile() reads: by its extension, or as a picture by its first
/// bytes.
bool mayBeOpened(const QString& path);

/// Patterns of a file dialog, "*.png *.tif …".
QString pictureExtensions();
QString meshExtensions();

/// Sample projects: installed beside the program, or those of the source tree; pictures first.
QStringList samplePaths();
/// What there is to see of a project that is not open: the picture that it shows, or of a solid one of the
/// same name beside it, empty if it has none. Nothing of one that cannot be read.
struct ProjectLook {
    QString picture;
    bool isSolid = false;
};
ProjectLook lookOf(const QString& project);

}  // namespace wend
