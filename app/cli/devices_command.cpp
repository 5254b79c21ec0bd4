#include <thread>

#include "app/cli/commands.h"
#include "kernels/opencl_devices.h"

namespace wend {
namespace {

std::string line(const OpenClDeviceInfo& device) {
    std::string text = "opencl  " + std::to_string(device.platform) + ":" + std::to_string(device.device) +
                       "  " + device.name;
    text += ", " + device.platformName + ", " + device.version + ", " + std::to_string(device.computeUnits) +
            " units, " + std::to_string(device.memoryMegabytes) + " MB";
    return text + (device.works ? "" : " (not used: " + device.problem + ")");
}

}  // namespace

ExitCode runDevices(const Arguments& arguments) {
    if (!arguments.files().empty()) throw UsageError("`wend devices` takes no file");
    const OpenClDevices& found = openClDevices();
    std::string why;
    const auto chosen = chooseOpenClDevice("", why);
    std::string text = "cpu     " + std::to_string(std::thread::hardware_concurrency()) + " threads\n";
    for (const OpenClDeviceInfo& device : found.devices) text += line(device) + "\n";
    if (found.devices.empty()) text += "opencl  none: " + found.problem + "\n";
    const bool gpu = chosen && chosen->type == "GPU";
    text += std::string("--backend auto uses ") +
            (gpu ? chosen->name + " for large shapes, else the cpu" : "the cpu") + "\n";
    text += "--backend opencl uses " + (chosen ? chosen->name : "nothing: " + why) + "\n";
    return print(text);
}

}  // namespace wend
