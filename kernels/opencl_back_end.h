#pragma once

#include "core/assembly/back_end.h"
#include "kernels/device_failure.h"
#include "kernels/opencl_devices.h"

namespace wend {

/// Makes a back end on an OpenCL device; `threads` of the processor do the rest, as in BackEndFactory. This
/// and every call of it throw DeviceFailure.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeOpenClBackEnd(const OpenClPlace& device,
                                                std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                const SimplicialMesh<Dim>& rest,
                                                const Material<Dim>& material, int threads);

}  // namespace wend
