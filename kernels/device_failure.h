#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace wend {

/// The device failed in the middle of the work: the caller goes on with the CPU from the last good shape.
class DeviceFailure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Says once, in a sentence for a person, that the device failed and the CPU goes on.
using DeviceNotice = std::function<void(const std::string&)>;

inline std::string failureText(const std::string& device, const DeviceFailure& failure) {
    return device + " failed (" + failure.what() + "); the processor goes on";
}

}  // namespace wend
