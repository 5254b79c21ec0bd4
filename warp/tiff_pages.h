#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/input_file.h"
#include "warp/picture_metadata.h"

namespace wend {

/// A directory of a TIFF: the facts about one of its pictures. Of a BigTIFF, and of one that is cut off,
/// nothing is known.
class TiffDirectory {
  public:
    explicit TiffDirectory(const InputFile& file,
                           std::optional<std::uint64_t> at = {});  // without: the first

    bool isKnown() const { return !m_entries.empty(); }
    /// Returns where the next one is; 0 after the last one.
    std::uint64_t next() const { return m_next; }

    /// Returns the number of an entry, that of a fraction or float, or its text; nothing without that entry.
    std::optional<std::uint32_t> value(std::uint32_t tag) const;
    std::optional<double> real(std::uint32_t tag) const;
    std::optional<std::string> text(std::uint32_t tag) const;

    /// Returns whether the file contains the data of a camera's sensor, by DNG's version, Canon's mark, the
    /// photometric interpretation, or a small picture of a camera before the large one.
    bool isCameraRaw() const;
    /// Returns whether it says what the samples after the colours are.
    bool namesExtraSamples() const;

  private:
    std::optional<std::size_t> entry(std::uint32_t tag) const;
    std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t size) const;

    const InputFile& m_file;
    std::string m_head, m_entries;
    std::uint64_t m_next = 0;
};

/// A TIFF in the form that OpenImageIO reads properly.
struct PlainTiff {
    std::string bytes;           // empty: the file itself
    std::vector<bool> inverted;  // of each page: white is 0 in its samples, which `bytes` does not say

    bool isInverted(int page) const {
        return static_cast<std::size_t>(page) < inverted.size() && inverted[static_cast<std::size_t>(page)];
    }
};

/// Names the depth of pages that leave it to the standard (1 bit), and declares black as 0: OpenImageIO takes
/// the depth as 8 bits, inverts samples of some depths only, and alpha with them.
PlainTiff plainTiff(const InputFile& file);

/// Layers that are pages of a TIFF, as GIMP writes them.
struct TiffLayers {
    std::vector<PictureLayer> layers;  // from the back to the front
    std::vector<int> pages;            // of each: its number in the file
};

/// Returns the layers of a TIFF. Pages are layers if all of them have names, and all but the first have
/// alpha; otherwise they are pictures of their own, and there are no layers.
TiffLayers tiffLayers(const InputFile& file);

}  // namespace wend
