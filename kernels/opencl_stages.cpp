#include "kernels/opencl_stages.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/opencl_context.h"

namespace wend {
namespace {

constexpr int kChunk = 256;  // vertices per work item of the norm

template <int Dim>
class OpenClStages final : public StageVectors<Dim> {
  public:
    OpenClStages(const OpenClDeviceInfo& device, StageCopies* copied) : m_cl(device), m_copied(copied) {
        const cl::Program program = m_cl.build("stages.cl", "-cl-std=CL1.2 -DDIM=" + std::to_string(Dim));
        m_combine = cl::Kernel(program, "combine");
        m_greatest = cl::Kernel(program, "greatestError");
    }

    void begin(const Points<Dim>& y, int stages) override {
        counted([&] {
            reserve(static_cast<int>(y.cols()), stages);
            m_cl.write(m_y, y.data(), static_cast<std::size_t>(y.size()));
        });
    }

    void setSlope(int stage, const Points<Dim>& k) override {
        const auto size = static_cast<std::size_t>(k.size());
        counted([&] { m_cl.write(m_slopes, k.data(), size, size * static_cast<std::size_t>(stage)); });
    }

    Points<Dim> combined(double h, std::span<const double> a) override {
        Points<Dim> result(Dim, m_vertices);
        counted([&] {
            setWeights(h, a);
            launch(m_cl.queue(), m_combine, Dim * m_vertices, static_cast<int>(a.size()), m_y, m_slopes,
                   m_weights, m_target);
            m_cl.read(m_target, result.data(), static_cast<std::size_t>(result.size()));
        });
        return result;
    }

    double greatestError(double h, std::span<const double> e) override {
        std::vector<double> parts(static_cast<std::size_t>(chunks()));
        counted([&] {
            setWeights(h, e);
            launch(m_cl.queue(), m_greatest, chunks(), m_vertices, kChunk, static_cast<int>(e.size()),
                   m_slopes, m_weights, m_parts);
            m_cl.read(m_parts, parts.data(), parts.size());
        });
        double most = 0;
        for (double part : parts)
            if (part > most || std::isnan(part)) most = part;
        return std::sqrt(most);
    }

  private:
    int chunks() const { return (m_vertices + kChunk - 1) / kChunk; }

    template <typename Work>
    void counted(Work&& work) {
        guarded(work);
        if (m_copied) *m_copied = {m_cl.copied().toDevice, m_cl.copied().fromDevice};
    }

    void reserve(int vertices, int stages) {
        if (vertices == m_vertices && stages <= m_stages) return;
        m_vertices = vertices;
        m_stages = stages;
        const auto numbers = static_cast<std::size_t>(Dim) * static_cast<std::size_t>(vertices);
        m_y = m_cl.buffer<double>(numbers);
        m_target = m_cl.buffer<double>(numbers);
        m_slopes = m_cl.buffer<double>(numbers * static_cast<std::size_t>(stages));
        m_weights = m_cl.buffer<double>(static_cast<std::size_t>(stages));
        m_parts = m_cl.buffer<double>(static_cast<std::size_t>(chunks()));
    }

    void setWeights(double h, std::span<const double> of) {
        std::vector<double> weights;
        for (double weight : of) weights.push_back(h * weight);
        m_cl.write(m_weights, weights.data(), weights.size());
    }

    OpenClContext m_cl;
    StageCopies* m_copied;
    int m_vertices = 0, m_stages = 0;
    cl::Kernel m_combine, m_greatest;
    cl::Buffer m_y, m_target, m_slopes, m_weights, m_parts;
};

/// The host's copies cost less than asking the device for them when it has failed.
template <int Dim>
class FailsafeStages final : public StageVectors<Dim> {
  public:
    FailsafeStages(std::unique_ptr<StageVectors<Dim>> primary, DeviceNotice notice)
        : m_primary(std::move(primary)), m_notice(std::move(notice)), m_host(makeHostStages<Dim>()) {}

    void begin(const Points<Dim>& y, int stages) override {
        m_host->begin(y, stages);
        onDevice([&] { m_primary->begin(y, stages); });
    }
    void setSlope(int stage, const Points<Dim>& k) override {
        m_host->setSlope(stage, k);
        onDevice([&] { m_primary->setSlope(stage, k); });
    }
    Points<Dim> combined(double h, std::span<const double> a) override {
        Points<Dim> result;
        return onDevice([&] { result = m_primary->combined(h, a); }) ? result : m_host->combined(h, a);
    }
    double greatestError(double h, std::span<const double> e) override {
        double result = 0;
        return onDevice([&] { result = m_primary->greatestError(h, e); }) ? result
                                                                          : m_host->greatestError(h, e);
    }

  private:
    template <typename Work>
    bool onDevice(Work&& work) {
        if (!m_primary) return false;
        try {
            work();
            return true;
        } catch (const DeviceFailure& failure) {
            m_primary.reset();
            if (m_notice) m_notice(failureText("the device", failure));
            return false;
        }
    }

    std::unique_ptr<StageVectors<Dim>> m_primary;
    DeviceNotice m_notice;
    std::unique_ptr<StageVectors<Dim>> m_host;
};

}  // namespace

template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeOpenClStages(const OpenClDeviceInfo& device, StageCopies* copied) {
    return guarded([&] { return std::make_unique<OpenClStages<Dim>>(device, copied); });
}

template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeFailsafeStages(std::unique_ptr<StageVectors<Dim>> primary,
                                                      DeviceNotice notice) {
    return std::make_unique<FailsafeStages<Dim>>(std::move(primary), std::move(notice));
}

#define WEND_INSTANTIATE(Dim)                                                                               \
    template std::unique_ptr<StageVectors<Dim>> makeOpenClStages<Dim>(const OpenClDeviceInfo&,              \
                                                                      StageCopies*);                        \
    template std::unique_ptr<StageVectors<Dim>> makeFailsafeStages<Dim>(std::unique_ptr<StageVectors<Dim>>, \
                                                                        DeviceNotice);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
