#pragma once

#include <QString>
#include <optional>

#include "app/output/overwriting.h"
#include "app/project/edits/document.h"

namespace wend {

/// Returns whether a file that is written to `path` would replace one of the document's own, also by another
/// name of it; with #### in the path, one of the first `count` frames.
std::optional<OwnFile> ownFileAt(const Document& document, const QString& path, int count = 0);

/// Returns how many of these frames exist.
int existingFrames(const QString& pattern, int count);

}  // namespace wend
