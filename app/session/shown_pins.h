#pragma once

#include <tuple>

#include "app/project/edits/document.h"
#include "app/session/pins.h"

namespace wend {

class ShapeMotion;

/// The document's handles in the shown frame. Their places in the rest mesh are cached per project and mesh.
/// Lives in the window's thread.
class ShownPins {
  public:
    ShownPins(const Document& document, const ShapeMotion& motion) : m_document(document), m_motion(motion) {}

    int count() const;
    /// Returns whether a handle may not be changed: it is locked, or the part that it is in.
    bool isLocked(int handle) const;
    /// The name of one, or how many they are.
    QString nameOf(const std::vector<int>& handles) const;
    /// Returns the pins that act at a time, or those that do not; hidden ones only if `all`.
    template <int Dim>
    std::vector<PinView<Dim>> at(double time, bool holding, bool all) const;
    template <int Dim>
    std::vector<Vec<Dim>> pathStarts(int handle) const;
    std::vector<int> verticesOf(int handle) const;
    Placement<3> placementOf(const std::vector<int>& vertices) const;
    /// Resets the cache for another file.
    void drop() { m_holds = {}; }

  private:
    template <int Dim>
    PosedPtr<Dim> shape() const;
    template <int Dim>
    const std::vector<PinPlace<Dim>>& places() const;

    template <int Dim>
    struct Hold {  // of the project's dimension; the other one is empty
        std::shared_ptr<const SimplicialMesh<Dim>> rest;
        std::shared_ptr<const Project> project;
        std::vector<PinPlace<Dim>> places;
    };
    const Document& m_document;
    const ShapeMotion& m_motion;
    mutable std::tuple<Hold<2>, Hold<3>> m_holds;
};

}  // namespace wend
