#pragma once

#include <stop_token>

#include "app/session/scene.h"

namespace wend {

/// What the shape in the window depends on: immutable values of the document.
struct ShapeInputs {
    int generation = 0;  // of the opened file
    int revision = 0;    // of the request
    std::shared_ptr<const Project> project;
    std::shared_ptr<const Image> picture;  // 2D only
    std::string folder;
};

template <int Dim>
struct BuiltShape {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const Material<Dim>> material;
    std::shared_ptr<const std::vector<Facet<Dim>>> facets;  // 3D only
    std::shared_ptr<const Skin> skin;                       // 3D only: see Scene
    std::shared_ptr<const Embedding<3>> embedding;          // 3D only
    std::shared_ptr<const Texture> texture;                 // 2D only: the picture on a file's mesh
    std::shared_ptr<const MeshFile> source;                 // of a mesh domain: see Scene
    Vec<2> frame = Vec<2>::Zero();                          // of a picture's domain: its size
    bool refineHelps = false;                               // 3D only: see Solid
    std::vector<std::string> notices;                       // what the user should hear of the mesh
};

/// Outline, mesh and material of a project, made again only where the inputs are neither those of the last
/// time nor those of the time before, to which one goes back by undo or by cancelling. The steps are those of
/// loadScene(), so that window and command line have the same mesh. The project's dimension must be Dim.
template <int Dim>
class ShapeBuilder {
  public:
    /// Throws InputError (SurfaceError for a surface that bounds no volume). Null rest if stopped; what was
    /// made before is kept then.
    BuiltShape<Dim> build(const ShapeInputs& inputs, std::stop_token stop);

  private:
    BuiltShape<Dim> makeMesh(const ShapeInputs& inputs, std::stop_token stop);
    struct Made {
        ShapeInputs inputs;
        BuiltShape<Dim> shape;
    };
    static bool hasMesh(const Made& made, const ShapeInputs& inputs);
    static bool hasMaterial(const Made& made, const ShapeInputs& inputs);

    std::vector<Made> m_made;  // the newest first, of one file
    ShapeInputs m_outlineFrom;
    std::shared_ptr<const Outline> m_outline;  // 2D only
};
}  // namespace wend
