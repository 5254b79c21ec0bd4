#include "app/view/volume/texture_file.h"

#include <QImageReader>
#include <algorithm>

namespace wend {

namespace {

constexpr int kLargest = 4096;  // pixels

QImage textureOf(const SkinMaterial& material) {
    if (material.texture.empty()) return {};
    QImageReader reader(QString::fromStdString(material.texture));
    reader.setAutoTransform(true);
    const QSize size = reader.size();
    if (size.isValid() && std::max(size.width(), size.height()) > kLargest)
        reader.setScaledSize(size.scaled(kLargest, kLargest, Qt::KeepAspectRatio));
    return reader.read().convertToFormat(QImage::Format_RGBA8888);
}

}  // namespace

std::vector<QImage> texturesOf(const Skin* skin, QStringList* unread) {
    std::vector<QImage> pictures;
    if (!skin) return pictures;
    for (const SkinMaterial& material : skin->materials) {
        pictures.push_back(textureOf(material));
        const QString file = QString::fromStdString(material.texture);
        if (unread && !file.isEmpty() && pictures.back().isNull() && !unread->contains(file)) *unread << file;
    }
    return pictures;
}

}  // namespace wend
