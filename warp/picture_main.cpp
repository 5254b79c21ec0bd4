// wend-picture: reads pictures for the program, one after the other (picture_protocol.h). A program of its
// own because the libraries that read pictures may crash, hang, exit or take all memory over a damaged file.

#include <unistd.h>

#include <new>
#include <string>

#include "core/base/child_link.h"
#include "core/base/child_parts.h"
#include "core/base/error.h"
#include "core/base/helper_program.h"
#include "warp/picture_protocol.h"
#include "warp/picture_source.h"

namespace wend {
namespace {

constexpr double kSeconds = 60, kSecondsPerMegapixel = 2;  // of computing

/// Sends the pixels by shared memory.
class SharedPixels final : public PixelSink {
  public:
    explicit SharedPixels(int socket) : m_socket(socket) {}

    std::byte* begin(const Image& header, int rows) override {
        allowTime(kSeconds + kSecondsPerMegapixel * 1e-6 * header.width * header.height);
        const PictureMessage layout = messageOf(StoredPicture{header, 1, {}});
        return m_memory.attach(std::stoi(confirmed({{"layout", layout}, {"rows", rows}})));
    }
    void take(int rows) override { confirmed({{"taken", rows}}); }

  private:
    /// Sends a message, and returns how it was confirmed. Ends the process if it was not.
    std::string confirmed(const PictureMessage& message) const {
        std::string answer;
        if (!sendMessage(m_socket, pack(message)) || !receiveMessage(m_socket, answer)) _exit(1);
        return answer;
    }

    int m_socket;
    SharedMemory m_memory;
};

StoredPicture read(const PictureMessage& request, const PictureSource& source,
                   const std::vector<Message>& notices, PixelSink& sink) {
    const PictureLibrary& library = pictureLibrary(source.path);
    StoredPicture stored = request.contains("megapixels")
                               ? library.read(source, request.at("megapixels"), sink)
                               : library.readHeader(source);
    stored.notices.insert(stored.notices.begin(), notices.begin(), notices.end());
    return stored;
}

PictureMessage answerTo(const PictureMessage& request, PixelSink& sink) {
    bool isSound = true;  // no library has seen the file
    try {
        std::vector<Message> notices;
        const std::string layer = request.value("layer", "");
        const DrawnSize size = request.value("drawn", DrawnSize{});
        if (request.contains("vectors"))
            return {{"vectors", messageOf(vectorSourceOf(request.at("path"), layer, size))}};
        const PictureSource source = request.contains("layer")
                                         ? layerSourceOf(request.at("path"), layer, size, notices)
                                         : sourceOf(request.at("path"), size, notices);
        isSound = false;
        return {{"picture", messageOf(read(request, source, notices, sink))}};
    } catch (const InputError& error) {
        return {{"wrong", binaryOf(error.message())}, {"isSound", isSound}};
    } catch (const std::bad_alloc&) {
        return {{"memory", true}};
    }
}

}  // namespace
}  // namespace wend

int main(int argc, char** argv) {
    const int socket = wend::beginLinkedHelper(argc, argv);
    wend::SharedPixels sink(socket);
    for (std::string request; wend::receiveMessage(socket, request);) {
        wend::allowTime(wend::kSeconds);
        if (!wend::sendMessage(socket, wend::pack(wend::answerTo(wend::unpackMessage(request), sink))))
            return 1;
    }
    return 0;
}
