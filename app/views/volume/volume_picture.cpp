#include "app/views/volume/volume_picture.h"

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

QRgb dimmed(QRgb colour) {
    const auto half = [](int x) { return (x + 128) / 2; };
    return qRgb(half(qRed(colour)), half(qGreen(colour)), half(qBlue(colour)));
}

VolumePicture pictureOfSurface(const Points<3>& points, const std::vector<std::array<int, 3>>& triangles,
                               std::vector<QRgb> colours) {
    VolumePicture picture;
    picture.rest = std::make_shared<const SimplicialMesh<3>>();
    picture.pose = points;
    auto facets = std::make_shared<std::vector<Facet<3>>>();
    for (const auto& t : triangles) facets->push_back({t, {static_cast<int>(facets->size()), -1}});
    picture.facets = std::move(facets);
    picture.cellColours = std::move(colours);
    return picture;
}

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
