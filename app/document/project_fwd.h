#pragma once

namespace wend {

struct Domain;
struct Project;
template <int Dim>
struct Design;
template <int Dim>
struct MaterialRegion;
template <int Dim>
struct MaterialSpec;

}  // namespace wend
