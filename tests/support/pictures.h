#pragma once

#include <cmath>
#include <random>

#include "core/mesh/simplicial_mesh.h"
#include "warp/pixels.h"

namespace wend::test {

/// A picture of random numbers in the whole range of its type; alpha in steps from transparent to opaque.
inline Image randomPicture(int width, int height, int channels, PixelType type, bool alpha,
                           unsigned seed = 1) {
    Image image{width, height, channels, type, alpha, alpha, {}, nullptr};
    image.data.resize(static_cast<std::size_t>(width) * height * image.pixelBytes());
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(0, 1);
    withPixelType(type, [&](auto t) {
        using T = decltype(t);
        T* p = reinterpret_cast<T*>(image.data.data());
        for (int k = 0; k < width * height * channels; ++k) p[k] = toPixel<T>(number(random) * kFull<T>);
        for (int k = 0; alpha && k < width * height; ++k)
            p[(k + 1) * channels - 1] = toPixel<T>(static_cast<float>(k % 5) / 4 * kFull<T>);
    });
    return image;
}

/// One colour everywhere.
inline Image plainPicture(int width, int height, const std::vector<std::uint8_t>& colour) {
    Image image{width,
                height,
                static_cast<int>(colour.size()),
                PixelType::UInt8,
                colour.size() == 2 || colour.size() == 4,
                true,
                {},
                nullptr};
    for (int k = 0; k < width * height; ++k)
        for (std::uint8_t c : colour) image.data.push_back(static_cast<std::byte>(c));
    image.unassociated = image.alpha;
    return image;
}

template <typename T>
T valueAt(const Image& image, int x, int y, int channel) {
    return reinterpret_cast<const T*>(image.row(y))[x * image.channels + channel];
}

/// The rectangle from low to high in n × n squares of two triangles.
inline SimplicialMesh<2> rectangle(const Vec2& low, const Vec2& high, int n) {
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, (n + 1) * (n + 1));
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.points.col(j * (n + 1) + i) = low + (high - low).cwiseProduct(Vec2(i, j)) / n;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            mesh.cells.push_back({a, b, d});
            mesh.cells.push_back({a, d, c});
        }
    return mesh;
}

/// Joins two parts into one shape; the second one is over the first.
inline SimplicialMesh<2> joined(SimplicialMesh<2> mesh, const SimplicialMesh<2>& other) {
    const int first = mesh.vertexCount();
    mesh.points.conservativeResize(2, first + other.vertexCount());
    mesh.points.rightCols(other.vertexCount()) = other.points;
    for (Cell<2> cell : other.cells) {
        for (int& v : cell) v += first;
        mesh.cells.push_back(cell);
    }
    return mesh;
}

/// A strip bent into 1.3 turns of a ring about (80, 80), from radius 40 to 64: it covers itself for 0.3 of
/// one.
inline Points2 rolledUp(const Points2& rest, const Vec2& size) {
    Points2 pose = rest;
    for (Eigen::Index i = 0; i < rest.cols(); ++i) {
        const double angle = 2 * M_PI * 1.3 * rest(0, i) / size.x(), radius = 64 - 24 * rest(1, i) / size.y();
        pose.col(i) = Vec2(80 + radius * std::cos(angle), 80 + radius * std::sin(angle));
    }
    return pose;
}

}  // namespace wend::test
