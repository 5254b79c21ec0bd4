#include "app/views/volume/texture_file.h"

#include <algorithm>

#include "app/engine/shape/picture_file.h"

namespace wend {

namespace {

constexpr int kLargest = 4096;  // pixels

QImage textureOf(const SkinMaterial& material) {
    if (material.texture.empty()) return {};
    const QImage image = pictureOfFile(material.texture);
    if (std::max(image.width(), image.height()) <= kLargest) return image;
    return image.scaled(kLargest, kLargest, Qt::KeepAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGBA8888);
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
