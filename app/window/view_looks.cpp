#include "app/window/view_looks.h"

#include "app/panels/distortion_panel.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/material_panel.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/look_choices.h"
#include "app/window/actions/watched_keys.h"
#include "app/window/compare_view.h"
#include "app/window/properties.h"
#include "app/window/solid_workshop.h"

namespace wend {

void followLooks(Viewport& view, const Actions& a, const DistortionPanel& map) {
    for (const auto& [action, look] : {std::pair{a.showMesh, &Looks::mesh},
                                       {a.showMap, &Looks::map},
                                       {a.showMarks, &Looks::marks},
                                       {a.showArrows, &Looks::arrows},
                                       {a.onionSkin, &Looks::onionSkin}})
        followLook(view, action, look);
    const auto paper = [&view](const QColor& colour) { view.set(&Looks::backdrop, colour); };
    paper(a.backdrop->colour());
    QObject::connect(a.backdrop, &BackdropChoice::changed, &view, paper);
    const auto colour = [&view, &map] {
        view.set(&Looks::colours, {map.measure(), map.range(), map.opacity(), map.isSmooth()});
    };
    colour();
    QObject::connect(&map, &DistortionPanel::opacityChanged, &view, colour);
    QObject::connect(&map, &DistortionPanel::mapChanged, &view, colour);
    QObject::connect(&map, &DistortionPanel::smoothChanged, &view, colour);
    view.setRangeKeeper(map.keepRange());
}

void followLook(Viewport& view, const QAction* action, bool Looks::*look) {
    view.set(look, action->isChecked());
    QObject::connect(action, &QAction::toggled, &view, [&view, look](bool on) { view.set(look, on); });
}

ViewLooks::ViewLooks(const Parts& parts, QWidget* window) : QObject(window), m_parts(parts) {
    followLooks(m_parts.picture.viewport(), m_parts.actions, m_parts.properties.distortion());
    connectComparison();
    connectHiding(*window);
}

/// A comparison starts by a tile dragged to the shape, or by the action; hovering a tile previews it.
void ViewLooks::connectComparison() {
    EnergySlider& tiles = *m_parts.properties.material().energySlider();
    CompareView& compared = m_parts.compared;
    const Actions& a = m_parts.actions;
    followLooks(compared.picture().viewport(), a, m_parts.properties.distortion());
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
}

/// Connects hiding of overlays and showing the rest shape, by switches or by held keys.
void ViewLooks::connectHiding(QWidget& window) {
    const Actions& a = m_parts.actions;
    auto* bare = new HeldKey(Qt::Key_H, window);
    auto* before = new HeldKey(Qt::Key_Backslash, window);
    const auto show = [this, &a, bare, before] {
        const bool rest = a.showRest->isChecked() || before->isHeld();
        const bool hidden = rest || a.hideOverlays->isChecked() || bare->isHeld();
        std::vector<Viewport*> views = {&m_parts.picture.viewport(), &m_parts.compared.picture().viewport()};
        for (SolidCanvas* solid : {m_parts.solids.canvas(), m_parts.compared.solid()})
            if (solid) views.push_back(&solid->viewport());
        for (Viewport* view : views) {
            view->set(&Looks::hidden, hidden);
            view->set(&Looks::rest, rest);
        }
    };
    for (const QAction* action : {a.hideOverlays, a.showRest}) connect(action, &QAction::toggled, this, show);
    for (const HeldKey* key : {bare, before}) connect(key, &HeldKey::heldChanged, this, show);
}

}  // namespace wend
