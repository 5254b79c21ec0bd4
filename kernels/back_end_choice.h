#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/assembly/back_end.h"
#include "kernels/device_failure.h"
#include "kernels/opencl_devices.h"
#include "warp/cell_painter.h"

namespace wend {

struct Distortion;

/// Shares the open device among several makers of the same choice, once one of them has needed it.
class SharedDevice {
  public:
    SharedDevice();
    OpenClPlace at(const OpenClDeviceInfo& info) const;

  private:
    struct State;
    std::shared_ptr<State> m_state;
};

/// Returns the factory of the back end that the user has chosen:
///   Cpu        the processor's;
///   OpenCl     the device of that name (chooseOpenClDevice); throws InputError if none works;
///   Automatic  a working OpenCL GPU for problems large enough to gain, else the processor. An OpenCL device
///              that is the processor itself (PoCL) is never faster than our own code and is taken by name
///              only.
/// A device that fails in the middle of the work is replaced by the CPU at the last shape, which the caller
/// learns only through `notice`.
template <int Dim>
BackEndFactory<Dim> backEndFactory(BackEndKind kind, const std::string& device = {}, DeviceNotice notice = {},
                                   const SharedDevice& shared = {});

/// `primary` until it throws a DeviceFailure, then what `makeFallback` makes, brought to the same shape.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeFailsafe(std::unique_ptr<BackEnd<Dim>> primary,
                                           std::function<std::unique_ptr<BackEnd<Dim>>()> makeFallback,
                                           DeviceNotice notice);

/// Measures how far a pose is from a rest mesh, which must outlive it.
template <int Dim>
using DistortionOf = std::function<Distortion(const Points<Dim>& pose)>;

/// Makes the same choice for the distortion, but Automatic is the processor, which needs less time for its
/// cells than they need to a device and back.
template <int Dim>
DistortionOf<Dim> distortionOf(BackEndKind kind, const SimplicialMesh<Dim>& rest,
                               const std::string& device = {}, DeviceNotice notice = {},
                               const SharedDevice& shared = {});

/// Makes painters for the texture warp (WarpOptions::makePainter). There are none except for OpenCl, since
/// copying a picture to a device and back takes about as long as painting it with the processor's cores. All
/// painters that one of these makes share the picture on the device (see OpenClPicture).
MakeCellPainter cellPainters(BackEndKind kind, const std::string& device = {}, DeviceNotice notice = {},
                             const SharedDevice& shared = {});

}  // namespace wend
