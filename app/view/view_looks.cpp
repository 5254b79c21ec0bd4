#include "app/view/view_looks.h"

#include <QCursor>
#include <algorithm>

#include "app/panels/distortion_panel.h"
#include "app/panels/energy_slider.h"
#include "app/panels/liveliness.h"
#include "app/panels/material_panel.h"
#include "app/view/actions.h"
#include "app/view/backdrop_choice.h"
#include "app/view/canvas.h"
#include "app/view/compare_view.h"
#include "app/view/held_key.h"
#include "app/view/properties.h"
#include "app/view/solid_workshop.h"
#include "app/view/tile_pictures.h"
#include "app/view/volume/solid_canvas.h"

namespace wend {
namespace {

constexpr double kFullLean = 200;  // pixels of a drag

}  // namespace

ViewLooks::ViewLooks(const Parts& parts, QWidget* window) : QObject(window), m_parts(parts) {
    connectLooks(m_parts.picture);
    connectComparison();
    connectHiding(*window);
}

void ViewLooks::connectLooks(ShapeCanvas& canvas) {
    const Actions& a = m_parts.actions;
    connect(a.showMesh, &QAction::toggled, &canvas, &ShapeCanvas::setMeshShown);
    connect(a.showMap, &QAction::toggled, &canvas, &ShapeCanvas::setMapShown);
    connect(a.showMarks, &QAction::toggled, &canvas, &ShapeCanvas::setMarksShown);
    connect(a.showArrows, &QAction::toggled, &canvas, &ShapeCanvas::setArrowsShown);
    connect(a.onionSkin, &QAction::toggled, &canvas, &ShapeCanvas::setOnionSkin);
    connect(a.backdrop, &BackdropChoice::changed, &canvas, &ShapeCanvas::setBackdrop);
    canvas.setBackdrop(a.backdrop->colour());
    const DistortionPanel* map = &m_parts.properties.distortion();
    connect(map, &DistortionPanel::mapChanged, &canvas,
            [&canvas, map] { canvas.setMap(map->measure(), map->range()); });
    canvas.setRangeKeeper(map->keepRange());
    connect(map, &DistortionPanel::opacityChanged, &canvas, &ShapeCanvas::setMapOpacity);
    canvas.setMapOpacity(map->opacity());
    connect(map, &DistortionPanel::smoothChanged, &canvas, &ShapeCanvas::setMapSmooth);
    canvas.setMapSmooth(map->isSmooth());
}

/// By a tile that is dragged to the shape, or with the energy beside the one that is chosen; the pointer on a
/// tile is enough for a look.
void ViewLooks::connectComparison() {
    EnergySlider& tiles = *m_parts.properties.material().energySlider();
    CompareView& compared = m_parts.compared;
    const Actions& a = m_parts.actions;
    connectLooks(compared.picture());
    connect(&compared, &CompareView::solidMade, &m_parts.solids, &SolidWorkshop::connectLooks);
    connect(&tiles, &EnergySlider::hovered, &compared, &CompareView::preview);
    connect(&compared, &CompareView::splitChanged, a.compare, &QAction::setChecked);
    connect(a.compare, &QAction::toggled, this, [&compared, &tiles](bool on) {
        if (!on) return compared.join();
        const auto& stops = tiles.scale().stops();
        if (!compared.isSplit()) compared.split(stops[tiles.scale().stopAt(tiles.phi()) == 1 ? 3 : 1].phi);
    });
    new TilePictures(
        m_parts.session, m_parts.picture, [this] { return m_parts.solids.canvas(); }, tiles);
    connectLeaning(tiles);
}

/// The pictures of the energies lean to where the shape is pulled.
void ViewLooks::connectLeaning(EnergySlider& tiles) {
    ShapeSession& session = m_parts.session;
    connect(&session, &ShapeSession::dragBegan, this, [this] { m_pulledFrom = QCursor::pos().x(); });
    connect(&session, &ShapeSession::dragMoved, this, [this, &tiles] {
        if (isLively()) tiles.setLean(std::clamp((QCursor::pos().x() - m_pulledFrom) / kFullLean, -1.0, 1.0));
    });
    for (const auto end : {&ShapeSession::dragEnded, &ShapeSession::dragCancelled})
        connect(&session, end, this, [&tiles] { tiles.setLean(0); });
}

/// Pins and maps hide for good or while a key is held; so the shape is seen as it was before, without them.
void ViewLooks::connectHiding(QWidget& window) {
    const Actions& a = m_parts.actions;
    auto* bare = new HeldKey(Qt::Key_H, window);
    auto* before = new HeldKey(Qt::Key_Backslash, window);
    const auto show = [this, &a, bare, before] {
        const bool rest = a.showRest->isChecked() || before->isHeld();
        const bool hidden = rest || a.hideOverlays->isChecked() || bare->isHeld();
        for (ShapeCanvas* canvas : {&m_parts.picture, &m_parts.compared.picture()}) {
            canvas->setOverlaysHidden(hidden);
            canvas->setRestShown(rest);
        }
        for (SolidCanvas* solid : {m_parts.solids.canvas(), m_parts.compared.solid()}) {
            if (!solid) continue;
            solid->setOverlaysHidden(hidden);
            solid->setRestShown(rest);
        }
    };
    for (const QAction* action : {a.hideOverlays, a.showRest}) connect(action, &QAction::toggled, this, show);
    for (const HeldKey* key : {bare, before}) connect(key, &HeldKey::heldChanged, this, show);
}

}  // namespace wend
