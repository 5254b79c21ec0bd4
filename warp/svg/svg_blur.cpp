#include "warp/svg/svg_blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace wend {
namespace {

/// Pixels that follow one another in a row or column, and the numbers of one channel.
using Line = std::vector<float>;

int sizeOfMean(double deviation) {
    return static_cast<int>(std::floor(deviation * 3 * std::sqrt(2 * std::numbers::pi) / 4 + 0.5));
}

/// Takes the mean of `size` numbers, of which `before` lie before each one.
void mean(const Line& from, Line& to, int size, int before) {
    const int count = static_cast<int>(from.size());
    const auto at = [&](int k) { return k >= 0 && k < count ? from[static_cast<std::size_t>(k)] : 0.0F; };
    double sum = 0;
    for (int k = -before; k < size - before; ++k) sum += static_cast<double>(at(k));
    for (int k = 0; k < count; ++k) {
        to[static_cast<std::size_t>(k)] = static_cast<float>(sum / size);
        sum += static_cast<double>(at(k + size - before)) - static_cast<double>(at(k - before));
    }
}

/// Means of an even size are taken one pixel to the left, one to the right, and the last one is larger by
/// one.
void blurLine(Line& line, Line& other, int size) {
    const bool isEven = size % 2 == 0;
    mean(line, other, size, size / 2);
    mean(other, line, size, isEven ? size / 2 - 1 : size / 2);
    mean(line, other, isEven ? size + 1 : size, size / 2);
    line.swap(other);
}

/// Blurs lines of `count` pixels, of which each is `step` bytes after the one before.
void blurLines(uchar* first, int lines, std::ptrdiff_t nextLine, int count, std::ptrdiff_t step, int size) {
    if (size < 2) return;
    Line line(static_cast<std::size_t>(count)), other(line.size());
    for (int k = 0; k < lines; ++k)
        for (int c = 0; c < 4; ++c) {
            uchar* const begin = first + k * nextLine + c;
            bool isEmpty = true;
            for (int i = 0; i < count; ++i) {
                line[static_cast<std::size_t>(i)] = begin[i * step];
                isEmpty = isEmpty && begin[i * step] == 0;
            }
            if (isEmpty) continue;
            blurLine(line, other, size);
            for (int i = 0; i < count; ++i)
                begin[i * step] = static_cast<uchar>(line[static_cast<std::size_t>(i)] + 0.5F);
        }
}

}  // namespace

int reachOfBlur(double deviation) {
    return 3 * (sizeOfMean(deviation) / 2 + 1);
}

void blur(QImage& image, double acrossRows, double acrossColumns) {
    uchar* const first = image.bits();
    const std::ptrdiff_t row = image.bytesPerLine();
    blurLines(first, image.height(), row, image.width(), 4, sizeOfMean(acrossColumns));
    blurLines(first, image.width(), 4, image.height(), row, sizeOfMean(acrossRows));
}

}  // namespace wend
