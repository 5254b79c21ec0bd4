#pragma once

#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/integration/deformer.h"

namespace wend::fuzz {

/// A deformation of a random shape by random handles, of which some cannot arrive.
template <int Dim>
struct RandomFlow {
    std::shared_ptr<const SimplicialMesh<Dim>> mesh;
    std::shared_ptr<const Material<Dim>> material;
    std::vector<Handle<Dim>> handles;
    IntegrationOptions options;
};

/// The same numbers give the same flow.
template <int Dim>
RandomFlow<Dim> randomFlow(unsigned seed, unsigned number);

}  // namespace wend::fuzz
