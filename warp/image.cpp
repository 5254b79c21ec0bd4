#include "warp/image.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cstdint>

namespace wend {
namespace {

std::size_t sampleBytes(PixelType type) {
    switch (type) {
        case PixelType::UInt8:
            return 1;
        case PixelType::UInt16:
        case PixelType::Half:
            return 2;
        case PixelType::Float:
            return 4;
    }
    return 0;
}

/// Advice that may be refused, and changes nothing but the speed.
void wantLargePages(std::byte* data, std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t kLargePage = 2 << 20;
    const auto begin = reinterpret_cast<std::uintptr_t>(data);
    const std::uintptr_t first = (begin + kLargePage - 1) / kLargePage * kLargePage,
                         last = (begin + bytes) / kLargePage * kLargePage;
    if (first < last) madvise(data + (first - begin), last - first, MADV_HUGEPAGE);
#else
    static_cast<void>(data), static_cast<void>(bytes);
#endif
}

}  // namespace

PixelBox PixelBox::within(int pictureWidth, int pictureHeight) const {
    const int left = std::clamp(x, 0, pictureWidth), top = std::clamp(y, 0, pictureHeight);
    return {left, top, std::clamp(x + width, 0, pictureWidth) - left,
            std::clamp(y + height, 0, pictureHeight) - top};
}

bool PixelBox::contains(const PixelBox& box) const {
    return box.x >= x && box.y >= y && box.x + box.width <= x + width && box.y + box.height <= y + height;
}

void Image::reservePixels() {
    const std::size_t bytes = rowBytes() * static_cast<std::size_t>(height);
    data.reserve(bytes);
    wantLargePages(data.data(), bytes);
}

void Image::makePixels() {
    data.clear();
    reservePixels();
    data.resize(rowBytes() * static_cast<std::size_t>(height));
}

std::size_t Image::pixelBytes() const {
    return sampleBytes(type) * static_cast<std::size_t>(channels);
}

}  // namespace wend
