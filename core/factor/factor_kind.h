#pragma once

namespace wend {

/// The kinds of factor: in single precision, in double precision, and CHOLMOD's. Each replaces the one before
/// it where that loses a pivot.
enum class FactorKind { Single, Double, Reference };

}  // namespace wend
