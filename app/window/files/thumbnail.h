#pragma once

#include <QImage>
#include <QString>

namespace wend {

/// The preview of a file that is not open.
struct Thumbnail {
    QImage picture;  // without a transparent border; null if there is nothing to be shown
    bool isSolid = false;
};

/// Returns the folder of thumbnails in the user's cache.
QString thumbnailFolder();

/// Returns the thumbnail of a picture or a project. It is made on the first request and kept in `folder`,
/// which only its owner may read, until the file or the picture in it changes. Runs in any thread.
Thumbnail thumbnailOf(const QString& path, const QString& folder = thumbnailFolder());
/// Stores the last view of a project's shape as its thumbnail until the file changes.
void keepThumbnail(const QString& project, const QImage& seen, const QString& folder = thumbnailFolder());

}  // namespace wend
