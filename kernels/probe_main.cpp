// wend-clprobe: lists the OpenCL devices on standard output and tries each with a small kernel. A program of
// its own because drivers abort the process when something on the machine is missing.

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>

#include "kernels/opencl.h"

namespace {

constexpr const char* kKernel = R"(
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
kernel void probe(global const double* x, global double* y, int n) {
    const int i = get_global_id(0);
    if (i < n) y[i] = sqrt(x[i]) + 1.0;
}
)";

/// Returns the text as one line, without the characters that separate fields.
std::string clean(std::string text) {
    for (char& c : text)
        if (c == '\t' || c == '\n' || c == '\r') c = ' ';
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    return text;
}

const char* typeName(cl_device_type type) {
    if ((type & CL_DEVICE_TYPE_GPU) != 0) return "GPU";
    return (type & CL_DEVICE_TYPE_CPU) != 0 ? "CPU" : "accelerator";
}

bool hasDouble(const cl::Device& device) {
    return device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp64") != std::string::npos;
}

void print(int platform, int index, const cl::Platform& owner, const cl::Device& device) {
    std::printf("device\t%d\t%d\t%s\t%s\t%s\t%s\t%u\t%lu\t%d\n", platform, index,
                clean(owner.getInfo<CL_PLATFORM_NAME>()).c_str(),
                clean(device.getInfo<CL_DEVICE_NAME>()).c_str(),
                clean(device.getInfo<CL_DEVICE_VERSION>()).c_str(),
                typeName(device.getInfo<CL_DEVICE_TYPE>()), device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>(),
                static_cast<unsigned long>(device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>() >> 20),
                hasDouble(device) ? 1 : 0);
    std::fflush(stdout);
}

bool kernelGivesRightNumbers(const cl::Device& device) {
    constexpr int kCount = 256;
    std::vector<double> x(kCount), y(kCount, 0.0);
    std::iota(x.begin(), x.end(), 0.0);
    const cl::Context context(device);
    const cl::CommandQueue queue(context, device);
    const cl::Buffer in(context, x.begin(), x.end(), true), out(context, y.begin(), y.end(), false);
    const cl::Program program(context, kKernel, true);
    cl::Kernel kernel(program, "probe");
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    kernel.setArg(2, kCount);
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(kCount), cl::NDRange(64));
    cl::copy(queue, out, y.begin(), y.end());
    for (int i = 0; i < kCount; ++i)
        if (std::abs(y[i] - (std::sqrt(x[i]) + 1)) > 1e-12) return false;
    return true;
}

void tryDevice(int platform, int index, const cl::Device& device) {
    std::string problem;
    try {
        if (!hasDouble(device))
            problem = "no double precision";
        else if (!kernelGivesRightNumbers(device))
            problem = "wrong numbers";
    } catch (const cl::Error& error) {
        problem = std::string(error.what()) + " failed (" + std::to_string(error.err()) + ")";
    }
    std::printf("%s\t%d\t%d\t%s\n", problem.empty() ? "works" : "fails", platform, index,
                clean(problem).c_str());
    std::fflush(stdout);
}

void probeAll() {
    std::vector<cl::Platform> platforms;
    cl::Platform::get(&platforms);
    for (std::size_t p = 0; p < platforms.size(); ++p) {
        std::vector<cl::Device> devices;
        try {
            platforms[p].getDevices(CL_DEVICE_TYPE_ALL, &devices);
        } catch (const cl::Error&) {
            continue;  // a platform without devices
        }
        for (std::size_t d = 0; d < devices.size(); ++d) {
            print(static_cast<int>(p), static_cast<int>(d), platforms[p], devices[d]);
            tryDevice(static_cast<int>(p), static_cast<int>(d), devices[d]);
        }
    }
}

}  // namespace

/// Limits the processor's time, since a driver may loop.
void limitTime(const char* seconds) {
    const rlim_t soft = static_cast<rlim_t>(std::max(1, std::atoi(seconds)));
    const rlimit limit{soft, soft + 1};
    setrlimit(RLIMIT_CPU, &limit);
}

int main(int argc, char** argv) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // the answer is useless once the program has ended
    if (argc > 2) limitTime(argv[2]);
    try {
        probeAll();
    } catch (const cl::Error& error) {
        std::printf("none\t%s\n", error.err() == -1001 ? "no OpenCL driver is installed" : error.what());
    }
    return 0;
}
