#pragma once

namespace wend {

/// The kinds of factor: in single precision, in double precision, and CHOLMOD's. Each replaces the one before
/// it where that loses a pivot. Their order counts: a later kind is more reliable and takes more time and, by
/// Single, twice the memory. Single and Double are SupernodalFactor's, Reference is Cholesky's.
enum class FactorKind { Single, Double, Reference };

}  // namespace wend
