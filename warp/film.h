#pragma once

#include <memory>
#include <stop_token>
#include <string>

namespace wend {

class FilmEncoder;
class WarpedPicture;
struct Image;

/// Sound of a film, from an audio or film file.
struct FilmSound {
    std::string file = {};  // empty: no sound
    double from = 0;        // seconds of the file that come before the film
};

struct FilmOptions {
    double framesPerSecond = 24;
    bool lossy = false;  // of WebP
    int frames = 0;      // number that will be added: the sound ends with them
    FilmSound sound = {};
    std::stop_token stop = {};  // add() and finish() throw Cancelled then
};

/// Pictures of one size, 8 bits deep, as a film in one file, by its extension (film_format.h). A film that
/// repeats itself in the program that shows it does so for ever.
class Film {
  public:
    /// `path`: the name for messages. `file`: the file that is written, of the same extension. Throws
    /// InputError.
    Film(const std::string& path, const std::string& file, const FilmOptions& options);
    ~Film();

    /// Throws InputError, and Cancelled when the picture's painting is stopped.
    void add(const WarpedPicture& picture);
    void add(const Image& frame);
    /// Completes the file. Throws InputError.
    void finish();

  private:
    std::unique_ptr<FilmEncoder> m_encoder;
    bool m_alpha;
};

}  // namespace wend
