#include "warp/atlas.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/base/error.h"
#include "warp/convert.h"

namespace wend {
namespace {

constexpr int kGutter = 32;  // pixels around every picture

/// Returns the layout that holds all sheets.
PixelLayout commonLayout(const std::vector<Sheet>& sheets) {
    PixelLayout layout{PixelType::UInt8, 2, true, sheets.front().picture->unassociated};
    if (!sheets.front().picture->alpha) layout.unassociated = true;
    for (const Sheet& sheet : sheets) {
        layout.type = std::max(layout.type, sheet.picture->type);
        if (sheet.picture->colours() > 1) layout.channels = 4;
    }
    return layout;
}

Image emptyImage(const std::vector<Sheet>& sheets, int width, int height) {
    const PixelLayout layout = commonLayout(sheets);
    Image image{width,
                height,
                layout.channels,
                layout.type,
                true,
                layout.unassociated,
                {},
                sheets.front().picture->metadata};
    return image;
}

/// Packs the pictures in rows, the highest first, about as wide as high. Returns the size.
std::pair<int, int> pack(const std::vector<Sheet>& sheets, std::vector<Vec2>& places) {
    std::vector<std::size_t> order(sheets.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return sheets[a].picture->height > sheets[b].picture->height;
    });
    double area = 0;
    int widest = 0;
    for (const Sheet& sheet : sheets) {
        const int width = sheet.picture->width + 2 * kGutter, height = sheet.picture->height + 2 * kGutter;
        area += static_cast<double>(width) * height;
        widest = std::max(widest, width);
    }
    if (area > 1e6 * kMaxMegapixels)
        throw InputError("its parts have more than " + std::to_string(static_cast<int>(kMaxMegapixels)) +
                         " million pixels");
    const int width = std::max(widest, static_cast<int>(std::ceil(std::sqrt(area))));
    int x = 0, y = 0, rowHeight = 0;
    places.resize(sheets.size());
    for (const std::size_t i : order) {
        const int own = sheets[i].picture->width + 2 * kGutter;
        if (x + own > width) x = 0, y += std::exchange(rowHeight, 0);
        places[i] = {x + kGutter, y + kGutter};
        x += own;
        rowHeight = std::max(rowHeight, sheets[i].picture->height + 2 * kGutter);
    }
    return {width, y + rowHeight};
}

/// Copies a sheet, with its border repeated around it.
void copySheet(const Image& sheet, int x, int y, Image& atlas) {
    const std::size_t pixel = atlas.pixelBytes();
    for (int row = -kGutter; row < sheet.height + kGutter; ++row) {
        const std::byte* from = sheet.row(std::clamp(row, 0, sheet.height - 1));
        std::byte* to = atlas.row(y + row) + pixel * static_cast<std::size_t>(x);
        std::copy_n(from, sheet.rowBytes(), to);
        for (int k = 1; k <= kGutter; ++k) {
            const std::byte* last = from + sheet.rowBytes() - pixel;
            std::copy_n(from, pixel, to - pixel * static_cast<std::size_t>(k));
            std::copy_n(last, pixel, to + sheet.rowBytes() + pixel * static_cast<std::size_t>(k - 1));
        }
    }
}

/// Lays a row of a sheet over another: associated, alpha last.
void layOver(const std::vector<float>& top, const Sheet& sheet, const PixelLayout& layout, float* row) {
    const auto channels = static_cast<std::size_t>(layout.channels), last = channels - 1;
    const auto opacity = static_cast<float>(sheet.shownOpacity());
    const bool isLight = layout.type == PixelType::Half || layout.type == PixelType::Float;
    for (std::size_t i = 0; i < top.size(); i += channels) {
        const float alpha = opacity * top[i + last], below = row[i + last];
        for (std::size_t c = 0; c < last; ++c)
            row[i + c] = blendedColour(sheet.blend, opacity * top[i + c], alpha, row[i + c], below, isLight);
        row[i + last] = alpha + (1 - alpha) * below;
    }
}

}  // namespace

Image faded(const Image& image, const std::function<void(int, std::vector<float>&)>& factor) {
    PixelLayout layout = layoutOf(image);
    if (!layout.alpha) layout.alpha = layout.unassociated = true, ++layout.channels;
    Image result = converted(image, layout);
    const auto channels = static_cast<std::size_t>(layout.channels);
    std::vector<float> row(channels * static_cast<std::size_t>(image.width)),
        factors(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        factor(y, factors);
        if (std::ranges::all_of(factors, [](float one) { return one == 1; })) continue;
        loadRow(result, y, row.data());
        for (std::size_t x = 0; x < factors.size(); ++x)
            for (std::size_t c = layout.unassociated ? channels - 1 : 0; c < channels; ++c)
                row[x * channels + c] *= factors[x];
        storeRow(result, y, row.data());
    }
    return result;
}

Atlas makeAtlas(const std::vector<Sheet>& sheets) {
    Atlas atlas;
    const auto [width, height] = pack(sheets, atlas.places);
    atlas.picture = emptyImage(sheets, width, height);
    atlas.picture.makePixels();
    const PixelLayout layout = layoutOf(atlas.picture);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        Image sheet = converted(*sheets[i].picture, layout);
        const auto opacity = static_cast<float>(sheets[i].shownOpacity());
        if (opacity != 1)
            sheet = faded(sheet, [&](int, std::vector<float>& row) { std::ranges::fill(row, opacity); });
        copySheet(sheet, static_cast<int>(atlas.places[i].x()), static_cast<int>(atlas.places[i].y()),
                  atlas.picture);
    }
    return atlas;
}

Image flattened(const std::vector<Sheet>& sheets, int width, int height) {
    Image image = emptyImage(sheets, width, height);
    image.makePixels();
    PixelLayout layout = layoutOf(image);
    const bool unassociated = std::exchange(layout.unassociated, false);
    image.unassociated = false;
    const auto channels = static_cast<std::size_t>(layout.channels);
    for (auto sheet = sheets.rbegin(); sheet != sheets.rend(); ++sheet) {
        const Image own = converted(*sheet->picture, layout);
        const int left = static_cast<int>(std::lround(sheet->at.x())),
                  top = static_cast<int>(std::lround(sheet->at.y()));
        const int begin = std::max(0, left), end = std::min(width, left + own.width);
        std::vector<float> row(channels * static_cast<std::size_t>(own.width)),
            below(channels * static_cast<std::size_t>(width));
        for (int y = std::max(0, top); y < std::min(height, top + own.height) && begin < end; ++y) {
            loadRow(own, y - top, row.data());
            loadRow(image, y, below.data());
            const auto first = row.begin() + static_cast<std::ptrdiff_t>(channels) * (begin - left);
            layOver({first, first + static_cast<std::ptrdiff_t>(channels) * (end - begin)}, *sheet, layout,
                    below.data() + channels * static_cast<std::size_t>(begin));
            storeRow(image, y, below.data());
        }
    }
    layout.unassociated = unassociated;
    return converted(image, layout);
}

}  // namespace wend
