#include "warp/picture_library.h"

#include <dlfcn.h>

#include <cstddef>
#include <cstdlib>

#include "core/base/address_room.h"
#include "core/base/child_process.h"
#include "core/base/error.h"

namespace wend {
namespace {

constexpr std::size_t kRoom = std::size_t(736) << 20;  // for these libraries, measured, and a picture

const PictureLibrary& loaded(const std::string& path) {
    if (!hasAddressRoom(kRoom))
        throw OutOfMemory(path,
                          "there is not enough memory for what reads and writes pictures: 736 MB more are "
                          "needed (see ulimit -v)");
    // Lazy binding: these libraries load dozens of others, and binding all functions takes most of a short
    // run.
    void* module = dlopen(siblingProgram("wend-pictures.so").c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* entry = module ? dlsym(module, "wendPictureLibrary") : nullptr;
    if (!entry)
        throw InputError(path, std::string("what reads and writes pictures is missing: ") + dlerror());
    using Library = const PictureLibrary* (*)();
    return *reinterpret_cast<Library>(entry)();
}

}  // namespace

const PictureLibrary& pictureLibrary(const std::string& path) {
    static const PictureLibrary& library = loaded(path);
    return library;
}

std::jthread loadPictureLibrary() {
    if (limitsAddresses()) return {};
    return std::jthread([] {
        try {
            pictureLibrary({});
        } catch (const std::exception&) {
            // Every later use fails in the same manner.
        }
    });
}

void lookForNoPlugins() try {
    if (std::getenv("OIIO_LIBRARY_PATH") || std::getenv("LD_LIBRARY_PATH")) pictureLibrary({});
} catch (const std::exception&) {
    // The first picture says why.
}

}  // namespace wend
