#include "app/views/volume/volume_picture.h"

namespace wend {

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

}  // namespace wend
