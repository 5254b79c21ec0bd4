#pragma once

#include <algorithm>

#include "app/document/document.h"

namespace wend {

/// The energy of the whole shape, in the plane or in space.
inline double wholePhi(const Project& project) {
    return std::visit([](const auto& design) { return design.material.phi; }, project.design);
}

/// One undo step; what is chosen in one gesture is one, too.
inline void changeWholePhi(Document& document, double phi, int gesture) {
    if (document.isEmpty() || phi == wholePhi(*document.project())) return;
    Project next = *document.project();
    const double limit = phi::conformal(next.dimension());
    std::visit([&](auto& design) { design.material.phi = std::min(phi, limit); }, next.design);
    document.change(Document::tr("Change energy"), std::move(next), QStringLiteral("phi %1").arg(gesture));
}

}  // namespace wend
