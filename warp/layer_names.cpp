#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "warp/layered_file.h"

namespace wend {

void giveOwnNames(const std::vector<std::string*>& names, const std::string& mark) {
    std::set<std::string> taken;
    for (std::string* name : names) {
        if (name->empty()) *name = "layer";
        const std::string own = *name;
        for (int number = 2; !taken.insert(*name).second; ++number)
            *name =
                own + (mark.empty() ? " (" + std::to_string(number) + ")" : mark + std::to_string(number));
    }
}

std::size_t layerNamed(const std::vector<PictureLayer>& layers, const std::string& name) {
    const auto found = std::ranges::find(layers, name, &PictureLayer::name);
    if (found == layers.end()) throw InputError("has no layer \"" + name + '"');
    return static_cast<std::size_t>(found - layers.begin());
}

}  // namespace wend
