#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/output/point_table.h"
#include "core/mesh/mesh_write_options.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

struct MeshFile;

/// Points that are mapped by a deformation: the rows of a text (see PointTable), or the vertices of a mesh,
/// which may have no cells.
class PointFile {
  public:
    /// "-" is standard input with a text. Throws InputError.
    PointFile(const std::string& path, int dimension);

    const std::string& path() const { return m_path; }
    const Points<3>& points() const;
    /// Throws InputError if they cannot be written to a file of that name.
    void requireHeldBy(const std::string& path) const;
    /// Returns what such a file does not hold, in one line; empty if it holds all.
    std::string lostIn(const std::string& path, const MeshWriteOptions& options) const;
    /// Writes a file of that name with the points in other places. Throws InputError.
    void write(const std::string& path, const Points<3>& points, const MeshWriteOptions& options) const;

  private:
    std::string m_path;
    int m_dimension;
    std::optional<PointTable> m_table;       // if it is a text
    std::shared_ptr<const MeshFile> m_mesh;  // else
};

/// Throws InputError if no points can be read from, or written to, a file of that name.
void requirePointFormat(const std::string& path, bool isOutput);

/// Maps points by the map of a partition that takes the vertices from one place to another; see Embedding for
/// those outside all cells.
template <int Dim>
class PointMap {
  public:
    /// `depth`: a number per cell; of several cells that hold a point, the one with the greatest is taken,
    /// and of those the last.
    PointMap(SimplicialMesh<Dim> from, const std::vector<float>& depth, const Points<Dim>& points);
    ~PointMap();
    PointMap(PointMap&&) noexcept;

    /// Returns the points with the vertices at `to`.
    Points<Dim> mapped(const Points<Dim>& to) const;
    /// Returns the number of points outside all cells.
    int outside() const;
    /// Returns the number of points within several cells, where the partition covers itself.
    int covered() const { return m_covered; }

  private:
    struct Data;
    std::unique_ptr<const Data> m_data;
    int m_covered = 0;
};

}  // namespace wend
