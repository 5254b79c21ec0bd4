#pragma once

#include <stop_token>

#include "app/engine/shape/parted_shape.h"
#include "app/engine/shape/shape.h"
#include "app/engine/shape/solid.h"
#include "core/meshing/outline.h"

namespace wend {

/// The immutable inputs that a shape depends on.
struct ShapeInputs {
    int generation = 0;  // of the opened file
    int revision = 0;    // of the request
    std::shared_ptr<const Project> project;
    std::shared_ptr<const Image> picture;  // of the domain; null: it is read
    std::string folder;

    int dimension() const;
};

/// Returns whether both projects produce the same solid.
bool sameSolid(const Project& a, const Project& b);

/// Builds outline, mesh and material of a project, and reuses the results for the last two inputs, because
/// undo and cancelling return to the previous one. The project's dimension must be Dim.
template <int Dim>
class ShapeBuilder {
  public:
    explicit ShapeBuilder(Advice advice = Advice::None) : m_advice(advice) {}

    /// Returns a null rest mesh if stopped, and keeps the earlier results then. Throws InputError
    /// (SurfaceError if a surface bounds no volume).
    Shape<Dim> build(const ShapeInputs& inputs, std::stop_token stop);

  private:
    Shape<Dim> makeMesh(const ShapeInputs& inputs, std::stop_token stop);
    std::shared_ptr<const SimplicialMesh<2>> meshOutline(const ShapeInputs& inputs, const Image& picture,
                                                         std::stop_token stop);
    struct Made {
        ShapeInputs inputs;
        Shape<Dim> shape;
    };
    static bool hasMesh(const Made& made, const ShapeInputs& inputs);
    static bool hasMaterial(const Made& made, const ShapeInputs& inputs);

    Advice m_advice;
    std::vector<Made> m_made;  // the newest first, of one file
    ShapeInputs m_outlineFrom;
    std::shared_ptr<const Outline> m_outline;  // 2D only
    PartedCache m_parted;                      // of the file of the newest shape
};

/// Builds a shape without any cache. Messages use the terms of the command line. Throws InputError, and
/// Cancelled when stopped.
AnyShape loadShape(const Project& project, const std::string& folder, std::stop_token stop = {});

/// Returns whether the same mesh serves for both inputs, so that only the motion is to be computed.
bool sameMesh(const ShapeInputs& a, const ShapeInputs& b);

}  // namespace wend
