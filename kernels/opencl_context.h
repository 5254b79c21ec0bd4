#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

#include "core/assembly/back_end.h"
#include "kernels/device_failure.h"
#include "kernels/opencl.h"
#include "kernels/opencl_devices.h"

namespace wend {

/// Returns "kernel assembly.cl: message": what a cl::Error says, for a person.
std::string describe(const cl::Error& error);

/// An open device.
struct OpenClDevice {
    cl::Device device;
    cl::Context context;
};

/// A device ready to run kernels, for one user: a queue of its own, and its copies counted. Not shared
/// between threads.
class OpenClContext {
  public:
    /// Throws cl::Error.
    explicit OpenClContext(const OpenClPlace& place);

    const OpenClDeviceInfo& info() const { return m_info; }
    const cl::Context& context() const { return m_device->context; }
    cl::CommandQueue& queue() { return m_queue; }

    /// Builds embedded kernel files as one, in their order. Binaries are kept per device, options and text in
    /// the user's cache folder.
    cl::Program build(std::initializer_list<std::string_view> files, const std::string& options);

    template <typename T>
    cl::Buffer buffer(std::size_t count) {
        return cl::Buffer(context(), CL_MEM_READ_WRITE, std::max<std::size_t>(1, count) * sizeof(T));
    }
    template <typename T>
    cl::Buffer copyOf(const T* data, std::size_t count) {
        cl::Buffer target = buffer<T>(count);
        write(target, data, count);
        return target;
    }

    /// Copies to and from the device return when they are done, and are counted.
    template <typename T>
    void write(cl::Buffer& target, const T* data, std::size_t count, std::size_t first = 0) {
        if (count == 0) return;
        m_queue.enqueueWriteBuffer(target, CL_TRUE, first * sizeof(T), count * sizeof(T), data);
        m_copied.toDevice += count * sizeof(T);
    }
    template <typename T>
    void read(const cl::Buffer& source, T* data, std::size_t count) {
        if (count == 0) return;
        m_queue.enqueueReadBuffer(source, CL_TRUE, 0, count * sizeof(T), data);
        m_copied.fromDevice += count * sizeof(T);
    }

    const CopiedBytes& copied() const { return m_copied; }

  private:
    OpenClDeviceInfo m_info;
    std::shared_ptr<OpenClDevice> m_device;
    cl::CommandQueue m_queue;
    CopiedBytes m_copied;
};

/// Runs OpenCL calls and turns what they throw into a DeviceFailure.
template <typename Work>
auto guarded(Work&& work) {
    try {
        return work();
    } catch (const cl::Error& error) {
        throw DeviceFailure(describe(error));
    }
}

/// Runs a kernel with a fixed local size (each new one would be compiled again) and a padded global size.
template <typename... Arguments>
void launch(cl::CommandQueue& queue, cl::Kernel& kernel, int count, const Arguments&... arguments) {
    constexpr std::size_t kLocal = 64;
    cl_uint index = 0;
    kernel.setArg(index++, count);
    (kernel.setArg(index++, arguments), ...);
    const std::size_t padded = (static_cast<std::size_t>(count) + kLocal - 1) / kLocal * kLocal;
    if (padded > 0)
        queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(padded), cl::NDRange(kLocal));
}

}  // namespace wend
