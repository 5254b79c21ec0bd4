#pragma once

#include "core/assembly/stage_vectors.h"
#include "kernels/device_failure.h"
#include "kernels/opencl_devices.h"

namespace wend {

/// On an OpenCL device: y and the slopes go there once, sums and norms are made there. Throws DeviceFailure
/// here and from every call. `copied` (may be null) counts the bytes to and from the device.
struct StageCopies {
    std::size_t toDevice = 0, fromDevice = 0;
};
template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeOpenClStages(const OpenClDeviceInfo& device,
                                                    StageCopies* copied = nullptr);

/// `primary` until it throws a DeviceFailure, then the processor's with the vectors that were set.
template <int Dim>
std::unique_ptr<StageVectors<Dim>> makeFailsafeStages(std::unique_ptr<StageVectors<Dim>> primary,
                                                      DeviceNotice notice);

}  // namespace wend
