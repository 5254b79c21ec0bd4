#pragma once

#include <memory>

#include "kernels/device_failure.h"
#include "kernels/opencl_devices.h"
#include "warp/warp.h"

namespace wend {

/// Paints the cells of a warp on an OpenCL device. Where the device fails, now or later, it says so to
/// `notice` and leaves the cells to the processor (nothing is returned now, false is later).
std::unique_ptr<CellPainter> makeOpenClPainter(const OpenClDeviceInfo& device, const WarpJob& job,
                                               const DeviceNotice& notice);

}  // namespace wend
