#include "app/tools/paint/brush_paint.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <array>
#include <cmath>

#include "app/project/edits/free_name.h"
#include "app/style/colours.h"

namespace wend {

namespace {

constexpr double kSameValue = 1e-9;
constexpr double kNear = 0.25;  // of the shape's size

QString stopName(double phi, int dimension) {
    constexpr std::array<const char*, kEnergyStops> kNames = {
        QT_TRANSLATE_NOOP("PaintTool", "Area"), QT_TRANSLATE_NOOP("PaintTool", "Length"),
        QT_TRANSLATE_NOOP("PaintTool", "Rigid"), QT_TRANSLATE_NOOP("PaintTool", "Angle")};
    const double stop = stopOfPhi(phi, dimension);
    const int nearest = static_cast<int>(std::lround(stop));
    if (std::abs(stop - nearest) > 0.02) return QCoreApplication::translate("PaintTool", "Keep");
    return nearest == 0 && dimension == 3 ? QCoreApplication::translate("PaintTool", "Volume")
                                          : QCoreApplication::translate("PaintTool", kNames[nearest]);
}

}  // namespace

Vec3 axisOf(const BrushSettings& brush, int dimension) {
    return dimension == 2 ? inSpace(inPlane(brush.axis)) : brush.axis;
}

MaterialPaint paintOf(const BrushSettings& brush, int dimension, const Vec3& along) {
    MaterialPaint paint;
    if (brush.target == BrushTarget::Keep) {
        paint.phi = brush.phi;
        return paint;
    }
    Vec3 axis = axisOf(brush, dimension);
    if (brush.along != StiffAlong::Axis && !along.isZero()) axis = along;
    if (axis.isZero()) axis = Vec3::UnitX();
    paint.stiffness = Stiffness{axis.normalized(), brush.ratio};
    return paint;
}

void pickMaterial(const EditedMaterial& material, int cell, Brush& brush) {
    BrushSettings next = brush.now();
    next.phi = material.phiOf(cell);
    next.ratio = 1;
    if (const auto stiffness = material.stiffnessOf(cell)) {
        next.ratio = std::max(1.0, stiffness->ratio);
        next.axis = stiffness->axis;
    }
    brush.set(next);
}

QString brushKind(const BrushSettings& brush, int dimension) {
    if (brush.target == BrushTarget::Keep) return stopName(brush.phi, dimension);
    return brush.target == BrushTarget::Stiffness ? QCoreApplication::translate("PaintTool", "Stiff")
                                                  : QCoreApplication::translate("PaintTool", "Combed");
}

QRgb brushColour(const BrushSettings& brush, int dimension) {
    return brush.target == BrushTarget::Keep ? energyColour(stopOfPhi(brush.phi, dimension)) : kStiffColour;
}

std::string brushAim(const BrushSettings& brush) {
    if (brush.target == BrushTarget::Keep) return "keep " + std::to_string(brush.phi);
    return (brush.target == BrushTarget::Stiffness ? "stiff " : "comb ") + std::to_string(brush.ratio);
}

namespace {

bool hasPaintOf(const MaterialRegion& region, const BrushSettings& brush) {
    if (region.pictures.any() || std::holds_alternative<Blend<3>>(region.shape)) return false;
    if (brush.target == BrushTarget::Keep)
        return region.phi && !region.stiffness && std::abs(*region.phi - brush.phi) < kSameValue;
    return region.stiffness && !region.phi &&
           std::abs(region.stiffness->ratio / brush.ratio - 1) < kSameValue;
}

/// Returns whether a layer takes paint. Hidden layers do not, because the paint would be invisible.
bool takes(const MaterialLayer& layer, const BrushSettings& brush, const ChosenLayer& chosen,
           const std::string& aim) {
    if (layer.name.empty() || layer.isHidden()) return false;
    if (layer.id == chosen.id && !chosen.aim.empty()) return chosen.aim == aim;
    bool any = false, all = aim == brushAim(brush);
    for (const MaterialRegion& region : layer.regions) {
        if (region.erases()) continue;
        any = true;
        all = all && hasPaintOf(region, brush);
    }
    return any && all;
}

}  // namespace

PaintedLayer layerFor(const Design& design, const BrushSettings& brush, const ChosenLayer& chosen,
                      const std::string& aim, const std::string& kind) {
    const std::vector<MaterialLayer>& layers = design.material.layers;
    const MaterialLayer* topmost = layers.empty() ? nullptr : &layers.back();
    for (const MaterialLayer* layer : {layerOf(layers, chosen.id), topmost})
        if (layer && takes(*layer, brush, chosen, aim)) return {layer->id, layer->name};
    return {.name = freeName(namesOf(layers), kind)};
}

QString placeName(const ShapeMotion& motion, const ShownPins& pins, const Vec3& place,
                  const std::string& layer) {
    static const QRegularExpression numbered(QStringLiteral(" \\d+$"));
    const QString own = QString::fromStdString(layer);
    if (!own.isEmpty() && !own.contains(numbered)) return own;
    const FramePtr frame = motion.frame();
    if (!frame) return {};
    const auto& handles = motion.document().design().handles;
    QString nearest;
    double reach = kNear * frame->diagonal;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const auto starts = pins.pathStarts(static_cast<int>(i));
        if (starts.empty()) continue;
        const double far = (meanOf(starts) - place).norm();
        if (far < reach) reach = far, nearest = QString::fromStdString(handles[i].name);
    }
    return nearest;
}

bool paintsNothing(const BrushSettings& brush) {
    return brush.target != BrushTarget::Keep && brush.ratio == 1;
}

QString nothingToPaint() {
    return QCoreApplication::translate(
        "PaintTool",
        "Stiffness ×1 is the same as everywhere and changes nothing: choose on the "
        "right how many times stiffer it should be");
}

std::optional<Measure> paintedMap(const Workbench& on, int) {
    return on.brush->now().target == BrushTarget::Keep ? Measure::Phi : Measure::Stiffness;
}

}  // namespace wend
