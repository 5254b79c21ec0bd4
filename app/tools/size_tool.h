#pragma once

#include "app/tools/stroke_tool.h"

namespace wend {

/// Paints how fine the mesh is: a stroke makes edges under it longer or shorter by a factor, with Ctrl as
/// elsewhere again, with Shift the other way round. Shows the mesh of a picture, whose finer and coarser
/// places are circled, or of a solid the regions that the panel has chosen.
template <int Dim>
class SizeTool : public StrokeTool<Dim> {
  public:
    SizeTool(SurfaceOf<Dim>& view, Brush& brush, std::function<double()> factor)
        : StrokeTool<Dim>(view, brush), m_factor(std::move(factor)) {}

    void setShown(const std::vector<Region<Dim>>& regions) { m_shown = regions; }

    void paint(QPainter& painter) const override;

  protected:
    using typename StrokeTool<Dim>::Dab;
    QString strokeHint() const override;
    void take(const std::vector<Dab>& dabs) override;
    QColor colour() const override { return QColor(0x2a, 0x8a, 0x7a); }

  private:
    using StrokeTool<Dim>::modifiers;
    using StrokeTool<Dim>::session;
    using StrokeTool<Dim>::surface;
    double factor() const;

    std::function<double()> m_factor;
    std::vector<Region<Dim>> m_shown;
};

extern template class SizeTool<2>;
extern template class SizeTool<3>;

}  // namespace wend
