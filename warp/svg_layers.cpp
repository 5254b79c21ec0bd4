#include "warp/svg_layers.h"

#include <dlfcn.h>

#include "core/mesh/child_process.h"
#include "core/mesh/error.h"

namespace wend {
namespace {

const SvgLibrary& svgLibrary() {
    static const SvgLibrary* const library = [] {
        void* module = dlopen(siblingProgram("wend-svg.so").c_str(), RTLD_LAZY | RTLD_LOCAL);
        void* entry = module ? dlsym(module, "wendSvgLibrary") : nullptr;
        if (!entry) throw InputError(std::string("what draws SVG files is missing: ") + dlerror());
        return reinterpret_cast<const SvgLibrary* (*)()>(entry)();
    }();
    return *library;
}

}  // namespace

DrawnSvg drawnSvg(const std::string& path, const std::string& svg, const std::string& layer) try {
    return svgLibrary().draw(svg, layer);
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
