#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace wend {

/// Thrown if the device failed in the middle of the work. The caller continues with the CPU from the last
/// good shape.
class DeviceFailure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Says once, in a sentence for the user, that the device failed and the CPU continues.
using DeviceNotice = std::function<void(const std::string&)>;

inline std::string failureText(const std::string& device, const DeviceFailure& failure) {
    return device + " failed (" + failure.what() + "); the processor goes on";
}

}  // namespace wend
