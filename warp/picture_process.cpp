#include "warp/picture_process.h"

#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>

#include "core/base/address_room.h"
#include "core/base/child_link.h"
#include "core/base/child_parts.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/number_text.h"
#include "warp/picture_protocol.h"

namespace wend {
namespace {

constexpr int kMegabytes = 8192;                           // address space
constexpr std::uint64_t kRoom = std::uint64_t(736) << 20;  // for the libraries, measured, and a picture

/// A process that is started and has nothing to do, if there is one.
class IdleReader {
  public:
    std::unique_ptr<ChildLink> take() {
        const std::lock_guard lock(m_mutex);
        return std::move(m_idle);
    }
    void giveBack(std::unique_ptr<ChildLink> reader) {
        const std::lock_guard lock(m_mutex);
        if (!m_idle) m_idle = std::move(reader);
    }

  private:
    std::mutex m_mutex;
    std::unique_ptr<ChildLink> m_idle;
};

IdleReader& idleReader() {
    static IdleReader reader;
    return reader;
}

/// Throws if there is too little room. Under a limit (ulimit -v) libraries end the process while they are
/// loaded.
void requireRoom(const std::string& path) {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < kRoom)
        throw OutOfMemory(path,
                          "there is not enough memory for what reads pictures: 736 MB are needed (see ulimit "
                          "-v)");
}

/// Reads one picture.
class Reading {
  public:
    Reading(std::string path, std::string layer, const PictureLimits& limits)
        : m_path(std::move(path)),
          m_layer(std::move(layer)),
          m_absolute(std::filesystem::absolute(m_path).string()),
          m_limits(limits),
          m_reader(idleReader().take()) {
        if (m_reader) return;
        requireRoom(m_path);
        m_reader = std::make_unique<ChildLink>(siblingProgram("wend-picture"), kMegabytes);
    }

    StoredPicture read(bool pixels) try {
        PictureMessage request{{"path", m_absolute}};
        if (!m_layer.empty()) request["layer"] = m_layer;
        if (m_limits.drawn[0] > 0) request["drawn"] = m_limits.drawn;
        if (pixels) request["megapixels"] = m_limits.megapixels;
        if (!m_reader->send(pack(request))) fail();
        for (;;) {
            const PictureMessage answer = next();
            if (answer.contains("layout")) begin(answer);
            if (answer.contains("taken")) take(answer.at("taken"));
            if (answer.contains("picture")) return finish(answer.at("picture"));
        }
    } catch (const PictureMessage::exception&) {
        failWith("its reader failed");
    }

    VectorDrawing readVectors() try {
        const PictureMessage request{
            {"path", m_absolute}, {"layer", m_layer}, {"drawn", m_limits.drawn}, {"vectors", true}};
        if (!m_reader->send(pack(request))) fail();
        VectorDrawing drawing = drawingOf(next().at("vectors"));
        idleReader().giveBack(std::move(m_reader));
        return drawing;
    } catch (const PictureMessage::exception&) {
        failWith("its reader failed");
    }

  private:
    PictureMessage next() {
        std::string bytes;
        if (!m_reader->receive(bytes, m_limits.idleSeconds, requireReading)) fail();
        PictureMessage answer = unpackMessage(bytes);
        if (answer.contains("wrong")) {
            if (answer.at("isSound")) idleReader().giveBack(std::move(m_reader));
            throw InputError(m_path, properlyNamed(textOf(answer.at("wrong"))));
        }
        if (answer.contains("memory")) failForMemory();
        return answer;
    }
    /// Returns `text` with the file named as the caller names it.
    Message properlyNamed(const Message& text) const {
        return withTexts(text, [this](std::string part) {
            const auto at = part.find(m_absolute);
            return at == std::string::npos ? part : part.replace(at, m_absolute.size(), m_path);
        });
    }
    void confirm(const std::string& answer = {}) {
        if (!m_reader->send(answer)) fail();
    }

    void begin(const PictureMessage& answer) {
        m_image = pictureOf(answer.at("layout")).image;
        const int rows = answer.at("rows");
        if (rows < 1) failWith("its reader failed");
        m_strip = m_image.rowBytes() * static_cast<std::size_t>(rows);
        m_shared = m_memory.make(m_strip);
        m_image.reservePixels();
        confirm(std::to_string(m_memory.id()));
    }

    void take(int rows) {
        const std::size_t bytes = m_image.rowBytes() * static_cast<std::size_t>(std::max(rows, 0));
        const std::size_t all = m_image.rowBytes() * static_cast<std::size_t>(m_image.height);
        if (bytes > m_strip || bytes > all - m_image.data.size()) failWith("its reader failed");
        m_image.data.insert(m_image.data.end(), m_shared, m_shared + bytes);
        confirm();
    }

    StoredPicture finish(const PictureMessage& answer) {
        StoredPicture stored = pictureOf(answer);
        stored.image.data = std::move(m_image.data);
        idleReader().giveBack(std::move(m_reader));
        return stored;
    }

    [[noreturn]] void failWith(const Message& why) const {
        throw InputError(m_path, {sentence("Core", "cannot be read: %1"), why});
    }
    [[noreturn]] void failForMemory() const {
        if (limitsAddresses()) throw OutOfMemory(m_path);
        failWith(
            {sentence("Core", "it needs more than the %1 MB of memory that reading may take"), kMegabytes});
    }

    /// Throws the reason why the reader has ended.
    [[noreturn]] void fail() const {
        using End = ChildResult::End;
        const ChildResult result = m_reader->end();
        if (result.end == End::NotStarted) failWith("wend-picture is missing beside the program");
        if (result.end == End::TimedOut) failWith(sentence("Core", "its reader has not come to an end"));
        if (result.end == End::Idle)
            failWith(
                {sentence("Core", "its reader has done nothing for %1 s"), numberText(m_limits.idleSeconds)});
        if (limitsAddresses()) throw OutOfMemory(m_path);
        if (result.end == End::Exited)
            failWith({sentence("Core", "its reader failed (exit code %1)"), result.code});
        // These signals come from outside: the file is not the cause.
        const bool isFromOutside = result.code == SIGKILL || result.code == SIGTERM;
        failWith({isFromOutside ? sentence("Core", "its reader was ended (signal %1)")
                                : sentence("Core", "its reader failed inside (signal %1)"),
                  result.code});
    }

    std::string m_path, m_layer, m_absolute;
    PictureLimits m_limits;
    std::unique_ptr<ChildLink> m_reader;
    Image m_image;
    SharedMemory m_memory;
    std::byte* m_shared = nullptr;
    std::size_t m_strip = 0;  // bytes that are shared
};

}  // namespace

StoredPicture readPicture(const std::string& path, const PictureLimits& limits, const std::string& layer) {
    pictureFormat(InputFile(path));  // other files need no process
    return Reading(path, layer, limits).read(true);
}

StoredPicture readPictureHeader(const std::string& path, const DrawnSize& drawn) {
    pictureFormat(InputFile(path));
    return Reading(path, {}, {.drawn = drawn}).read(false);
}

VectorDrawing readVectors(const std::string& path, const std::string& layer, const DrawnSize& drawn) {
    pictureFormat(InputFile(path));
    return Reading(path, layer, {.drawn = drawn}).readVectors();
}

}  // namespace wend
