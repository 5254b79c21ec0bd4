#pragma once

#include <cmath>

#include "tests/support/pictures.h"
#include "warp/warped_picture.h"

namespace wend::test {

const View kView{64, 48, Vec2::Zero(), 1};

inline SimplicialMesh<2> wholePicture(int n = 7) {
    return rectangle({0, 0}, {64, 48}, n);
}

/// A smooth map without folds that moves the border too.
inline Points2 wave(const Points2& rest, double amount = 3) {
    Points2 pose = rest;
    for (Eigen::Index i = 0; i < rest.cols(); ++i)
        pose.col(i) += amount * Vec2(std::sin(rest(1, i) / 9.0), std::cos(rest(0, i) / 7.0));
    return pose;
}

inline double area(const SimplicialMesh<2>& mesh, const Points2& pose) {
    double sum = 0;
    for (const auto& cell : mesh.cells) sum += std::abs(cellMeasure<2>(pose, cell));
    return sum;
}

inline double alphaSum(const Image& image) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            sum += valueAt<std::uint8_t>(image, x, y, image.channels - 1) / 255.0;
    return sum;
}

}  // namespace wend::test
