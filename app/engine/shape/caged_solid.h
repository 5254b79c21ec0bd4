#pragma once

#include "app/engine/shape/solid.h"

namespace wend {

/// A cage of even cells that a surface is embedded in; `why` says why it was chosen by itself, and is empty
/// if it was asked for. Throws InputError, Cancelled.
Shape<3> cagedSolid(const Domain& domain, const std::shared_ptr<const Skin>& skin, const Message& why,
                    std::stop_token stop, Advice advice);

/// Returns why the exact surface is not even tried: it has more than eight times the vertices that are aimed
/// at. Empty otherwise, and where handles name its vertices by number.
Message tooManyVertices(const Domain& domain, const Design& design, const Skin& skin);

/// Flat surfaces open as 2D meshes; a cage is built only on request.
bool liesInAPlane(const Skin& skin);

/// Returns whether there is a surface to build a cage around.
bool canBeCaged(const Skin& skin);

}  // namespace wend
