#include "kernels/opencl_devices.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "core/base/child_process.h"

namespace wend {
namespace {

constexpr double kProbeSeconds = 60;  // on a busy machine; a cold PoCL compiles for seconds
constexpr double kProbeWork = 10;     // seconds of the processor's time
constexpr double kProbeIdle = 4;      // seconds without a sign of life: the driver hangs
constexpr int kProbeMegabytes = 0;    // GPU drivers reserve hundreds of gigabytes of addresses: no limit

constexpr const char* kNoAnswer = "the device failed at a first small kernel";

std::vector<std::string> split(const std::string& line, char separator) {
    std::vector<std::string> fields;
    std::stringstream stream(line);
    for (std::string field; std::getline(stream, field, separator);) fields.push_back(field);
    return fields;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// Parses a line of the probe: "device" and ten fields, separated by tabs; a second line "works P D" follows
/// if the kernel ran.
OpenClDeviceInfo parseDevice(const std::vector<std::string>& fields) {
    OpenClDeviceInfo info;
    info.platform = std::atoi(fields[1].c_str());
    info.device = std::atoi(fields[2].c_str());
    info.platformName = fields[3];
    info.name = fields[4];
    info.version = fields[5];
    info.type = fields[6];
    info.computeUnits = std::atoi(fields[7].c_str());
    info.memoryMegabytes = std::atol(fields[8].c_str());
    info.doublePrecision = fields[9] == "1";
    info.problem = kNoAnswer;
    return info;
}

void parseOutcome(const std::vector<std::string>& fields, std::vector<OpenClDeviceInfo>& devices) {
    for (auto& info : devices) {
        if (std::to_string(info.platform) != fields[1] || std::to_string(info.device) != fields[2]) continue;
        info.works = fields[0] == "works";
        info.problem = info.works ? "" : fields.size() > 3 ? fields[3] : "";
    }
}

/// Returns the message about a driver that had to be stopped; empty for others.
std::string hangOf(const ChildResult& child) {
    const std::string after = child.end == ChildResult::End::Idle
                                  ? std::to_string(static_cast<int>(kProbeIdle)) + " seconds"
                                  : std::to_string(static_cast<int>(kProbeWork)) + " seconds of computing";
    if (child.end != ChildResult::End::Idle && child.end != ChildResult::End::TimedOut) return {};
    return "an OpenCL driver gave no answer within " + after +
           " and was stopped (drivers are named in /etc/OpenCL/vendors, or where OCL_ICD_VENDORS says)";
}

OpenClDevices probe() {
    OpenClDevices result;
    const ChildResult child = runChild(siblingProgram("wend-clprobe"), {}, kProbeSeconds, kProbeMegabytes, {},
                                       kProbeWork, kProbeIdle);
    for (const std::string& line : split(child.output, '\n')) {
        const auto fields = split(line, '\t');
        if (fields.size() >= 10 && fields[0] == "device")
            result.devices.push_back(parseDevice(fields));
        else if (fields.size() >= 3 && (fields[0] == "works" || fields[0] == "fails"))
            parseOutcome(fields, result.devices);
        else if (fields.size() >= 2 && fields[0] == "none")
            result.problem = fields[1];
    }
    if (const std::string hang = hangOf(child); !hang.empty()) {
        for (auto& info : result.devices)
            if (!info.works && info.problem == kNoAnswer) info.problem = hang;
        if (result.devices.empty()) result.problem = hang;
    }
    if (child.end == ChildResult::End::NotStarted)
        result.problem = "wend-clprobe is missing beside the program";
    else if (result.devices.empty() && result.problem.empty())
        result.problem = "the OpenCL driver failed";
    return result;
}

#ifdef WEND_WITHOUT_OPENCL
constexpr bool kIsBuiltIn = false;
#else
constexpr bool kIsBuiltIn = true;
#endif

bool matches(const OpenClDeviceInfo& info, const std::string& wanted) {
    return wanted == std::to_string(info.platform) + ":" + std::to_string(info.device) ||
           lower(info.name).find(lower(wanted)) != std::string::npos ||
           lower(info.platformName).find(lower(wanted)) != std::string::npos;
}

}  // namespace

void prepareOpenClEnvironment() {
    // PoCL's handler for SIGFPE is process-wide and makes integer divisions by zero in our own code silent.
    setenv("POCL_SIGFPE_HANDLER", "0", 1);
    setenv("POCL_SIGUSR2_HANDLER", "0", 1);
}

const OpenClDevices& openClDevices() {
    static const OpenClDevices devices = kIsBuiltIn ? probe() : OpenClDevices{{}, "built without OpenCL"};
    return devices;
}

std::optional<OpenClDeviceInfo> chooseOpenClDevice(const std::string& name, std::string& why) {
    const char* variable = std::getenv("WEND_DEVICE");
    const std::string wanted = !name.empty() ? name : variable != nullptr ? variable : "";
    const OpenClDevices& all = openClDevices();
    std::vector<OpenClDeviceInfo> candidates;
    for (const auto& info : all.devices)
        if (wanted.empty() || matches(info, wanted)) candidates.push_back(info);
    std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return std::pair(a.works, a.type == "GPU") > std::pair(b.works, b.type == "GPU");
    });
    if (candidates.empty())
        why = all.devices.empty() ? "no OpenCL device: " + all.problem
                                  : "no OpenCL device is called \"" + wanted + "\"";
    else if (!candidates[0].works)
        why = candidates[0].name + ": " + candidates[0].problem;
    else
        return candidates[0];
    return std::nullopt;
}

}  // namespace wend
