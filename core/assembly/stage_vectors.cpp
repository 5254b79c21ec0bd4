#include "core/assembly/stage_vectors.h"

#include <cmath>

namespace wend {
namespace {

template <int Dim>
class HostStages final : public StageVectors<Dim> {
    using typename StageVectors<Dim>::Terms;

  public:
    void combine(const Nodal<Dim>& y, Terms terms) override { m_shape = terms.empty() ? y : sum(*y, terms); }
    Nodal<Dim> shape() override { return m_shape; }

    double distance(const Nodal<Dim>& other) override { return (*m_shape - *other).cwiseAbs().maxCoeff(); }

    double maximum(Terms terms) override {
        if (terms.empty()) return 0;
        const auto& first = *terms.front().field;
        const Nodal<Dim> total = sum(Points<Dim>::Zero(Dim, first.cols()), terms);
        double most = 0;
        for (Eigen::Index i = 0; i < total->cols(); ++i) {
            const double square = total->col(i).squaredNorm();
            if (square > most || std::isnan(square)) most = square;
            if (std::isnan(most)) break;
        }
        return std::sqrt(most);
    }

  private:
    static Nodal<Dim> sum(const Points<Dim>& y, Terms terms) {
        auto total = std::make_shared<Points<Dim>>(y);
        for (const auto& [weight, field] : terms) *total += weight * *field;
        return total;
    }

    Nodal<Dim> m_shape;
};

}  // namespace

template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeHostStages() {
    return std::make_unique<HostStages<Dim>>();
}

template std::unique_ptr<StageVectors<2>> makeHostStages<2>();
template std::unique_ptr<StageVectors<3>> makeHostStages<3>();

}  // namespace wend
