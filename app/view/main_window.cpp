#include "app/view/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/panels/distortion_panel.h"
#include "app/panels/layer_panel.h"
#include "app/panels/material_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/panel_fields.h"
#include "app/panels/pin_list.h"
#include "app/session/settle_step.h"
#include "app/view/actions.h"
#include "app/view/busy_note.h"
#include "app/view/canvas.h"
#include "app/view/compare_view.h"
#include "app/view/context_menu.h"
#include "app/view/curve_actions.h"
#include "app/view/depth_actions.h"
#include "app/view/exporter.h"
#include "app/view/file_workflow.h"
#include "app/view/held_key.h"
#include "app/view/info_banner.h"
#include "app/view/material_actions.h"
#include "app/view/mode_row.h"
#include "app/view/option_row.h"
#include "app/view/picture_actions.h"
#include "app/view/pin_actions.h"
#include "app/view/properties.h"
#include "app/view/shape_notices.h"
#include "app/view/side_windows.h"
#include "app/view/solid_workshop.h"
#include "app/view/start_page.h"
#include "app/view/status_fields.h"
#include "app/view/tile_pictures.h"
#include "app/view/time_strip.h"
#include "app/view/toolbox.h"
#include "app/view/track_view.h"
#include "app/view/tutorial.h"
#include "app/view/volume/solid_canvas.h"
#include "app/view/work_note.h"
#include "app/view/workspace.h"

