#pragma once

#include <memory>

#include "core/assembly/back_end.h"
#include "kernels/device_failure.h"
#include "kernels/opencl_devices.h"
#include "warp/warp.h"

namespace wend {

/// The picture of a sequence of warps, on an OpenCL device: it is copied there with the first frame and stays
/// until another one is painted. It is not shared between threads. A picture is identified by its address: it
/// must not change as long as this object is used.
class OpenClPicture {
  public:
    OpenClPicture(OpenClPlace place, DeviceNotice notice);
    ~OpenClPicture();
    OpenClPicture(const OpenClPicture&) = delete;
    OpenClPicture& operator=(const OpenClPicture&) = delete;

    /// Returns a painter of the cells of a warp, which keeps `picture` alive; nothing for half and float
    /// pictures, whose samples the processor bounds (warp/careful_sample.h). Where the device fails, now or
    /// later, it says so to the notice, once, and leaves the cells to the processor: nothing is returned
    /// then.
    static std::unique_ptr<CellPainter> painter(const std::shared_ptr<OpenClPicture>& picture,
                                                const WarpJob& job);
    CopiedBytes copied() const;

  private:
    struct Device;
    friend class OpenClPainter;
    void fail(const DeviceFailure& failure);

    OpenClPlace m_place;
    DeviceNotice m_notice;
    bool m_failed = false;
    std::unique_ptr<Device> m_device;  // made with the first frame
};

}  // namespace wend
