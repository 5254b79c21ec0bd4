#pragma once

#include <memory>

#include "app/project/project_fwd.h"

namespace wend {

/// Returns a sample with translated names of pins and layers; the same project in English.
std::shared_ptr<const Project> withSpokenNames(const std::shared_ptr<const Project>& sample);

}  // namespace wend
