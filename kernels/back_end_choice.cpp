#include "kernels/back_end_choice.h"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "core/assembly/cpu_back_end.h"
#include "core/base/error.h"
#include "kernels/opencl_back_end.h"
#include "kernels/opencl_distortion.h"
#include "kernels/opencl_warp.h"

namespace wend {
namespace {

/// A launch and its copies cost a GPU more than the work below this number of unknowns, so that none is used.
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
    WorkerPool& workers() override { return m_active->workers(); }

    void setMassRegularization(std::vector<double> epsilon) override {
        m_massRegularization = epsilon;
        safely([&] { m_active->setMassRegularization(epsilon); });
    }
    int setShape(const Points<Dim>& shape) override {
        m_shape = shape;
        m_atStage = false;
        return safely([&] { return m_active->setShape(shape); });
    }
    StageVectors<Dim>& stages() override { return m_stages; }
    int setStage() override {
        m_stages.keepPlace();
        m_atStage = true;
        return safely([&] { return m_active->setStage(); });
    }
    CopiedBytes copied() const override { return m_makeFallback ? m_active->copied() : m_copied; }
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
    /// The active back end's stages, and what the processor needs to make the same sums.
    class Stages final : public StageVectors<Dim> {
        using typename StageVectors<Dim>::Terms;

      public:
        explicit Stages(FailsafeBackEnd& owner) : m_owner(owner) {}
        void combine(const Nodal<Dim>& y, Terms terms) override {
            m_latest = {y, {terms.begin(), terms.end()}};
            m_owner.safely([&] { m_latest.make(active()); });
        }
        Nodal<Dim> shape() override {
            return m_owner.safely([&] { return active().shape(); });
        }
        double distance(const Nodal<Dim>& other) override {
            return m_owner.safely([&] { return active().distance(other); });
        }
        double maximum(Terms terms) override {
            return m_owner.safely([&] { return active().maximum(terms); });
        }

        /// Records that the back end's geometry is that of the latest sum.
        void keepPlace() { m_place = m_latest; }
        void makePlace() { m_place.make(active()); }
        void makeLatest() { m_latest.make(active()); }

      private:
        struct Sum {
            Nodal<Dim> y;
            std::vector<WeightedField<Dim>> terms;
            void make(StageVectors<Dim>& stages) const {
                if (y) stages.combine(y, terms);
            }
        };
        StageVectors<Dim>& active() { return m_owner.m_active->stages(); }

        FailsafeBackEnd& m_owner;
        Sum m_latest, m_place;
    };

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
        m_copied = m_active->copied();
        m_lost = std::exchange(m_active, std::exchange(m_makeFallback, nullptr)());
        m_active->setMassRegularization(m_massRegularization);
        if (m_atStage) {
            m_stages.makePlace();
            m_active->setStage();
        } else if (m_shape.cols() > 0) {
            m_active->setShape(m_shape);
        }
        m_stages.makeLatest();
        if (m_notice) m_notice(failureText(device, DeviceFailure(why)));
    }

    std::unique_ptr<BackEnd<Dim>> m_active;
    std::unique_ptr<BackEnd<Dim>> m_lost;  // lives on: its workers may be in use where the failure is noticed
    std::function<std::unique_ptr<BackEnd<Dim>>()> m_makeFallback;
    DeviceNotice m_notice;
    std::vector<double> m_massRegularization;
    Points<Dim> m_shape;
    Stages m_stages{*this};
    bool m_atStage = false;  // the geometry is a stage's, not m_shape's
    CopiedBytes m_copied;    // with the device that failed
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

struct SharedDevice::State {
    std::mutex mutex;
    std::optional<OpenClPlace> place;
};

SharedDevice::SharedDevice() : m_state(std::make_shared<State>()) {}

OpenClPlace SharedDevice::at(const OpenClDeviceInfo& info) const {
    const std::scoped_lock lock(m_state->mutex);
    auto& place = m_state->place;
    const bool same = place && place->info().platform == info.platform && place->info().device == info.device;
    if (!same) place.emplace(info);
    return *place;
}

template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeFailsafe(std::unique_ptr<BackEnd<Dim>> primary,
                                           std::function<std::unique_ptr<BackEnd<Dim>>()> makeFallback,
                                           DeviceNotice notice) {
    return std::make_unique<FailsafeBackEnd<Dim>>(std::move(primary), std::move(makeFallback),
                                                  std::move(notice));
}

template <int Dim>
BackEndFactory<Dim> backEndFactory(BackEndKind kind, const std::string& device, DeviceNotice notice,
                                   const SharedDevice& shared) {
    return [kind, device, notice = std::move(notice), shared](
               std::shared_ptr<const AssemblyPlan<Dim>> plan, const SimplicialMesh<Dim>& rest,
               const Material<Dim>& material, int threads) -> std::unique_ptr<BackEnd<Dim>> {
        const auto info = deviceFor(kind, device, Dim * rest.vertexCount());
        const auto makeCpu = [plan, rest, material, threads] {
            return makeCpuBackEnd<Dim>(plan, rest, material, threads);
        };
        if (!info) return makeCpu();
        try {
            return makeFailsafe<Dim>(makeOpenClBackEnd<Dim>(shared.at(*info), plan, rest, material, threads),
                                     makeCpu, notice);
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
                               DeviceNotice notice, const SharedDevice& shared) {
    const auto onProcessor = [&rest](const Points<Dim>& pose) { return distortion(rest, pose); };
    const auto info = kind == BackEndKind::OpenCl ? deviceFor(kind, device, 0) : std::nullopt;
    if (!info) return onProcessor;
    return [onProcessor, &rest, notice = std::move(notice), place = shared.at(*info),
            onDevice = std::shared_ptr<OpenClDistortion<Dim>>()](const Points<Dim>& pose) mutable {
        try {
            if (!onDevice) onDevice = std::make_shared<OpenClDistortion<Dim>>(place, rest);
            return onDevice->of(pose);
        } catch (const DeviceFailure& failure) {
            if (notice) notice(failureText(place.info().name, failure));
            return onProcessor(pose);
        }
    };
}

MakeCellPainter cellPainters(BackEndKind kind, const std::string& device, DeviceNotice notice,
                             const SharedDevice& shared) {
    if (kind != BackEndKind::OpenCl) return {};
    const auto info = deviceFor(kind, device, 0);
    const auto picture = std::make_shared<OpenClPicture>(shared.at(*info), std::move(notice));
    return [picture](const WarpJob& job) { return OpenClPicture::painter(picture, job); };
}

#define WEND_INSTANTIATE(Dim)                                                                            \
    template BackEndFactory<Dim> backEndFactory<Dim>(BackEndKind, const std::string&, DeviceNotice,      \
                                                     const SharedDevice&);                               \
    template DistortionOf<Dim> distortionOf<Dim>(BackEndKind, const SimplicialMesh<Dim>&,                \
                                                 const std::string&, DeviceNotice, const SharedDevice&); \
    template std::unique_ptr<BackEnd<Dim>> makeFailsafe<Dim>(                                            \
        std::unique_ptr<BackEnd<Dim>>, std::function<std::unique_ptr<BackEnd<Dim>>()>, DeviceNotice);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
