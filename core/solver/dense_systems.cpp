#include "core/solver/dense_systems.h"

#include <Eigen/Cholesky>

namespace wend {

struct RightInverse::Factor {
    Eigen::MatrixXd W;
    Eigen::LDLT<Eigen::MatrixXd> WWt;
};

RightInverse::RightInverse(const Eigen::MatrixXd& W)
    : m_factor(std::make_shared<const Factor>(Factor{W, Eigen::LDLT<Eigen::MatrixXd>(W * W.transpose())})) {}

Eigen::MatrixXd RightInverse::times(const Eigen::MatrixXd& right) const {
    return m_factor->W.transpose() * m_factor->WWt.solve(right);
}

}  // namespace wend
