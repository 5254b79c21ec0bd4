#include "warp/film.h"

#include "core/mesh/error.h"
#include "warp/convert.h"
#include "warp/picture_library.h"
#include "warp/warped_picture.h"

namespace wend {

Film::Film(const std::string& path, double framesPerSecond, bool lossy)
    : m_encoder(pictureLibrary(path).film({path, framesPerSecond, lossy})) {}

Film::~Film() = default;

void Film::add(const WarpedPicture& picture) {
    Image frame = picture.header();
    frame.makePixels();
    if (!picture.paint(0, frame)) throw Cancelled();
    add(frame);
}

void Film::add(const Image& frame) {
    m_encoder->add(converted(frame, {PixelType::UInt8, 4, true, true}));
}

void Film::write(const std::string& file) {
    m_encoder->write(file);
}

}  // namespace wend
