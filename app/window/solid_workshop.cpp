#include "app/window/solid_workshop.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>

#include "app/base/preferences.h"
#include "app/base/said.h"
#include "app/engine/motion/places.h"
#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/facts_panel.h"
#include "app/panels/measure_panel.h"
#include "app/panels/region_list.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/opening.h"
#include "app/session/shape_session.h"
#include "app/views/volume/solid_overlay.h"
#include "app/window/actions/actions.h"
#include "app/window/export/dialogs.h"
#include "app/window/export/exporter.h"
#include "app/window/export/view_picture.h"
#include "app/window/files/taken_over.h"
#include "app/window/notices/info_banner.h"
#include "app/window/properties.h"
#include "app/window/surface/surface_check.h"
#include "app/window/workspace.h"
#include "core/base/error.h"

namespace wend {

SolidWorkshop::SolidWorkshop(const Surroundings& around, QWidget& window)
    : QObject(&window),
      m_around(around),
      m_window(window),
      m_actions(around.solids),
      m_check(new SurfaceCheck(around.session.document(), around.session.playback(), around.session.motion(),
                               around.properties.surface(), window)),
      m_detail(new DetailChooser(around.session.document(), around.banner, window)) {
    onTriggered(m_detail, m_actions.chooseDetail, &DetailChooser::ask, m_actions.removeDetail,
                &DetailChooser::remove);
    connect(m_detail, &DetailChooser::chosen, this, [this] { m_actions.detail->setChecked(true); });
    connect(&around.session.document(), &Document::projectChanged, this, &SolidWorkshop::showDomain);
    connect(&around.session.document(), &Document::opened, this, [this] {
        for (auto& [film, settings] : m_settings) settings = {settings.format};
    });
    around.properties.showCutWhile(*m_actions.cut);
}

void SolidWorkshop::setActive(bool active) {
    if (active && !m_page) makePage();
    m_isActive = active;
    m_actions.setShown(active && m_canvas);
    if (!active || !m_canvas) return;
    m_canvas->setCutKind(CutKind::None);
    m_actions.setHasDetail(m_canvas->solidLook().hasDetail());
    showCut();
}

void SolidWorkshop::takeUpTool() {
    m_check->leave();
}

void SolidWorkshop::makePage() {
    if (!VolumeView::available()) {
        auto* label =
            new QLabel(tr("Solids need OpenGL 3.3, which this system does not have. The command line (wend "
                          "run) still works with them."));
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
        m_page = label;
        return;
    }
    m_page = m_canvas = new SolidCanvas(m_around.session);
    m_check->setCanvas(m_canvas);
    connectView();
    connectNavigation();
    connectCut();
}

void SolidWorkshop::connectView() {
    Actions& common = m_around.actions;
    DistortionPanel& maps = m_around.properties.distortion();
    connectLooks(m_canvas);
    const auto zoom = [this](double factor) {
        Camera camera = m_canvas->camera();
        camera.zoom(factor, {m_canvas->width() / 2.0, m_canvas->height() / 2.0}, m_canvas->size());
        m_canvas->setCamera(camera);
    };
    onTriggered(
        m_canvas, common.fit, &VolumeView::fit, common.zoomIn, [zoom] { zoom(1.25); }, common.zoomOut,
        [zoom] { zoom(0.8); });
    connect(&m_around.session.motion(), &ShapeMotion::frameChanged, this, [this] {
        m_actions.setHasDetail(m_canvas->solidLook().hasDetail());
        showCut();
    });
    connect(&m_around.properties.detailRegions(), &RegionList::chosen, &m_canvas->overlay(),
            &SolidOverlay::setDetailRegions);
    connect(&m_around.properties.facts(), &FactsPanel::cellWanted, m_canvas, [this](int cell) {
        if (m_isActive) m_canvas->showCell(cell);
    });
    connect(&maps, &DistortionPanel::faultsChanged, m_canvas,
            [this, &maps] { m_canvas->setFaults(maps.watch().faults<3>()); });
    const auto tellMissing = [this](const QStringList& files) {
        m_around.session.document().notify(
            tr("These pictures of the surface cannot be read: %1").arg(files.join(", ")));
    };
    connect(m_canvas, &VolumeView::picturesMissing, this, tellMissing, Qt::QueuedConnection);
    connect(m_canvas, &SolidCanvas::pointedAt, &m_around.properties.measure(), &MeasurePanel::setPointed);
    connect(m_canvas, &VolumeView::cameraChanged, &m_around.exporter, &Exporter::viewTurned);
    emit viewportMade(m_canvas->viewport());
}

void SolidWorkshop::connectLooks(SolidCanvas* canvas) {
    Viewport& view = canvas->viewport();
    followLooks(view, m_around.actions, m_around.properties.distortion());
    followLook(view, m_actions.detail, &Looks::detail);
    followLook(view, m_actions.flat, &Looks::flat);
    canvas->setOrthographic(m_actions.orthographic->isChecked());
    onToggled(canvas, m_actions.orthographic, &VolumeView::setOrthographic);
}

/// Connects viewpoints and mouse navigation.
void SolidWorkshop::connectNavigation() {
    SolidActions& a = m_actions;
    using enum Camera::Axis;
    const auto look = [this](Camera::Axis axis) { return [this, axis] { m_canvas->look(axis); }; };
    onTriggered(m_canvas, a.front, look(Front), a.back, look(Back), a.right, look(Right), a.left, look(Left),
                a.top, look(Top), a.bottom, look(Bottom), a.oblique, look(Isometric));
    for (int k = 0; k < 3; ++k)
        onTriggered(this, a.upAxes[k],
                    [this, k] { changeSetting(m_around.session.document(), "view.up", k); });
    connect(m_canvas, &VolumeView::cameraChanged, this,
            [this] { m_actions.orthographic->setChecked(m_canvas->camera().orthographic()); });
    const std::array<QAction*, 3> presets = {a.wendKeys, a.vtkKeys, a.blenderKeys};
    for (int k = 0; k < 3; ++k)
        onToggled(m_canvas, presets[k], [this, k](bool on) {
            if (!on) return;
            m_canvas->navigation().setPreset(static_cast<NavigationPreset>(k));
            preferences::navigation.set(k);
        });
    presets[std::clamp(preferences::navigation.value(), 0, 2)]->setChecked(true);
    m_canvas->navigation().setPreset(static_cast<NavigationPreset>(preferences::navigation.value()));
}

void SolidWorkshop::connectCut() {
    onTriggered(this, m_actions.holdBeyond, &SolidWorkshop::holdBeyondCut);
    onToggled(m_canvas, m_actions.cut, [this](bool on) {
        m_canvas->setCutKind(on ? static_cast<CutKind>(m_lastCut) : CutKind::None);
    });
    CutPanel* panel = &m_around.properties.cut();
    connect(panel, &CutPanel::kindChosen, m_canvas, [this](int kind) {
        if (kind > 0) m_lastCut = kind;
        m_canvas->setCutKind(static_cast<CutKind>(kind));
    });
    connect(panel, &CutPanel::planeChosen, m_canvas, &SolidCanvas::setCutPlane);
    connect(m_canvas, &SolidCanvas::cutChanged, this, &SolidWorkshop::showCut);
}

void SolidWorkshop::showDomain() {
    const Document& document = m_around.session.document();
    if (document.dimension() != 3) return;
    const Domain& domain = document.domain();
    m_actions.setHasChosenDetail(!domain.detail.empty());
    m_actions.setMeshed(domain.kind == DomainKind::Surface);
    m_actions.setUpAxis(document.up());
    if (domain.kind != DomainKind::Surface && m_actions.sizes->isChecked())
        m_around.actions.pinTool->setChecked(true);
}

void SolidWorkshop::showFailure(const QString& text) {
    m_around.banner.tell(InfoBanner::Topic::Export, text);
}

void SolidWorkshop::exportView() {
    askForView({});
}

void SolidWorkshop::exportFilm() {
    const ShapeMotion& motion = m_around.session.motion();
    if (!motion.frame() || motion.isBusy() || motion.isStale())
        return showFailure(tr("The shape is still being computed. Try again in a moment."));
    const Document& document = motion.document();
    const double end = m_around.session.playback().end();
    askForView(FilmSubject{document.project(), end, document.folder().toStdString()});
}

void SolidWorkshop::askForView(const std::optional<FilmSubject>& film) {
    if (!m_canvas) return;
    PictureDialog dialog(
        m_canvas->size() * m_canvas->devicePixelRatioF(), m_canvas->viewport().showsMap(), &m_window,
        [this](const PictureChoice& choice) { return viewPicture(*m_canvas, choice); }, film);
    PictureSettings& settings = m_settings[film.has_value()];
    dialog.set(settings);
    QString path;
    while (path.isEmpty()) {
        if (dialog.exec() != QDialog::Accepted) return;
        const Document& document = m_around.session.document();
        const QString name = QFileInfo(document.displayName()).completeBaseName() + dialog.extension();
        path = askFileToWrite(&m_window, dialog.windowTitle(), QDir(proposedFolder(document)).filePath(name),
                              dialog.filter());
        if (!path.isEmpty() && !m_around.exporter.mayReplace(ExportKind::Picture, path, 0)) path.clear();
    }
    settings = dialog.settings();
    try {
        if (!writeViewPicture(path, *m_canvas, dialog.choice())) return;
        m_around.banner.clear(InfoBanner::Topic::Export);  // an export that failed before has its file now
        m_around.session.document().notify(tr("Written: %1").arg(QDir::toNativeSeparators(path)));
    } catch (const std::exception& error) {
        showFailure(tr("Nothing was written. %1").arg(said(error)));
    }
}

QImage SolidWorkshop::smallView(const QSize& size) {
    const auto frame = m_around.session.motion().frame<3>();
    if (!m_canvas || !frame) return {};
    const double ratio = m_window.devicePixelRatioF();
    QImage picture = m_plain.draw(*m_canvas, *frame, size * ratio);
    picture.setDevicePixelRatio(ratio);
    return picture;
}

void SolidWorkshop::showCut() {
    if (!m_canvas) return;
    const QSignalBlocker quiet(m_actions.cut);
    m_actions.cut->setChecked(m_canvas->solid().cut() != CutKind::None);
    CutPanel& cut = m_around.properties.cut();
    const auto frame = m_around.session.motion().frame<3>();
    if (!frame) {
        cut.showNothing();
        return;
    }
    cut.show(static_cast<int>(m_canvas->solid().cut()), m_canvas->cutTool().plane(),
             frame->pose.rowwise().minCoeff(), frame->pose.rowwise().maxCoeff());
}

void SolidWorkshop::holdBeyondCut() {
    const auto frame = m_around.session.motion().frame<3>();
    if (!frame || !m_canvas || m_canvas->solid().cut() == CutKind::None) return;
    const CutPlane& plane = m_canvas->solid().plane();
    if (frame->pose == frame->rest->points) {  // at rest it can be a region
        const Region<3> half = HalfSpace<3>{plane.point, plane.normal};
        if (!verticesInside<3>(half, *frame->rest).empty())
            m_around.session.addHandle(half, tr("Region").toStdString());
        return;
    }
    std::vector<int> beyond;
    for (Eigen::Index v = 0; v < frame->pose.cols(); ++v)
        if (plane.height(frame->pose.col(v)) > 0) beyond.push_back(static_cast<int>(v));
    if (beyond.empty()) return;
    m_around.session.addHandle(m_around.session.pins().placementOf(beyond), tr("Area").toStdString());
}

}  // namespace wend
