#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wend {

/// An OpenCL device as the probe saw it.
struct OpenClDeviceInfo {
    int platform = 0, device = 0;  // indices in the order of the OpenCL runtime
    std::string platformName, name, version, type;
    int computeUnits = 0;
    long memoryMegabytes = 0;
    bool doublePrecision = false;
    bool works = false;   // a kernel in double precision was built, run and gave the right numbers
    std::string problem;  // why it does not work
};

struct OpenClDevice;

/// A device that is opened at the first use, once for all copies, so that all objects that compute there
/// share its context and its data. It may be used from several threads.
class OpenClPlace {
  public:
    OpenClPlace(OpenClDeviceInfo info);  // NOLINT(google-explicit-constructor): a place of one's own

    const OpenClDeviceInfo& info() const { return m_info; }
    /// Throws cl::Error.
    std::shared_ptr<OpenClDevice> open() const;

  private:
    struct Shared;
    OpenClDeviceInfo m_info;
    std::shared_ptr<Shared> m_shared;
};

struct OpenClDevices {
    std::vector<OpenClDeviceInfo> devices;
    std::string problem;  // why there is none, if there is none
};

/// Returns all devices, each tried with a small kernel in a process of its own (wend-clprobe): a driver that
/// aborts takes only that process with it. Runs once per process; the result is kept.
const OpenClDevices& openClDevices();

/// Returns the device that `wanted` names (part of a name, any case; or "P:D" indices), or the environment
/// variable WEND_DEVICE if it is empty, else the first working GPU, else the first working device. Nothing if
/// none works or matches; `why` then says why.
std::optional<OpenClDeviceInfo> chooseOpenClDevice(const std::string& wanted, std::string& why);

/// Makes the settings that drivers read at their first call. The program and the probe call it before any
/// other OpenCL call.
void prepareOpenClEnvironment();

}  // namespace wend
