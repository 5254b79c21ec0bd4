#include "app/window/files/thumbnail.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

#include "app/engine/shape/picture_file.h"
#include "app/session/opening.h"

namespace wend {

namespace {

constexpr int kMostKept = 100;
constexpr QSize kLargest(344, 300);

/// Returns the part of the picture that is not transparent.
QRect opaquePart(const QImage& image) {
    QRect part;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qAlpha(image.pixel(x, y)) > 8) part |= QRect(x, y, 1, 1);
    return part;
}

QImage smallPictureOf(const QImage& image) {
    if (image.isNull()) return {};
    const QImage small = image.scaled(720, 720, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    return small.copy(opaquePart(small)).scaled(kLargest, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

/// Returns a key that changes with the file.
QByteArray pictureStamp(const QString& file) {
    const QFileInfo info(file);
    return file.toUtf8() + '\n' + QByteArray::number(info.size()) + '\n' +
           QByteArray::number(info.lastModified().toMSecsSinceEpoch()) + '\n';
}

/// Returns the path of a file's thumbnail.
QString placeOf(const QString& path, const ProjectLook& look, const QString& folder) {
    const QByteArray name =
        QCryptographicHash::hash(pictureStamp(path) + pictureStamp(look.picture), QCryptographicHash::Sha1);
    return QDir(folder).filePath(QString::fromLatin1(name.toHex()) + QStringLiteral(".png"));
}

/// Removes the oldest thumbnails.
void makeRoomIn(const QString& folder) {
    const QStringList kept = QDir(folder).entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
    for (const QString& old : kept.mid(kMostKept)) QFile::remove(QDir(folder).filePath(old));
}

/// Stores a thumbnail in the cache; if that fails, it is drawn again the next time.
void keep(const QImage& picture, const QString& path) {
    const QString folder = QFileInfo(path).path();
    constexpr auto kPrivate = QFile::ReadOwner | QFile::WriteOwner;
    if (!QDir().mkpath(folder)) return;
    QFile::setPermissions(folder, kPrivate | QFile::ExeOwner);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return;
    file.setPermissions(kPrivate);
    if (picture.save(&file, "PNG")) file.commit();
    makeRoomIn(folder);
}

}  // namespace

QString thumbnailFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
        .filePath(QStringLiteral("thumbnails"));
}

Thumbnail thumbnailOf(const QString& path, const QString& folder) {
    const bool project = QFileInfo(path).suffix() == QStringLiteral("wend");
    const ProjectLook look = project ? lookOf(path) : ProjectLook{path};
    Thumbnail thumbnail;
    thumbnail.isSolid = look.isSolid;
    const QString kept = placeOf(path, look, folder);
    if (thumbnail.picture.load(kept, "PNG") || look.picture.isEmpty()) return thumbnail;
    thumbnail.picture = smallPictureOf(pictureOfFile(look.picture.toStdString()));
    if (!thumbnail.picture.isNull()) keep(thumbnail.picture, kept);
    return thumbnail;
}

void keepThumbnail(const QString& project, const QImage& seen, const QString& folder) {
    const QImage small = smallPictureOf(seen);
    if (!small.isNull()) keep(small, placeOf(project, lookOf(project), folder));
}

}  // namespace wend
