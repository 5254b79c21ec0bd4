#pragma once

#include <QByteArray>

#include "core/meshing/surface.h"

namespace wend {

/// The numbers of all that is wrong with a surface, as the text of a file; `numbers` are those of its
/// triangles.
QByteArray listOf(const SurfaceProblems& problems, const std::vector<int>& numbers);

}  // namespace wend
