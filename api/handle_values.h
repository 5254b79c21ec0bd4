#pragma once

#include "api/boundary.h"
#include "core/motion/handle.h"
#include "wend/handles.h"

namespace wend {

template <int Dim>
struct Place<Dim>::Data {
    Placement<Dim> at;
    unsigned slides = 0;  // see Handle
};

template <int Dim>
struct Movement<Dim>::Data {
    std::vector<Motion<Dim>> motions;
    void add(decltype(Motion<Dim>::kind) kind, const TimeWindow& when);
};

}  // namespace wend
