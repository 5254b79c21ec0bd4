#include "app/tools/brush_paint.h"

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "app/session/accent.h"
#include "app/session/energy_stops.h"
#include "app/session/material_raster.h"

namespace wend {

namespace {

QString said(const char* text) {
    return QCoreApplication::translate("PaintTool", text);
}

QString stopName(double phi, int dimension) {
    constexpr std::array<const char*, kEnergyStops> kNames = {
        QT_TRANSLATE_NOOP("PaintTool", "Area"), QT_TRANSLATE_NOOP("PaintTool", "Length"),
        QT_TRANSLATE_NOOP("PaintTool", "Rigid"), QT_TRANSLATE_NOOP("PaintTool", "Angle")};
    const double stop = stopOfPhi(phi, dimension);
    const int nearest = static_cast<int>(std::lround(stop));
    if (std::abs(stop - nearest) > 0.02) return said(QT_TRANSLATE_NOOP("PaintTool", "Keep"));
    return nearest == 0 && dimension == 3 ? said(QT_TRANSLATE_NOOP("PaintTool", "Volume"))
                                          : said(kNames[nearest]);
}

}  // namespace

template <int Dim>
MaterialPaint<Dim> paintOf(const BrushSettings& brush, const Vec<Dim>& along) {
    MaterialPaint<Dim> paint;
    if (brush.target == BrushTarget::Keep) {
        paint.phi = brush.phi;
        return paint;
    }
    Vec<Dim> axis = brush.axis.template head<Dim>();
    if (brush.along != StiffAlong::Axis && !along.isZero()) axis = along;
    if (axis.isZero()) axis = Vec<Dim>::UnitX();
    paint.stiffness = Stiffness<Dim>{axis.normalized(), brush.ratio};
    return paint;
}

template <int Dim>
void pickMaterial(const PosedFrame<Dim>& frame, int cell, Brush& brush) {
    BrushSettings next = brush.now();
    next.phi = frame.material->phi[cell];
    next.ratio = 1;
    if (!frame.material->anisotropy.empty()) {
        const Stiffness<Dim> stiffness = stiffnessOf<Dim>(frame.material->anisotropy[cell]);
        next.ratio = std::max(1.0, stiffness.ratio);
        next.axis.setZero();
        next.axis.template head<Dim>() = stiffness.axis;
    }
    brush.set(next);
}

QString brushKind(const BrushSettings& brush, int dimension) {
    if (brush.target == BrushTarget::Keep) return stopName(brush.phi, dimension);
    return brush.target == BrushTarget::Stiffness ? said(QT_TRANSLATE_NOOP("PaintTool", "Stiff"))
                                                  : said(QT_TRANSLATE_NOOP("PaintTool", "Combed"));
}

QRgb brushColour(const BrushSettings& brush, int dimension) {
    return brush.target == BrushTarget::Keep ? energyColour(stopOfPhi(brush.phi, dimension)) : kStiffColour;
}

QString shortName(const QString& fileName) {
    return fileName.section('.', 0, 0);
}

template MaterialPaint<2> paintOf<2>(const BrushSettings&, const Vec<2>&);
template MaterialPaint<3> paintOf<3>(const BrushSettings&, const Vec<3>&);
template void pickMaterial<2>(const PosedFrame<2>&, int, Brush&);
template void pickMaterial<3>(const PosedFrame<3>&, int, Brush&);

}  // namespace wend
