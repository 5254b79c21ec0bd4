#include "warp/svg_layers.h"

#include <dlfcn.h>

#include "core/base/child_process.h"
#include "core/base/error.h"

namespace wend {

const SvgLibrary& svgLibrary() {
    static const SvgLibrary* const library = [] {
        void* module = dlopen(siblingProgram("wend-svg.so").c_str(), RTLD_LAZY | RTLD_LOCAL);
        void* entry = module ? dlsym(module, "wendSvgLibrary") : nullptr;
        if (!entry) throw InputError(std::string("what draws SVG files is missing: ") + dlerror());
        return reinterpret_cast<const SvgLibrary* (*)()>(entry)();
    }();
    return *library;
}

}  // namespace wend
