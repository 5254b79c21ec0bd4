#pragma once

#include <memory>
#include <string>

#include "kernels/opencl.h"
#include "kernels/opencl_devices.h"

namespace wend {

/// One device, ready to run kernels: context, queue and built programs. Not shared between threads.
class OpenClContext {
  public:
    /// Throws cl::Error.
    explicit OpenClContext(const OpenClDeviceInfo& info);

    const OpenClDeviceInfo& info() const { return m_info; }
    cl::Context& context() { return m_context; }
    cl::CommandQueue& queue() { return m_queue; }

    /// Builds an embedded kernel file. Binaries are kept per device, options and text in the user's cache
    /// folder.
    cl::Program build(const std::string& file, const std::string& options);

    template <typename T>
    cl::Buffer buffer(std::size_t count) {
        return cl::Buffer(m_context, CL_MEM_READ_WRITE, std::max<std::size_t>(1, count) * sizeof(T));
    }
    template <typename T>
    cl::Buffer copyOf(const T* data, std::size_t count) {
        cl::Buffer target = buffer<T>(count);
        if (count > 0) m_queue.enqueueWriteBuffer(target, CL_TRUE, 0, count * sizeof(T), data);
        return target;
    }

  private:
    OpenClDeviceInfo m_info;
    cl::Device m_device;
    cl::Context m_context;
    cl::CommandQueue m_queue;
};

/// A kernel with a fixed local size (each new one would be compiled again) and a padded global size.
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

/// "kernel assembly.cl: message": what a cl::Error says, for a person.
std::string describe(const cl::Error& error);

}  // namespace wend
