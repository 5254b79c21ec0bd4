#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wend {

enum class FilmFormat { Mp4, Webm, Mov, Gif, Apng, Webp };

/// Properties of a film format.
struct FilmFormatFacts {
    FilmFormat id;
    std::string_view name;       // as the window lists it
    std::string_view extension;  // with the dot
    bool alpha;                  // without it, frames are placed on white
    bool even;                   // width and height must be even
    bool sound;
    double mostFramesPerSecond;
};

/// Returns all film formats in the order of the window's list.
std::span<const FilmFormatFacts> filmFormats();

/// Returns the format by the extension; null if it is none of a film.
const FilmFormatFacts* filmFormatOf(const std::string& path);

/// Throws InputError(path, reason) if the extension is none of a film or the program that encodes it is not
/// installed.
void requireFilmFormat(const std::string& path);

/// Returns the version of the installed ffmpeg, such as "5.1.9"; empty if there is none.
std::string ffmpegVersion();

}  // namespace wend
