#include "warp/film_format.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/fed_process.h"
#include "core/base/file_name.h"

namespace wend {
namespace {

// Programs show a GIF of more than 50 frames per second slowly.
constexpr std::array kFormats{
    FilmFormatFacts{FilmFormat::Mp4, "MP4", ".mp4", false, true, true, 1000},
    FilmFormatFacts{FilmFormat::Webm, "WebM", ".webm", true, true, true, 1000},
    FilmFormatFacts{FilmFormat::Mov, "QuickTime ProRes", ".mov", true, true, true, 1000},
    FilmFormatFacts{FilmFormat::Gif, "GIF", ".gif", true, false, false, 50},
    FilmFormatFacts{FilmFormat::Apng, "Animated PNG", ".png", true, false, false, 1000},
    FilmFormatFacts{FilmFormat::Webp, "Animated WebP", ".webp", true, false, false, 1000},
};

std::string knownExtensions() {
    std::string all;
    for (const FilmFormatFacts& format : kFormats)
        all += (all.empty() ? "" : ", ") + std::string(format.extension.substr(1));
    return all;
}

}  // namespace

std::span<const FilmFormatFacts> filmFormats() {
    return kFormats;
}

const FilmFormatFacts* filmFormatOf(const std::string& path) {
    std::string extension = lowerExtension(path);
    if (extension == ".apng") extension = ".png";
    const auto found = std::ranges::find(kFormats, extension, &FilmFormatFacts::extension);
    return found == kFormats.end() ? nullptr : &*found;
}

void requireFilmFormat(const std::string& path) {
    const FilmFormatFacts* format = filmFormatOf(path);
    if (!format) {
        const std::string extension = lowerExtension(path);
        throw InputError(path, (extension.empty() ? "has no extension that says the film format"
                                                  : "films cannot be written as " + extension) +
                                   " (known: " + knownExtensions() + ")");
    }
    if (format->id != FilmFormat::Webp && programInPath("ffmpeg").empty())
        throw InputError(path,
                         "films of this format are made by the program ffmpeg, which is not installed "
                         "(Debian: sudo apt install ffmpeg); a .webp needs no other program");
}

std::string ffmpegVersion() {
    const std::string program = programInPath("ffmpeg");
    if (program.empty()) return {};
    FedProcess process(program, {"-version"});
    process.finish();
    constexpr std::string_view kBefore = "ffmpeg version ";
    const std::string& text = process.output();
    if (!text.starts_with(kBefore)) return {};
    return text.substr(kBefore.size(), text.find_first_of(" \n", kBefore.size()) - kBefore.size());
}

}  // namespace wend
