#pragma once

#include <memory>

#include "core/energy/distortion.h"
#include "kernels/device_failure.h"
#include "kernels/opencl_devices.h"

namespace wend {

/// distortion() on an OpenCL device: values and totals as the processor's but for rounding, the same bits
/// every time. Throws DeviceFailure here and from every call.
template <int Dim>
class OpenClDistortion {
  public:
    OpenClDistortion(const OpenClPlace& device, const SimplicialMesh<Dim>& rest);
    ~OpenClDistortion();
    Distortion of(const Points<Dim>& pose);

  private:
    struct Device;
    std::unique_ptr<Device> m_device;
};

}  // namespace wend
