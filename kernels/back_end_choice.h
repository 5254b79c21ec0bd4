#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/assembly/back_end.h"

namespace wend {

/// Says once, in a sentence for a person, that the device failed and the CPU goes on.
using DeviceNotice = std::function<void(const std::string&)>;

/// Which back end computes, by the user's choice:
///   Cpu        the processor's;
///   OpenCl     the device of that name (chooseOpenClDevice); throws InputError if none works;
///   Automatic  a working OpenCL GPU for problems large enough to gain, else the processor. An OpenCL device
///   that is the processor
///              itself (PoCL) is never faster than our own code and is taken by name only.
/// A device that fails in the middle of the work is replaced by the CPU at the last shape, without the caller
/// noticing but through `notice`.
template <int Dim>
BackEndFactory<Dim> backEndFactory(BackEndKind kind, const std::string& device = {},
                                   DeviceNotice notice = {});

/// `primary` until it throws a DeviceFailure, then what `makeFallback` makes, brought to the same shape.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeFailsafe(std::unique_ptr<BackEnd<Dim>> primary,
                                           std::function<std::unique_ptr<BackEnd<Dim>>()> makeFallback,
                                           DeviceNotice notice);

}  // namespace wend
