#pragma once

#include <memory>

#include "core/base/types.h"

namespace wend {

/// Applies Wᵀ (W Wᵀ)⁻¹ of a matrix W of independent rows. It is cheap to copy.
class RightInverse {
  public:
    /// Factorizes W Wᵀ. W has a row for each constraint, and no more rows than columns.
    explicit RightInverse(const Eigen::MatrixXd& W);
    /// Returns Wᵀ (W Wᵀ)⁻¹ times a matrix.
    Eigen::MatrixXd times(const Eigen::MatrixXd& right) const;

  private:
    struct Factor;
    std::shared_ptr<const Factor> m_factor;
};

}  // namespace wend
