#pragma once

namespace wend {

/// In single and in double precision, and CHOLMOD's: each serves where the one before it loses a pivot.
enum class FactorKind { Single, Double, Reference };

}  // namespace wend
