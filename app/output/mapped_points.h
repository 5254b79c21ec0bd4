#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/engine/shape/shape.h"
#include "app/output/output_set.h"
#include "app/output/point_file.h"
#include "app/output/run_options.h"
#include "core/base/message.h"

namespace wend {

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
