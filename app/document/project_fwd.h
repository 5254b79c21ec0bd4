#pragma once

#include <variant>
#include <vector>

namespace wend {

struct DepthRegion;
struct Domain;
struct Project;
template <int Dim>
struct Design;
template <int Dim>
struct MaterialRegion;
template <int Dim>
struct MaterialSpec;

using AnyDesign = std::variant<Design<2>, Design<3>>;
using DepthRegions = std::vector<DepthRegion>;

}  // namespace wend
