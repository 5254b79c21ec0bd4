#pragma once

#include <stdexcept>

#include "core/assembly/back_end.h"
#include "kernels/opencl_devices.h"

namespace wend {

/// The device failed in the middle of the work: the caller goes on with the CPU from the last good shape.
class DeviceFailure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A back end on an OpenCL device. Throws DeviceFailure here and from every call.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeOpenClBackEnd(const OpenClDeviceInfo& device,
                                                std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                const SimplicialMesh<Dim>& rest,
                                                const Material<Dim>& material);

}  // namespace wend
