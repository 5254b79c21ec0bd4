#include "core/assembly/stage_vectors.h"

#include <cmath>
#include <vector>

namespace wend {
namespace {

template <int Dim>
class HostStages final : public StageVectors<Dim> {
  public:
    void begin(const Points<Dim>& y, int stages) override {
        m_y = y;
        m_slopes.resize(static_cast<std::size_t>(stages));
    }
    void setSlope(int stage, const Points<Dim>& k) override { m_slopes[static_cast<std::size_t>(stage)] = k; }

    Points<Dim> combined(double h, std::span<const double> a) override { return m_y + sum(h, a); }

    double greatestError(double h, std::span<const double> e) override {
        const Points<Dim> error = sum(h, e);
        double most = 0;
        for (Eigen::Index i = 0; i < error.cols(); ++i) {
            const double square = error.col(i).squaredNorm();
            if (square > most || std::isnan(square)) most = square;
        }
        return std::sqrt(most);
    }

  private:
    Points<Dim> sum(double h, std::span<const double> weights) const {
        Points<Dim> total = Points<Dim>::Zero(Dim, m_y.cols());
        for (std::size_t i = 0; i < weights.size(); ++i) total += (h * weights[i]) * m_slopes[i];
        return total;
    }

    Points<Dim> m_y;
    std::vector<Points<Dim>> m_slopes;
};

}  // namespace

template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeHostStages() {
    return std::make_unique<HostStages<Dim>>();
}

template std::unique_ptr<StageVectors<2>> makeHostStages<2>();
template std::unique_ptr<StageVectors<3>> makeHostStages<3>();

}  // namespace wend
