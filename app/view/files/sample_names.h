#pragma once

#include <memory>

#include "app/document/project_fwd.h"

namespace wend {

/// A sample whose pins and layers are named in the language of the window. The same project where that is
/// English.
std::shared_ptr<const Project> withSpokenNames(const std::shared_ptr<const Project>& sample);

}  // namespace wend
