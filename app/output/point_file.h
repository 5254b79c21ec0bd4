#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/engine/shape/shape.h"
#include "app/output/output_set.h"
#include "app/output/run_options.h"
#include "core/base/message.h"
#include "core/base/types.h"
#include "core/mesh/mesh_write_options.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

struct MeshFile;

/// Reads points from the rows of a text: numbers between commas, semicolons, tabs or blanks. Everything but
/// the coordinates is kept unchanged: other columns, comments (#, // and %), empty lines and line ends. The
/// coordinates are the columns that a header calls x, y and z (ParaView: Points:0 …), or else the first
/// numbers of a row. In an .xyz file that begins with the number of its atoms, the second line is a comment.
class PointTable {
  public:
    /// Throws InputError with the line.
    PointTable(std::string text, int dimension);

    /// Returns the points; without a third coordinate, z is 0.
    const Points3& points() const { return m_points; }
    /// Returns the number of columns beside the coordinates.
    int furtherColumns() const { return m_furtherColumns; }
    /// Returns the text with other points, in 17 significant digits.
    std::string withPoints(const Points3& points) const;

  private:
    struct Field {
        std::size_t begin, end;  // in the text
    };
    class Reader;

    std::string m_text;
    int m_dimension, m_furtherColumns = 0;
    std::vector<Field> m_fields;  // of the coordinates, point by point
    Points3 m_points;
};

/// Returns whether the name is that of a table of points: .csv, .tsv, .txt, .xyz or .dat.
bool isPointTable(const std::string& path);

/// Returns the points as such a text: in a .csv file below the header "x,y[,z]", elsewhere between blanks.
std::string pointTableText(const Points3& points, int dimension, bool commas);

/// Points that are mapped by a deformation: the rows of a text (see PointTable), or the vertices of a mesh,
/// which may have no cells.
class PointFile {
  public:
    /// "-" is standard input with a text. Throws InputError.
    PointFile(const std::string& path, int dimension);

    const std::string& path() const { return m_path; }
    const Points3& points() const;
    /// Throws InputError if they cannot be written to a file of that name.
    void requireHeldBy(const std::string& path) const;
    /// Returns what such a file does not hold, in one line; empty if it holds all.
    std::string lostIn(const std::string& path, const MeshWriteOptions& options) const;
    /// Writes a file of that name with the points in other places. Throws InputError.
    void write(const std::string& path, const Points3& points, const MeshWriteOptions& options) const;

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

/// Maps the points of files by the deformation of a run, or by its inverse.
template <int Dim>
class MappedPoints {
  public:
    /// Returns the order of the cells at a time, by which a picture is painted; empty for solids.
    using Depths = std::function<const std::vector<float>&(double time)>;
    using Notice = std::function<void(const Message&)>;

    /// Reads the files. Without RunOptions::inverse finds the places of their points at rest. All arguments
    /// must outlive this object. Throws InputError.
    MappedPoints(const Shape<Dim>& shape, const RunOptions& options, Notice notice, Depths depths);

    /// Writes the points that a pose (Dim × n) at a time carries. Throws InputError.
    void write(double time, const Points<Dim>& pose, OutputSet& files);

  private:
    int pointDimension() const;
    std::shared_ptr<const SimplicialMesh<Dim>> carrier() const;
    Points<Dim> carrierIn(const Points<Dim>& pose) const;
    PointMap<Dim> mapFrom(const SimplicialMesh<Dim>& mesh, const PointFile& file, double time) const;

    const Shape<Dim>& m_shape;
    const RunOptions& m_options;
    Notice m_notice;
    Depths m_depths;
    std::deque<PointFile> m_files;
    std::vector<PointMap<Dim>> m_maps;  // from the rest
};

}  // namespace wend
