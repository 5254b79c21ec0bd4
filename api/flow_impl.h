#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "wend/flow.h"

namespace wend {

template <int Dim>
struct Flow<Dim>::Impl {
    Impl(std::shared_ptr<const SimplicialMesh<Dim>> mesh, std::shared_ptr<const Material<Dim>> material,
         const IntegrationOptions& options)
        : rest(std::move(mesh)),
          deformer(rest, std::move(material), {}, options, BackEndKind::Cpu),
          atRest(deformer.state()) {}

    /// Gives the deformer the handles, which it checks all together.
    void apply() {
        if (!isChanged) return;
        deformer.setHandles(handles);
        isChanged = false;
    }
    int add(Handle<Dim> handle) {
        handles.push_back(std::move(handle));
        isChanged = true;
        return static_cast<int>(handles.size()) - 1;
    }
    Distortion distortion() const { return wend::distortion<Dim>(*rest, deformer.state().points); }

    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    Deformer<Dim> deformer;
    State<Dim> atRest;
    std::vector<Handle<Dim>> handles;
    bool isChanged = false;
    std::optional<double> end;  // of a run without one; none: that of the last movement
};

/// Flows of shapes that were made by other parts of Wend.
template <int Dim>
struct FlowMaker {
    static Flow<Dim> make(std::shared_ptr<const SimplicialMesh<Dim>> rest,
                          std::shared_ptr<const Material<Dim>> material, std::vector<Handle<Dim>> handles,
                          const IntegrationOptions& options, double end) {
        auto impl = std::make_unique<typename Flow<Dim>::Impl>(std::move(rest), std::move(material), options);
        impl->handles = std::move(handles);
        impl->isChanged = true;
        impl->end = end;
        return Flow<Dim>(std::move(impl));
    }
};

}  // namespace wend
