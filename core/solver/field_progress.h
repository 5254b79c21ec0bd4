#pragma once

#include <functional>

namespace wend {

/// The kinds of long work on one velocity field.
enum class FieldWork { Factor, Levels, Iterations };

/// Gets the fraction of such work that is done, in [0, 1], from any thread.
using FieldProgress = std::function<void(FieldWork work, double part)>;

}  // namespace wend
