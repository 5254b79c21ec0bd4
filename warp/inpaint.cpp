#include "warp/inpaint.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "core/base/error.h"
#include "core/base/fed_process.h"
#include "core/base/printable.h"
#include "core/base/temporary_folder.h"

namespace wend {
namespace {

constexpr float kWhite = 255;           // that G'MIC's filters expect
constexpr double kMostPixels = 1e6;     // in which patches are matched: about ten seconds
constexpr double kMostLed = 60000;      // of a hole, into which stems and edges are continued
constexpr double kSurroundings = 0.75;  // of the hole's size, on each side
constexpr int kFewestAround = 64;       // pixels

std::string program() {
    return programInPath("gmic");
}

/// The file of two images that G'MIC reads, a picture and its hole: a line of text with the sizes before the
/// floats of each, channel by channel.
class ExchangeFile {
  public:
    ExchangeFile(const Image& picture, const std::vector<bool>& hole) : m_picture(picture), m_hole(hole) {}

    void write(const std::string& path) const {
        std::ofstream file(path, std::ios::binary);
        file << "2 float little_endian\n" << sizes(m_picture.channels);
        std::vector<float> row(static_cast<std::size_t>(m_picture.width));
        for (int c = 0; c < m_picture.channels; ++c)
            for (int y = 0; y < m_picture.height; ++y) {
                for (std::size_t x = 0; x < row.size(); ++x) row[x] = kWhite * pixels(m_picture, y)[at(x, c)];
                put(file, row);
            }
        file << sizes(1);
        for (int y = 0; y < m_picture.height; ++y) {
            for (std::size_t x = 0; x < row.size(); ++x) row[x] = isHole(x, y) ? 1.0F : 0.0F;
            put(file, row);
        }
        if (!file.flush()) throw InputError(path, "cannot be written");
    }

    /// Takes what is in the hole from a file of one image.
    void read(const std::string& path, Image& filled) const {
        std::ifstream file(path, std::ios::binary);
        std::string type, size;
        std::getline(file, type);
        std::getline(file, size);
        if (type != "1 float little_endian" || size + "\n" != sizes(m_picture.channels))
            throw InputError("gmic", "has written another picture than it was asked for");
        std::vector<float> row(static_cast<std::size_t>(m_picture.width));
        for (int c = 0; c < m_picture.channels; ++c)
            for (int y = 0; y < m_picture.height; ++y) {
                file.read(reinterpret_cast<char*>(row.data()),
                          static_cast<std::streamsize>(row.size() * sizeof(float)));
                if (!file) throw InputError("gmic", "has not written all of the picture");
                take(row, c, y, filled);
            }
    }

  private:
    std::string sizes(int channels) const {
        return std::to_string(m_picture.width) + ' ' + std::to_string(m_picture.height) + " 1 " +
               std::to_string(channels) + '\n';
    }
    static const float* pixels(const Image& image, int y) {
        return reinterpret_cast<const float*>(image.row(y));
    }
    std::size_t at(std::size_t x, int c) const {
        return x * static_cast<std::size_t>(m_picture.channels) + static_cast<std::size_t>(c);
    }
    bool isHole(std::size_t x, int y) const {
        return m_hole[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_picture.width) + x];
    }
    static void put(std::ofstream& file, const std::vector<float>& row) {
        file.write(reinterpret_cast<const char*>(row.data()),
                   static_cast<std::streamsize>(row.size() * sizeof(float)));
    }
    void take(const std::vector<float>& row, int c, int y, Image& filled) const {
        auto* out = reinterpret_cast<float*>(filled.row(y));
        const float most = m_picture.alpha && c + 1 == m_picture.channels ? 1 : HUGE_VALF;
        for (std::size_t x = 0; x < row.size(); ++x)
            if (isHole(x, y))
                out[at(x, c)] = std::clamp(std::isfinite(row[x]) ? row[x] / kWhite : 0.0F, 0.0F, most);
    }

    const Image& m_picture;
    const std::vector<bool>& m_hole;
};

/// Returns the arguments that G'MIC gets with the two images. With several threads the result would differ
/// each time. Matching patches from a coarse scale on loses stems and edges that lead into the hole; so these
/// are continued first, patch by patch from the border (Criminisi, Pérez, Toyama 2004), and the scales refine
/// that. Across a large hole nothing is led, and objects beside it would be repeated in it.
std::vector<std::string> wordsFor(const std::string& in, const std::string& out, const Image& picture,
                                  const std::vector<bool>& hole) {
    const double pixels = static_cast<double>(picture.width) * picture.height;
    std::vector<std::string> words{"-srand", "1", "-input", in};
    const bool isReduced = pixels > kMostPixels;
    const double scale = isReduced ? std::sqrt(kMostPixels / pixels) : 1;
    const double holePixels = static_cast<double>(std::ranges::count(hole, true)) * scale * scale;
    if (isReduced) {
        const std::string size = std::to_string(std::max(1L, std::lround(scale * picture.width))) + "," +
                                 std::to_string(std::max(1L, std::lround(scale * picture.height)));
        words.insert(words.end(), {"-resize", size + ",1,100%,2", "-gt[1]", "0"});
    }
    if (holePixels > kMostLed)
        words.insert(words.end(), {"-inpaint_matchpatch[0]", "[1]"});
    else  // patches of 15 pixels from 100 around; then 4 scales, patches of 9, 10 iterations, blended over 5
        words.insert(words.end(),
                     {"-inpaint[0]", "[1],15,100,1,1", "-inpaint_matchpatch[0]", "[1],4,9,10,5,1,1"});
    words.insert(words.end(), {"-remove[1]"});
    if (isReduced)
        words.insert(words.end(), {"-resize", std::to_string(picture.width) + "," +
                                                  std::to_string(picture.height) + ",1,100%,5"});
    words.insert(words.end(), {"-output", out + ",float"});
    return words;
}

/// Returns the last line of a program's output.
std::string lastLine(const std::string& output) {
    std::istringstream lines(output);
    std::string last = "it says nothing";
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) last = line;
    return printable(last);
}

}  // namespace

bool canInpaint() {
    return !program().empty();
}

PixelBox surroundings(const PixelBox& hole, int width, int height) {
    const int by =
        std::max(kFewestAround, static_cast<int>(kSurroundings * std::max(hole.width, hole.height)));
    return PixelBox{hole.x - by, hole.y - by, hole.width + 2 * by, hole.height + 2 * by}.within(width,
                                                                                                height);
}

Image inpainted(const Image& picture, const std::vector<bool>& hole, const std::stop_token& stop) {
    Image filled = picture;
    if (std::ranges::find(hole, true) == hole.end()) return filled;
    const TemporaryFolder folder(scratchFolder());
    const std::string in = folder.path() + "/in.cimg", out = folder.path() + "/out.cimg";
    const ExchangeFile exchange(picture, hole);
    exchange.write(in);
    // Its settings, too, are in the folder: it leaves nothing behind, and reads no commands of the user.
    std::vector<std::string> words{"OMP_NUM_THREADS=1", "GMIC_PATH=" + folder.path(), program()};
    const std::vector<std::string> own = wordsFor(in, out, picture, hole);
    words.insert(words.end(), own.begin(), own.end());
    FedProcess gmic(programInPath("env"), words);
    if (!gmic.finish(stop)) throw InputError("gmic", "cannot fill the ground: " + lastLine(gmic.output()));
    exchange.read(out, filled);
    return filled;
}

}  // namespace wend
