#include "warp/at_rest.h"

#include <algorithm>
#include <cstring>

namespace wend {
namespace {

/// Marks the pixels of one row in [from − margin, to + margin[ in the rows near it.
void mark(std::vector<std::uint8_t>& near, const Image& strip, int top, int y, int from, int to, int margin) {
    const int first = std::max(from - margin, 0), last = std::min(to + margin, strip.width);
    for (int row = std::max(y - margin, top); row <= std::min(y + margin, top + strip.height - 1); ++row)
        std::fill_n(near.begin() + static_cast<std::ptrdiff_t>(row - top) * strip.width + first, last - first,
                    std::uint8_t(1));
}

std::vector<std::uint8_t> nearTheShape(const WarpJob& job, int margin, int top, const Image& strip) {
    std::vector<std::uint8_t> near(static_cast<std::size_t>(strip.width) * strip.height);
    const int begin = std::max(top - margin, 0), end = std::min(top + strip.height + margin, job.view.height);
    for (const VisibleCell& cell : job.cells)
        forRuns(cell.rows, begin, end, strip.width,
                [&](int y, int from, int to) { mark(near, strip, top, y, from, to, margin); });
    return near;
}

}  // namespace

bool isAtRest(const Image& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view) {
    return view.width == source.width && view.height == source.height && view.origin == Vec2::Zero() &&
           view.scale == 1 && pose == rest.points;
}

void copyAtRest(const WarpJob& job, int margin, int top, Image& strip) {
    const Image& source = job.source->base();
    const std::size_t bytes = source.pixelBytes();
    const std::vector<std::uint8_t> near = nearTheShape(job, margin, top, strip);
    for (int row = 0; row < strip.height; ++row) {
        const std::uint8_t* marks = near.data() + static_cast<std::ptrdiff_t>(row) * strip.width;
        const std::uint8_t* const end = marks + strip.width;
        for (const std::uint8_t* at = std::find(marks, end, 1); at != end;) {
            const std::uint8_t* stop = std::find(at, end, 0);
            const auto offset = static_cast<std::size_t>(at - marks) * bytes;
            std::memcpy(strip.row(row) + offset, source.row(top + row) + offset,
                        static_cast<std::size_t>(stop - at) * bytes);
            at = std::find(stop, end, 1);
        }
    }
}

}  // namespace wend