namespace wend {

namespace {

using Topic = InfoBanner::Topic;

constexpr int kTold = 10000;  // milliseconds

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_tools(new Toolbox(this)),
      m_actions(new Actions(*m_session.document().undoStack(), *m_tools, this)),
      m_solidActions(new SolidActions(*m_tools, this)),
      m_depth(new DepthActions(m_session, this)),
      m_pins(new PinActions(m_session, this)),
      m_properties(new Properties(m_session, *m_tools, *m_actions)),
      m_pictureActions(new PictureActions(m_properties->brush(), this)),
      m_files(new FileWorkflow(m_session.document(), *this)),
      m_exporter(new Exporter(m_session, *this)),
      m_canvas(new ShapeCanvas(m_session)),
      m_start(new StartPage),
      m_banner(new InfoBanner),
      m_time(new TimeStrip(m_session)),
      m_tracks(new TrackView(m_session)),
      m_pages(new QStackedWidget),
      m_note(new BusyNote(*m_pages)),
      m_work(new WorkNote(m_session, *m_pages)),
      m_tutorial(new Tutorial({m_session, *m_actions, *m_tools}, *m_pages)),
      m_systemPalette(QApplication::palette()) {
    setAcceptDrops(true);
    setWindowTitle(QStringLiteral("Wend[*]"));
    fitToScreen();
    m_fields = new StatusFields(*statusBar(), m_session);
    m_solids = new SolidWorkshop({m_session, *m_actions, *m_solidActions, *m_properties, *m_fields}, *this);
    m_workspace = std::make_unique<Workspace>(
        Workspace::Parts{*m_tools, *m_actions, *m_canvas, *m_solids, *m_properties, *m_pictureActions});
    m_curves = new CurveActions(
        m_session, [this] { return m_workspace->curve(); }, this);
    m_material = new MaterialActions(m_session, *m_exporter, this);
    m_properties->layers().setPictureMenu(m_material->menu());
    m_tools->shareKeysWith({m_solidActions, m_curves, m_depth, m_pins, m_material, m_actions});
    m_menu = new ContextMenu({m_session, *m_actions, *m_curves, *m_solidActions, *m_depth, *m_pins}, this);
    m_actions->fillMenuBar(*this, m_solidActions->menu(), m_curves->menu(),
                           {m_pins->menu(), m_depth->menu(), m_material->menu()});
    makeToolBars();
    makeCentre();
    connectFiles();
    connectEdit();
    connectView();
    connectComparison();
    connectMotion();
    connectHelp();
    setAppearance(static_cast<Appearance>(QSettings().value("appearance", 0).toInt()));
    showDocument();
}

/// The first size: what is comfortable, but no more than the screen has, with room for the frame.
void MainWindow::fitToScreen() {
    constexpr QSize kComfortable(1280, 860), kFrame(8, 40);
    resize(kComfortable.boundedTo(screen()->availableSize() - kFrame));
}

MainWindow::~MainWindow() = default;

MaterialPanel& MainWindow::materialPanel() {
    return m_properties->material();
}

DistortionPanel& MainWindow::distortionPanel() {
    return m_properties->distortion();
}

QToolBar* MainWindow::makeBar(Qt::ToolBarArea area, const QString& title, const char* name) {
    auto* bar = new QToolBar(title, this);
    bar->setObjectName(QString::fromLatin1(name));
    bar->setMovable(false);
    bar->setIconSize({22, 22});
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    addToolBar(area, bar);
    return bar;
}

void MainWindow::makeToolBars() {
    m_topBar = makeBar(Qt::TopToolBarArea, tr("Main"), "topBar");
    m_topBar->addWidget(m_modes = new ModeRow(*m_actions, *m_tools));
    addToolBarBreak();
    addToolBar(Qt::TopToolBarArea,
               m_options = new OptionRow(*m_tools, *m_actions, *m_solidActions, *m_pictureActions, this));
    m_toolBar = makeBar(Qt::LeftToolBarArea, tr("Tools"), "toolBar");
    connect(m_tools, &Toolbox::changed, this, &MainWindow::showTools);
    showTools();
    setContextMenuPolicy(Qt::NoContextMenu);
}

/// In the step that is about time.
void MainWindow::showTracks() {
    m_tracks->setVisible(!m_session.document().isEmpty() && m_tools->mode() == Mode::Animate);
}

/// Those of the current step.
void MainWindow::showTools() {
    const QList<QAction*> tools = m_tools->toolsOf(m_tools->mode());
    if (m_toolBar->actions() == tools) return;
    m_toolBar->clear();
    m_toolBar->addActions(tools);
}

void MainWindow::makeCentre() {
    const auto toView = [this] { m_pages->currentWidget()->setFocus(); };
    connect(m_properties, &Properties::done, this, toView);
    connect(new PanelFields(*m_time), &PanelFields::done, this, toView);
    auto* centre = new QWidget(this);
    auto* row = new QHBoxLayout(centre);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    column->addWidget(m_banner);
    m_pages->addWidget(m_start);
    m_pages->addWidget(m_canvas);
    m_compare = new CompareView({m_session, *m_pages, *m_canvas, [this] { return m_solids->canvas(); }});
    auto* parts = new QSplitter(Qt::Vertical);
    parts->setChildrenCollapsible(false);
    parts->addWidget(m_compare);
    parts->addWidget(m_tracks);
    parts->setStretchFactor(0, 1);
    column->addWidget(parts, 1);
    column->addWidget(m_time);
    row->addLayout(column, 1);
    row->addWidget(m_properties);
    setCentralWidget(centre);
}

void MainWindow::connectFiles() {
    Actions& a = *m_actions;
    const auto tellIn = [this](Topic topic) {
        return [this, topic](const QString& text) { m_banner->tell(topic, text); };
    };
    connect(a.open, &QAction::triggered, m_files, &FileWorkflow::askOpen);
    connect(a.save, &QAction::triggered, m_files, &FileWorkflow::save);
    connect(a.saveAs, &QAction::triggered, m_files, &FileWorkflow::saveAs);
    connect(a.closeFile, &QAction::triggered, m_files, &FileWorkflow::close);
    connect(a.quit, &QAction::triggered, this, &QWidget::close);
    connect(a.exportPicture, &QAction::triggered, m_exporter, &Exporter::exportPicture);
    connect(a.exportView, &QAction::triggered, m_solids, &SolidWorkshop::exportView);
    m_exporter->setSolidView([this](const QSize& size) { return m_solids->smallView(size); });
    m_solids->setMayReplace(
        [this](const QString& path) { return m_exporter->mayReplace(ExportKind::Picture, path, 0); });
    connect(m_solids, &SolidWorkshop::failed, this, tellIn(Topic::Export));
    connect(new ShapeNotices(m_session, this), &ShapeNotices::told, this, tellIn(Topic::Mesh));
    connect(m_solids, &SolidWorkshop::done, this, &MainWindow::tellDone);
    const MeshPanel* mesh = &m_properties->mesh();
    connect(mesh, &MeshPanel::detailWanted, m_solidActions->chooseDetail, &QAction::trigger);
    connect(mesh, &MeshPanel::sizesWanted, m_solidActions->sizes, &QAction::trigger);
    connect(mesh, &MeshPanel::detailRemoved, m_solidActions->removeDetail, &QAction::trigger);
    connect(a.exportMesh, &QAction::triggered, m_exporter, &Exporter::exportMesh);
    connect(a.exportFrames, &QAction::triggered, m_exporter, &Exporter::exportFrames);
    connect(a.exportStMap, &QAction::triggered, m_exporter, &Exporter::exportStMap);
    connect(m_exporter, &Exporter::failed, this, tellIn(Topic::Export));
    connect(m_exporter, &Exporter::begun, this, [this] { m_banner->clear(Topic::Export); });
    connect(m_exporter, &Exporter::done, this, &MainWindow::tellDone);
    connect(m_material, &MaterialActions::failed, this, tellIn(Topic::Export));
    connect(m_material, &MaterialActions::done, this, &MainWindow::tell);
    connect(m_start, &StartPage::openRequested, m_files, &FileWorkflow::askOpen);
    connect(m_start, &StartPage::fileChosen, m_files, &FileWorkflow::open);
    connect(m_files, &FileWorkflow::said, m_banner, &InfoBanner::tell);
    connect(&m_session.document(), &Document::opened, m_banner, qOverload<>(&InfoBanner::clear));
    connect(m_files, &FileWorkflow::openingChanged, this, [this](const QString& name) {
        m_opening = name;
        showWork();
    });
    const auto showRecent = [this] {
        m_files->fillRecent(*m_actions->recent);
        m_start->setRecent(m_files->recent());
    };
    connect(m_files, &FileWorkflow::recentChanged, this, showRecent);
    showRecent();
    m_files->fillSamples(*a.samples);
    connect(&m_session.document(), &Document::opened, this, &MainWindow::showDocument);
    connect(&m_session.document(), &Document::titleChanged, this, &MainWindow::showTitle);
    connect(&m_session, &ShapeSession::problem, this, tellIn(Topic::Shape));
    connect(&m_session, &ShapeSession::notice, this, &MainWindow::tell);
}

void MainWindow::connectEdit() {
    Actions& a = *m_actions;
    connect(a.remove, &QAction::triggered, &m_session, &ShapeSession::removeSelected);
    connect(a.selectNone, &QAction::triggered, &m_session.selection(), &Selection::clear);
    connect(a.selectAll, &QAction::triggered, this, [this] {
        std::vector<int> all;
        for (const auto& pin : m_session.pins<2>()) all.push_back(pin.handle);
        for (const auto& pin : m_session.pins<3>()) all.push_back(pin.handle);
        m_session.selection().set(std::move(all));
    });
    connect(&m_session.selection(), &Selection::changed, this, &MainWindow::showSelection);
    connect(&m_properties->pins(), &PinList::menuWanted, this,
            [this](const QPoint& at) { m_menu->popUp(at, MenuPlace::Pin); });
}

void MainWindow::connectView() {
    Actions& a = *m_actions;
    connectLooks(*m_canvas);
    connect(&m_properties->layers(), &LayerPanel::chosen, m_canvas, &ShapeCanvas::setLayer);
    connectHiding();
    connect(a.fit, &QAction::triggered, m_canvas, &ShapeCanvas::fit);
    connect(a.actualSize, &QAction::triggered, this,
            [this] { m_canvas->zoomTo(1 / m_canvas->devicePixelRatioF()); });
    connect(a.zoomIn, &QAction::triggered, this, [this] { m_canvas->zoomBy(1.25); });
    connect(a.zoomOut, &QAction::triggered, this, [this] { m_canvas->zoomBy(0.8); });
    connect(a.fullScreen, &QAction::toggled, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
    connect(a.systemLook, &QAction::triggered, this, [this] { setAppearance(Appearance::System); });
    connect(a.lightLook, &QAction::triggered, this, [this] { setAppearance(Appearance::Light); });
    connect(a.darkLook, &QAction::triggered, this, [this] { setAppearance(Appearance::Dark); });
    const DistortionPanel* distortion = &m_properties->distortion();
    connect(distortion, &DistortionPanel::mapChanged, this,
            [this, distortion] { m_fields->setMeasure(distortion->measure()); });
    connect(distortion, &DistortionPanel::mapChosen, this, [this] { m_actions->showMap->setChecked(true); });
    connect(distortion, &DistortionPanel::showWorst, this, [this] {
        m_actions->showMap->setChecked(true);
        m_canvas->showWorst();
    });
    connect(m_canvas, &ShapeCanvas::hintChanged, m_fields, &StatusFields::setHint);
    connect(m_canvas, &ShapeCanvas::hintChanged, m_curves, &CurveActions::refresh);
    connect(m_canvas, &ShapeCanvas::menuWanted, m_menu, &ContextMenu::popUp);
    connect(m_solids, &SolidWorkshop::hintChanged, m_curves, &CurveActions::refresh);
    connect(m_solids, &SolidWorkshop::menuWanted, m_menu, &ContextMenu::popUp);
    connect(m_canvas, &ShapeCanvas::pointed, m_fields, &StatusFields::setPointer);
}

/// What is seen of the shape, in one canvas or in both halves.
void MainWindow::connectLooks(ShapeCanvas& canvas) {
    const Actions& a = *m_actions;
    connect(a.showMesh, &QAction::toggled, &canvas, &ShapeCanvas::setMeshShown);
    connect(a.showMap, &QAction::toggled, &canvas, &ShapeCanvas::setMapShown);
    connect(a.showMarks, &QAction::toggled, &canvas, &ShapeCanvas::setMarksShown);
    connect(a.showArrows, &QAction::toggled, &canvas, &ShapeCanvas::setArrowsShown);
    connect(a.onionSkin, &QAction::toggled, &canvas, &ShapeCanvas::setOnionSkin);
    const DistortionPanel* map = &m_properties->distortion();
    connect(map, &DistortionPanel::mapChanged, &canvas,
            [&canvas, map] { canvas.setMap(map->measure(), map->range()); });
    connect(map, &DistortionPanel::opacityChanged, &canvas, &ShapeCanvas::setMapOpacity);
    canvas.setMapOpacity(map->opacity());
}

/// By a tile that is dragged to the shape, or with the energy beside the one that is chosen; the pointer on a
/// tile is enough for a look.
void MainWindow::connectComparison() {
    EnergySlider& tiles = *m_properties->material().energySlider();
    connectLooks(m_compare->picture());
    connect(m_compare, &CompareView::solidMade, m_solids, &SolidWorkshop::connectLooks);
    connect(&tiles, &EnergySlider::hovered, m_compare, &CompareView::preview);
    connect(m_compare, &CompareView::splitChanged, m_actions->compare, &QAction::setChecked);
    connect(m_actions->compare, &QAction::toggled, this, [this, &tiles](bool on) {
        if (!on) return m_compare->join();
        const auto& stops = tiles.scale().stops();
        if (!m_compare->isSplit())
            m_compare->split(stops[tiles.scale().stopAt(tiles.phi()) == 1 ? 3 : 1].phi);
    });
    new TilePictures(m_session, *m_canvas, tiles);
}

/// Pins and maps hide for good or while a key is held; so the shape is seen as it was before, without them.
void MainWindow::connectHiding() {
    auto* bare = new HeldKey(Qt::Key_H, *this);
    auto* before = new HeldKey(Qt::Key_Backslash, *this);
    const auto show = [this, bare, before] {
        const bool rest = m_actions->showRest->isChecked() || before->isHeld();
        const bool hidden = rest || m_actions->hideOverlays->isChecked() || bare->isHeld();
        for (ShapeCanvas* canvas : {m_canvas, &m_compare->picture()}) {
            canvas->setOverlaysHidden(hidden);
            canvas->setRestShown(rest);
        }
        for (SolidCanvas* solid : {m_solids->canvas(), m_compare->solid()}) {
            if (!solid) continue;
            solid->setOverlaysHidden(hidden);
            solid->setRestShown(rest);
        }
    };
    for (const QAction* action : {m_actions->hideOverlays, m_actions->showRest})
        connect(action, &QAction::toggled, this, show);
    for (const HeldKey* key : {bare, before}) connect(key, &HeldKey::heldChanged, this, show);
}

void MainWindow::connectMotion() {
    Actions& a = *m_actions;
    Playback& playback = m_session.playback();
    m_time->playButton()->setDefaultAction(a.play);
    m_time->loopButton()->setDefaultAction(a.loop);
    connect(a.play, &QAction::triggered, &playback,
            [&playback] { playback.setPlaying(!playback.isPlaying()); });
    connect(a.loop, &QAction::toggled, &playback, &Playback::setLoops);
    connect(a.record, &QAction::toggled, &m_session, &ShapeSession::setRecording);
    connect(a.speed.get(), &QMenu::triggered, this, [this, &playback](const QAction* chosen) {
        playback.setSpeed(chosen->data().toDouble());
        m_actions->setSpeed(playback.speed());
    });
    connect(m_tools, &Toolbox::changed, this, &MainWindow::showTracks);
    connect(a.toStart, &QAction::triggered, &playback, [&playback] { playback.setTime(0); });
    connect(a.settle, &QAction::triggered, this, [this] { settleAtEnd(m_session); });
    connect(a.toEnd, &QAction::triggered, &playback, [&playback] { playback.setTime(playback.end()); });
    connect(&playback, &Playback::playingChanged, this, [this](bool playing) {
        m_actions->play->setIcon(
            wendIcon(playing ? QStringLiteral("pause") : QStringLiteral("play"), palette()));
        m_actions->play->setText(playing ? tr("&Pause") : tr("&Play"));
    });
    connect(&playback, &Playback::endChanged, this, &MainWindow::showSelection);
}

void MainWindow::connectHelp() {
    new SideWindows(m_session, *m_actions, *this);
    connect(m_start, &StartPage::tutorialRequested, m_actions->tutorial, &QAction::trigger);
    connect(m_actions->tutorial, &QAction::triggered, this, [this] {
        m_tutorial->begin();
        m_files->open(Tutorial::picture());
    });
}

void MainWindow::openPath(const QString& path) {
    m_files->open(path);
}

void MainWindow::showDocument() {
    const bool has = !m_session.document().isEmpty();
    const bool solid = m_session.document().dimension() == 3;
    m_actions->resetView();
    m_solidActions->resetView();
    m_solids->setActive(solid);
    if (solid && m_pages->indexOf(m_solids->page()) < 0) addSolidPage();
    QWidget* shape = solid ? m_solids->page() : m_canvas;
    m_pages->setCurrentWidget(has ? shape : m_start);
    m_tools->setDimension(has && (!solid || m_solids->canvas()) ? m_session.document().dimension() : 0);
    m_solids->showDomain();
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_properties, m_time, m_toolBar, m_topBar, m_options})
        widget->setVisible(has);
    showTracks();
    if (has) shape->setFocus();
    m_fields->setVisible(has);
    m_toldUntil.setRemainingTime(0);
    showSelection();
    showTitle();
}

/// With OpenGL in it the window is made anew, by Qt: it says where it is, so that it is not placed afresh.
void MainWindow::addSolidPage() {
    setAttribute(Qt::WA_Moved);
    m_pages->addWidget(m_solids->page());
}

/// A file that is being read; what is computed then is told by the work note.
void MainWindow::showWork() {
    m_note->showText(m_opening.isEmpty() ? QString() : tr("Opening %1 …").arg(m_opening));
}

/// An export that failed before has its file now.
void MainWindow::tellDone(const QString& text) {
    m_banner->clear(Topic::Export);
    tell(text);
}

void MainWindow::tell(const QString& text) {
    m_told = text;
    m_toldUntil.setRemainingTime(kTold);
    statusBar()->showMessage(text, kTold);
}

/// Hints of buttons and fields come and go. When the pointer leaves one, what was told comes back; so it does
/// when the hint is the one that stood there before, of the button that was pressed.
bool MainWindow::event(QEvent* event) {
    if (event->type() != QEvent::StatusTip) return QMainWindow::event(event);
    const QString hint = static_cast<QStatusTipEvent*>(event)->tip();
    const bool told = (hint.isEmpty() || hint == m_hint) && !m_toldUntil.hasExpired();
    if (!hint.isEmpty()) m_hint = hint;
    statusBar()->showMessage(told ? m_told : m_fields->fitting(hint),
                             told ? static_cast<int>(m_toldUntil.remainingTime()) : 0);
    return true;
}

void MainWindow::showTitle() {
    const Document& document = m_session.document();
    setWindowTitle(document.isEmpty() ? QStringLiteral("Wend[*]")
                                      : tr("%1[*] – Wend").arg(document.displayName()));
    setWindowModified(document.isModified());
}

void MainWindow::showSelection() {
    const Document& document = m_session.document();
    const bool hasPicture = !document.isEmpty() && document.dimension() == 2 &&
                            (document.picture() || !document.project()->domain.texture.empty());
    m_actions->setHasFile(!document.isEmpty(), hasPicture, document.dimension() == 3);
    m_actions->setHasSelection(!m_session.selection().isEmpty());
    m_actions->setHasMotion(m_session.playback().end() > 0);
}

void MainWindow::setAppearance(Appearance appearance) {
    QSettings().setValue("appearance", static_cast<int>(appearance));
    const QPalette look = wendPalette(appearance, m_systemPalette);
    QApplication::setPalette(look);
    qApp->setStyleSheet(wendStyleSheet(look));
    setPalette(look);
    (appearance == Appearance::System  ? m_actions->systemLook
     : appearance == Appearance::Light ? m_actions->lightLook
                                       : m_actions->darkLook)
        ->setChecked(true);
    updateIcons();
}

void MainWindow::updateIcons() {
    m_actions->setIcons(palette());
    m_modes->exportButton()->setIcon(wendIcon(QStringLiteral("export"), primaryPalette(palette())));
    m_solidActions->setIcons(palette());
    m_tools->setIcons(palette());
    m_pictureActions->setIcons(palette());
    showMoreArrows();
    m_start->setRecent(m_files->recent());
}

/// Where a tool bar is too short Qt shows a button of its own for what is left out.
void MainWindow::showMoreArrows() {
    for (QToolBar* bar : {m_topBar, m_toolBar})
        if (auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
            const bool down = bar->orientation() == Qt::Vertical;
            more->setIcon(
                wendIcon(down ? QStringLiteral("more-down") : QStringLiteral("more-right"), palette()));
            more->setToolTip(tr("More"));
            more->setAccessibleName(tr("More"));
        }
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    m_properties->fitTo(width());
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::WindowStateChange) m_actions->fullScreen->setChecked(isFullScreen());
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(m_files->mayLeave());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (EnergySlider::phiIn(event->mimeData())) return event->acceptProposedAction();
    if (!event->mimeData()->hasUrls() || !event->mimeData()->urls().first().isLocalFile()) return;
    event->acceptProposedAction();
    m_start->setDropHighlighted(true);
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
    m_start->setDropHighlighted(false);
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (const auto phi = EnergySlider::phiIn(event->mimeData())) {
        const QPoint at = m_compare->mapFrom(this, event->position().toPoint());
        if (m_compare->rect().contains(at)) m_compare->split(*phi);
        return;
    }
    m_start->setDropHighlighted(false);
    openPath(event->mimeData()->urls().first().toLocalFile());
    event->acceptProposedAction();
}

}  // namespace wend
