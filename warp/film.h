#pragma once

#include <memory>
#include <string>

namespace wend {

class FilmEncoder;
class WarpedPicture;
struct Image;

/// Pictures of one size as a film in one file, an animated WebP: 8 bits deep with alpha, shown for
/// equal times, again and again. In memory are its frames as they will be in the file.
class Film {
  public:
    /// `path`: the name for messages. Throws InputError for a rate that the format does not support.
    Film(const std::string& path, double framesPerSecond, bool lossy);
    ~Film();

    /// Throws InputError, and Cancelled when the picture's painting is stopped.
    void add(const WarpedPicture& picture);
    void add(const Image& frame);
    /// Throws InputError.
    void write(const std::string& file);

  private:
    std::unique_ptr<FilmEncoder> m_encoder;
};

}  // namespace wend
