#include "kernels/opencl_context.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <mutex>

#include "core/base/error.h"
#include "core/base/safe_file.h"
#include "kernels/kernel_sources.h"

namespace wend {
namespace fs = std::filesystem;
namespace {

/// Returns $XDG_CACHE_HOME/wend/kernels; empty if there is no place for it.
fs::path cacheFolder() {
    const char* base = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    fs::path folder;
    if (base != nullptr && *base != '\0')
        folder = fs::path(base);
    else if (home != nullptr && *home != '\0')
        folder = fs::path(home) / ".cache";
    else
        return {};
    std::error_code error;
    fs::create_directories(folder / "wend/kernels", error);
    return error ? fs::path() : folder / "wend/kernels";
}

std::vector<unsigned char> readBinary(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void keepBinary(const fs::path& path, const cl::Program& program) {
    const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    if (path.empty() || binaries.size() != 1 || binaries[0].empty()) return;
    try {
        writeWhole(path.string(), {reinterpret_cast<const char*>(binaries[0].data()), binaries[0].size()});
    } catch (const InputError&) {
        // Without a cache the next start compiles again.
    }
}

}  // namespace

struct OpenClPlace::Shared {
    std::mutex mutex;
    std::shared_ptr<OpenClDevice> device;
};

OpenClPlace::OpenClPlace(OpenClDeviceInfo info)
    : m_info(std::move(info)), m_shared(std::make_shared<Shared>()) {}

std::shared_ptr<OpenClDevice> OpenClPlace::open() const {
    const std::scoped_lock lock(m_shared->mutex);
    if (m_shared->device) return m_shared->device;
    std::vector<cl::Platform> platforms;
    cl::Platform::get(&platforms);
    std::vector<cl::Device> devices;
    if (m_info.platform < 0 || static_cast<std::size_t>(m_info.platform) >= platforms.size())
        throw cl::Error(CL_INVALID_PLATFORM, "the platform is gone");
    platforms[static_cast<std::size_t>(m_info.platform)].getDevices(CL_DEVICE_TYPE_ALL, &devices);
    if (m_info.device < 0 || static_cast<std::size_t>(m_info.device) >= devices.size())
        throw cl::Error(CL_INVALID_DEVICE, "the device is gone");
    const cl::Device& device = devices[static_cast<std::size_t>(m_info.device)];
    m_shared->device = std::make_shared<OpenClDevice>(OpenClDevice{device, cl::Context(device)});
    return m_shared->device;
}

OpenClContext::OpenClContext(const OpenClPlace& place)
    : m_info(place.info()), m_device(place.open()), m_queue(m_device->context, m_device->device) {}

cl::Program OpenClContext::build(std::initializer_list<std::string_view> files, const std::string& options) {
    std::string source;
    for (const std::string_view file : files) source += kernelSource(file);
    const std::string key =
        m_info.platformName + '\n' + m_info.name + '\n' + m_info.version + '\n' + options + '\n' + source;
    const fs::path folder = cacheFolder();
    const fs::path cached =
        folder.empty() ? folder : folder / (std::to_string(std::hash<std::string>{}(key)) + ".bin");
    if (!cached.empty() && fs::exists(cached)) {
        try {
            cl::Program program(context(), {m_device->device}, cl::Program::Binaries{readBinary(cached)});
            program.build(m_device->device, options.c_str());
            return program;
        } catch (const cl::Error&) {
            // A stale binary, as after a driver's update: build from the text.
        }
    }
    cl::Program program(context(), source);
    program.build(m_device->device, options.c_str());
    keepBinary(cached, program);
    return program;
}

std::string describe(const cl::Error& error) {
    std::string text =
        std::string("OpenCL: ") + error.what() + " failed (" + std::to_string(error.err()) + ")";
    if (const auto* build = dynamic_cast<const cl::BuildError*>(&error))
        for (const auto& [device, log] : build->getBuildLog()) text += ": " + log.substr(0, log.find('\n'));
    return text;
}

}  // namespace wend
