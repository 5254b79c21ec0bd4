// The choice of a back end in a build without OpenCL: the processor.

#include "core/assembly/cpu_back_end.h"
#include "core/base/error.h"
#include "core/energy/distortion.h"
#include "kernels/back_end_choice.h"

namespace wend {
namespace {

void refuseOpenCl(BackEndKind kind) {
    std::string why;
    if (kind != BackEndKind::OpenCl) return;
    chooseOpenClDevice({}, why);
    throw InputError("the OpenCL back end cannot be used: " + why);
}

}  // namespace

struct SharedDevice::State {};

SharedDevice::SharedDevice() = default;

template <int Dim>
BackEndFactory<Dim> backEndFactory(BackEndKind kind, const std::string&, DeviceNotice, const SharedDevice&) {
    return [kind](std::shared_ptr<const AssemblyPlan<Dim>> plan, const SimplicialMesh<Dim>& rest,
                  const Material<Dim>& material, int threads) {
        refuseOpenCl(kind);
        return makeCpuBackEnd<Dim>(std::move(plan), rest, material, threads);
    };
}

template <int Dim>
DistortionOf<Dim> distortionOf(BackEndKind kind, const SimplicialMesh<Dim>& rest, const std::string&,
                               DeviceNotice, const SharedDevice&) {
    refuseOpenCl(kind);
    return [&rest](const Points<Dim>& pose) { return distortion(rest, pose); };
}

MakeCellPainter cellPainters(BackEndKind kind, const std::string&, DeviceNotice, const SharedDevice&) {
    refuseOpenCl(kind);
    return {};
}

#define WEND_INSTANTIATE(Dim)                                                                       \
    template BackEndFactory<Dim> backEndFactory<Dim>(BackEndKind, const std::string&, DeviceNotice, \
                                                     const SharedDevice&);                          \
    template DistortionOf<Dim> distortionOf<Dim>(BackEndKind, const SimplicialMesh<Dim>&,           \
                                                 const std::string&, DeviceNotice, const SharedDevice&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
