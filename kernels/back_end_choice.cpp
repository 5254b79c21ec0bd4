#include "kernels/back_end_choice.h"

#include <memory>
#include <optional>
#include <utility>

#include "core/assembly/cpu_back_end.h"
#include "core/mesh/error.h"
#include "kernels/opencl_back_end.h"
#include "kernels/opencl_distortion.h"
#include "kernels/opencl_warp.h"

namespace wend {
namespace {

/// Below this number of unknowns a launch and its copies cost a GPU more than the work: not worth asking for
/// one.
constexpr int kWorthADevice = 20000;

template <int Dim>
class FailsafeBackEnd final : public BackEnd<Dim> {
  public:
    FailsafeBackEnd(std::unique_ptr<BackEnd<Dim>> primary,
                    std::function<std::unique_ptr<BackEnd<Dim>>()> makeFallback, DeviceNotice notice)
        : m_active(std::move(primary)),
          m_makeFallback(std::move(makeFallback)),
          m_notice(std::move(notice)) {}

    std::string name() const override { return m_active->name(); }
    std::string device() const override { return m_active->device(); }

    void setInertia(std::vector<double> epsilon) override {
        m_inertia = epsilon;
        safely([&] { m_active->setInertia(epsilon); });
    }
    int setShape(const Points<Dim>& shape) override {
        m_shape = shape;
        return safely([&] { return m_active->setShape(shape); });
    }
    void assemble(std::span<double> values) override {
        safely([&] { m_active->assemble(values); });
    }
    void apply(const Points<Dim>& v, Points<Dim>& Av) override {
        safely([&] { m_active->apply(v, Av); });
    }
    double energy(const Points<Dim>& v) override {
        return safely([&] { return m_active->energy(v); });
    }

  private:
    template <typename Work>
    auto safely(Work&& work) {
        if (!m_makeFallback) return work();
        try {
            return work();
        } catch (const DeviceFailure& failure) {
            replace(failure.what());
            return work();
        }
    }

    void replace(const std::string& why) {
        const std::string device = m_active->device();
        m_active = std::exchange(m_makeFallback, nullptr)();
        m_active->setInertia(m_inertia);
        if (m_shape.cols() > 0) m_active->setShape(m_shape);
        if (m_notice) m_notice(failureText(device, DeviceFailure(why)));
    }

    std::unique_ptr<BackEnd<Dim>> m_active;
    std::function<std::unique_ptr<BackEnd<Dim>>()> m_makeFallback;
    DeviceNotice m_notice;
    std::vector<double> m_inertia;
    Points<Dim> m_shape;
};

std::optional<OpenClDeviceInfo> deviceFor(BackEndKind kind, const std::string& name, int unknowns) {
    if (kind == BackEndKind::Cpu || (kind == BackEndKind::Automatic && unknowns < kWorthADevice)) return {};
    std::string why;
    const auto info = chooseOpenClDevice(name, why);
    if (kind == BackEndKind::OpenCl && !info) throw InputError("the OpenCL back end cannot be used: " + why);
    if (kind == BackEndKind::Automatic && info && info->type != "GPU" && name.empty()) return {};
    return info;
}

}  // namespace

template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeFailsafe(std::unique_ptr<BackEnd<Dim>> primary,
                                           std::function<std::unique_ptr<BackEnd<Dim>>()> makeFallback,
                                           DeviceNotice notice) {
    return std::make_unique<FailsafeBackEnd<Dim>>(std::move(primary), std::move(makeFallback),
                                                  std::move(notice));
}

template <int Dim>
BackEndFactory<Dim> backEndFactory(BackEndKind kind, const std::string& device, DeviceNotice notice) {
    return [=](std::shared_ptr<const AssemblyPlan<Dim>> plan, const SimplicialMesh<Dim>& rest,
               const Material<Dim>& material, int threads) -> std::unique_ptr<BackEnd<Dim>> {
        const auto info = deviceFor(kind, device, Dim * rest.vertexCount());
        const auto makeCpu = [plan, rest, material, threads] {
            return makeCpuBackEnd<Dim>(plan, rest, material, threads);
        };
        if (!info) return makeCpu();
        try {
            return makeFailsafe<Dim>(makeOpenClBackEnd<Dim>(*info, plan, rest, material), makeCpu, notice);
        } catch (const DeviceFailure& failure) {
            if (kind == BackEndKind::OpenCl)
                throw InputError("the OpenCL back end cannot be used: " + std::string(failure.what()));
            if (notice) notice(failureText(info->name, failure));
            return makeCpu();
        }
    };
}

template <int Dim>
DistortionOf<Dim> distortionOf(BackEndKind kind, const SimplicialMesh<Dim>& rest, const std::string& device,
                               DeviceNotice notice) {
    const auto onProcessor = [&rest](const Points<Dim>& pose) { return distortion(rest, pose); };
    const auto info = kind == BackEndKind::OpenCl ? deviceFor(kind, device, 0) : std::nullopt;
    if (!info) return onProcessor;
    return [onProcessor, &rest, notice, info = *info,
            onDevice = std::shared_ptr<OpenClDistortion<Dim>>()](const Points<Dim>& pose) mutable {
        try {
            if (!onDevice) onDevice = std::make_shared<OpenClDistortion<Dim>>(info, rest);
            return onDevice->of(pose);
        } catch (const DeviceFailure& failure) {
            if (notice) notice(failureText(info.name, failure));
            return onProcessor(pose);
        }
    };
}

MakeCellPainter cellPainters(BackEndKind kind, const std::string& device, DeviceNotice notice) {
    if (kind != BackEndKind::OpenCl) return {};
    const auto info = deviceFor(kind, device, 0);
    return [notice, info = *info](const WarpJob& job) { return makeOpenClPainter(info, job, notice); };
}

#define WEND_INSTANTIATE(Dim)                                                                        \
    template BackEndFactory<Dim> backEndFactory<Dim>(BackEndKind, const std::string&, DeviceNotice); \
    template DistortionOf<Dim> distortionOf<Dim>(BackEndKind, const SimplicialMesh<Dim>&,            \
                                                 const std::string&, DeviceNotice);                  \
    template std::unique_ptr<BackEnd<Dim>> makeFailsafe<Dim>(                                        \
        std::unique_ptr<BackEnd<Dim>>, std::function<std::unique_ptr<BackEnd<Dim>>()>, DeviceNotice);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
