#include "warp/ffmpeg_film.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <sstream>

#include "core/base/error.h"
#include "core/base/fed_process.h"
#include "core/base/input_file.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/printable.h"

namespace wend {
namespace {

using Words = std::vector<std::string>;

/// Returns the file's name with ffmpeg's prefix for files, so that no name is taken for a URL or an option.
std::string fileWord(const std::string& path) {
    return "file:" + std::filesystem::absolute(path).string();
}

void append(Words& words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
}

/// The colours' numbers become those of BT.709, and the file says so: without, players guess by the size.
const std::string kToVideo =
    "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int";
const Words kVideoColours{"-colorspace", "bt709", "-color_primaries", "bt709",
                          "-color_trc",  "bt709", "-color_range",     "tv"};

Words videoWords(FilmFormat format, const std::string& crop) {
    switch (format) {
        case FilmFormat::Mp4: {
            Words words{"-vf",       crop + kToVideo + ",format=yuv420p",
                        "-c:v",      "libx264",
                        "-preset",   "medium",
                        "-crf",      "17",
                        "-movflags", "+faststart",
                        "-f",        "mp4"};
            append(words, kVideoColours);
            return words;
        }
        case FilmFormat::Webm: {
            Words words{"-vf",
                        crop + kToVideo + ",format=yuva420p",
                        "-c:v",
                        "libvpx-vp9",
                        "-crf",
                        "20",
                        "-b:v",
                        "0",
                        "-deadline",
                        "good",
                        "-cpu-used",
                        "3",
                        "-row-mt",
                        "1",
                        "-auto-alt-ref",
                        "0",
                        "-f",
                        "webm"};
            append(words, kVideoColours);
            return words;
        }
        case FilmFormat::Mov: {
            Words words{"-vf",         crop + kToVideo + ",format=yuva444p10le",
                        "-c:v",        "prores_ks",
                        "-profile:v",  "4444",
                        "-alpha_bits", "16",
                        "-vendor",     "apl0",
                        "-f",          "mov"};
            append(words, kVideoColours);
            return words;
        }
        case FilmFormat::Gif:
            return {"-filter_complex",
                    "[0:v]split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=alpha_threshold=128",
                    "-c:v",
                    "gif",
                    "-loop",
                    "0",
                    "-f",
                    "gif"};
        case FilmFormat::Apng:
        case FilmFormat::Webp:
            break;
    }
    return {"-c:v", "apng", "-pred", "mixed", "-plays", "0", "-f", "apng"};
}

Words soundCodec(FilmFormat format) {
    if (format == FilmFormat::Webm) return {"-c:a", "libopus", "-b:a", "160k"};
    if (format == FilmFormat::Mov) return {"-c:a", "pcm_s16le"};
    return {"-c:a", "aac", "-b:a", "192k"};
}

/// Returns the first line of ffmpeg's output, without the address of the component that printed it.
std::string reasonIn(const std::string& output) {
    std::istringstream lines(output);
    std::string line;
    while (std::getline(lines, line) && line.empty()) continue;
    if (line.starts_with("[")) line.erase(0, std::min(line.find("] ") + 2, line.size()));
    return line.empty() ? "it ended without a word" : printable(line);
}

class FfmpegFilm final : public FilmEncoder {
  public:
    FfmpegFilm(FilmToWrite writing, const FilmFormatFacts& format)
        : m_writing(std::move(writing)), m_format(format) {
        const double rate = m_writing.options.framesPerSecond;
        if (rate > m_format.mostFramesPerSecond || rate < kLeastRate)
            fail(std::string(m_format.extension.substr(1)) + " films have from " + numberText(kLeastRate) +
                 " to " + numberText(m_format.mostFramesPerSecond) + " frames per second");
        if (hasSound()) InputFile(m_writing.options.sound.file);  // throws if it cannot be read
    }

    void add(const Image& frame) override {
        if (!m_process) begin(frame);
        const std::span bytes(frame.data);
        if (!m_process->feed({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()},
                             m_writing.options.stop))
            failAsFfmpeg();
    }

    void finish() override {
        if (!m_process) fail("it has no frames");
        if (!m_process->finish(m_writing.options.stop)) failAsFfmpeg();
        m_process.reset();
    }

  private:
    static constexpr double kLeastRate = 0.01;

    bool hasSound() const { return m_format.sound && !m_writing.options.sound.file.empty(); }

    /// Returns the filter that crops an odd last column or row where the format needs even sizes; empty if
    /// nothing is cropped.
    std::string cropOf(const Image& frame) const {
        const int width = frame.width / 2 * 2, height = frame.height / 2 * 2;
        if (!m_format.even || (width == frame.width && height == frame.height)) return {};
        if (width == 0 || height == 0) fail("a film has at least 2 pixels a side");
        return "crop=" + std::to_string(width) + ":" + std::to_string(height) + ":0:0:exact=1,";
    }

    void begin(const Image& frame) {
        // The palette of all frames is known when all are there.
        if (m_format.id == FilmFormat::Gif) requireMemoryFor(frame);
        const FilmOptions& options = m_writing.options;
        const std::string rate = numberText(options.framesPerSecond);
        Words words{"-hide_banner", "-nostdin",
                    "-loglevel",    "error",
                    "-xerror",      "-y",
                    "-f",           "rawvideo",
                    "-pix_fmt",     frame.channels == 4 ? "rgba" : "rgb24",
                    "-video_size",  std::to_string(frame.width) + "x" + std::to_string(frame.height),
                    "-framerate",   rate,
                    "-i",           "pipe:0"};
        if (hasSound()) append(words, soundInput());
        append(words, videoWords(m_format.id, cropOf(frame)));
        if (hasSound()) append(words, soundCodec(m_format.id));
        append(words, {"-fflags", "+bitexact", "-flags", "+bitexact", fileWord(m_writing.file)});
        m_process.emplace(programInPath("ffmpeg"), words);
    }

    Words soundInput() const {
        const FilmOptions& options = m_writing.options;
        return {"-ss",  numberText(options.sound.from),
                "-t",   numberText(options.frames / options.framesPerSecond),
                "-i",   fileWord(options.sound.file),
                "-map", "0:v",
                "-map", "1:a:0"};
    }

    void requireMemoryFor(const Image& frame) const {
        try {
            requireMemory(static_cast<double>(frame.data.size()) * m_writing.options.frames);
        } catch (const NotEnoughMemory& error) {
            throw OutOfMemory(m_writing.path, std::string(error.what()) +
                                                  ": take a smaller picture, fewer frames or another format");
        }
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw InputError(m_writing.path, "cannot be written: " + why);
    }

    [[noreturn]] void failAsFfmpeg() {
        m_process->finish();
        std::string reason = reasonIn(m_process->output());
        const std::string file = fileWord(m_writing.file);
        if (const auto at = reason.find(file); at != std::string::npos)
            reason.replace(at, file.size(), m_writing.path);
        fail("ffmpeg failed (" + reason + ")");
    }

    FilmToWrite m_writing;
    const FilmFormatFacts& m_format;
    std::optional<FedProcess> m_process;
};

}  // namespace

std::unique_ptr<FilmEncoder> makeFfmpegFilm(const FilmToWrite& writing, const FilmFormatFacts& format) {
    return std::make_unique<FfmpegFilm>(writing, format);
}

}  // namespace wend
