#include "app/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <QStyleFactory>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <clocale>
#include <utility>

#include "app/base/connect_each.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/panel_fields.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/group_list.h"
#include "app/panels/layer_panel.h"
#include "app/panels/material_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/pin_list.h"
#include "app/panels/region_list.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/scaled_project.h"
#include "app/session/calm_follower.h"
#include "app/session/opening.h"
#include "app/session/part_making.h"
#include "app/session/settle_step.h"
#include "app/style/theme.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/bars.h"
#include "app/window/actions/brush_actions.h"
#include "app/window/actions/depth_actions.h"
#include "app/window/actions/language_choice.h"
#include "app/window/actions/look_choices.h"
#include "app/window/actions/picture_actions.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/compare_view.h"
#include "app/window/export/exporter.h"
#include "app/window/files/file_workflow.h"
#include "app/window/files/start_page.h"
#include "app/window/files/taken_over.h"
#include "app/window/files/thumbnail.h"
#include "app/window/film/key_pose_strip.h"
#include "app/window/film/pose_drawing.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"
#include "app/window/help/help.h"
#include "app/window/notices/info_banner.h"
#include "app/window/notices/notes.h"
#include "app/window/notices/offers.h"
#include "app/window/properties.h"
#include "app/window/solid_workshop.h"
#include "app/window/workspace.h"

namespace wend {

using Topic = InfoBanner::Topic;

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_tools(new Toolbox(this)),
      m_actions(new Actions(*m_session.document().undoStack(), *m_tools, this)),
      m_solidActions(new SolidActions(*m_tools, this)),
      m_depth(new DepthActions(m_session.document(), m_session.selection(), m_session.motion(), this)),
      m_pins(new PinActions(m_session, this)),
      m_exporter(new Exporter(m_session.playback(), m_session.motion(), *this)),
      m_properties(new Properties(m_session, *m_exporter, *m_tools, *m_actions)),
      m_pictureActions(new PictureActions(this)),
      m_brush(new BrushActions(m_properties->brush(), *m_tools, this)),
      m_banner(new InfoBanner),
      m_files(new FileWorkflow(m_session.document(), *m_banner, *this)),
      m_canvas(new ShapeCanvas(m_session)),
      m_start(new StartPage(*m_files, *m_actions->tutorial)),
      m_tracks(new TrackView(m_session)),
      m_time(new TimeStrip(m_session.document(), m_session.playback(), m_session.motion(), *m_tracks)),
      m_pages(new QStackedWidget),
      m_work(new WorkNote(m_session.motion(), *m_pages)),
      m_tutorial(new Tutorial({m_session.document(), m_session.playback(), *m_actions, *m_tools}, *m_pages)),
      m_appearance(new AppearanceChoice(*m_actions, *this)) {
    setAcceptDrops(true);
    setWindowTitle(QStringLiteral("Wend[*]"));
    constexpr QSize kComfortable(1280, 860), kFrame(8, 40);  // within the screen and its frame
    resize(kComfortable.boundedTo(screen()->availableSize() - kFrame));
    m_fields = new StatusFields(*statusBar(), m_session.document(), m_session.motion());
    m_solids = new SolidWorkshop(
        {m_session, *m_actions, *m_solidActions, *m_properties, *m_exporter, *m_banner}, *this);
    m_workspace = std::make_unique<Workspace>(Workspace::Parts{*m_tools, *m_actions, *m_canvas, *m_solids,
                                                               *m_properties, *m_pictureActions, *m_pins,
                                                               m_exporter->crop()});
    m_curves = new CurveActions(
        m_session, [this] { return m_workspace->curve(); }, this);
    m_material = new MaterialActions(m_session.document(), m_session.motion(), *m_exporter, this);
    m_properties->layers().setPictureMenu(m_material->menu());
    m_tools->shareKeysWith({m_solidActions, m_curves, m_depth, m_pins, m_brush, m_material, m_actions});
    m_menu = new ContextMenu({m_session.document(), *m_actions, *m_curves, *m_depth, *m_pins}, this);
    m_actions->fillMenuBar(*this, m_solidActions->menu(), m_curves->menu(),
                           {m_pins->menu(), m_depth->menu(), m_brush->menu(), m_material->menu()});
    m_appearance->restore();  // before there are bars: they take their margins from the style but once
    makeToolBars();
    makeCentre();
    connectFiles();
    connectEdit();
    connectView();
    connectComparison();
    connectHiding();
    connectFilm();
    new SpaceTap(*this, *m_actions->play);
    new SideWindows(m_session.document(), *m_actions, *m_tools, *this);
    connect(m_appearance, &AppearanceChoice::changed, this, &MainWindow::updateIcons);
    updateIcons();
    showDocument();
}

/// Hides the window while the document exists, because a hidden field applies the number being typed.
MainWindow::~MainWindow() {
    hide();
}

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
               m_options = new OptionRow(*m_tools, *m_actions,
                                         {*m_solidActions, *m_pictureActions, *m_pins, *m_brush}, this));
    m_toolBar = makeBar(Qt::LeftToolBarArea, tr("Tools"), "toolBar");
    connect(m_tools, &Toolbox::changed, this, &MainWindow::showTools);
    showTools();
    setContextMenuPolicy(Qt::NoContextMenu);
}

/// Shows the tools of the current step, and the tracks in the step Animate.
void MainWindow::showTools() {
    m_tracks->setVisible(!m_session.document().isEmpty() && m_tools->mode() == Mode::Animate);
    const QList<QAction*> tools = m_tools->toolsOf(m_tools->mode());
    if (m_toolBar->actions() == tools) return;
    m_toolBar->clear();
    m_toolBar->addActions(tools);
}

void MainWindow::makeCentre() {
    connect(qApp, &QApplication::focusChanged, this, &MainWindow::followFocus);
    auto* centre = new QWidget(this);
    auto* row = bareRow(centre, 0);
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
    row->addWidget(m_rail = new PropertiesRail(*m_properties, *m_actions->showProperties, centre));
    connectEach(this, &MainWindow::focusView, new PanelFields(*m_properties), &PanelFields::done,
                &m_properties->pins(), &PinList::done, new PanelFields(*m_time), &PanelFields::done, m_rail,
                &PropertiesRail::done);
    setCentralWidget(centre);
}

void MainWindow::connectFiles() {
    const Actions& a = *m_actions;
    Document& document = m_session.document();
    onTriggered(m_files, a.open, &FileWorkflow::askOpen, a.save, &FileWorkflow::save, a.saveAs,
                &FileWorkflow::saveAs, a.closeFile, &FileWorkflow::close);
    onTriggered(m_exporter, a.exportPicture, &Exporter::exportPicture, a.exportMesh, &Exporter::exportMesh,
                a.exportFrames, &Exporter::exportFrames, a.exportStMap, &Exporter::exportStMap);
    auto* motion = new MotionChooser(document, *m_banner, *this);
    auto* pictures = new PictureKeeper(document, *m_banner, *a.fit, *this);
    onTriggered(motion, a.applyMotion, &MotionChooser::ask);
    onTriggered(pictures, a.replacePicture, &PictureKeeper::askReplace, a.drawingSize,
                &PictureKeeper::askSize);
    const auto exportFilm = [this] {
        m_session.document().dimension() == 3 ? m_solids->exportFilm() : m_exporter->exportFilm();
    };
    const auto teach = [this] {
        m_tutorial->begin();
        m_files->open(Tutorial::picture());
    };
    onTriggered(this, a.quit, &QWidget::close, a.exportFilm, exportFilm, a.tutorial, teach);
    onTriggered(m_solids, a.exportView, &SolidWorkshop::exportView);
    m_files->setPractice([this] { return m_tutorial->isPractice(); });
    m_exporter->setLooks({[this](const QSize& size) { return m_solids->smallView(size); },
                          [this] { return m_canvas->shape().screenPicture(); }});
    connect(&document, &Document::saved, this, [this] {
        constexpr QSize kCard(720, 720);
        keepThumbnail(m_session.document().path(),
                      m_solids->isActive() ? m_solids->smallView(kCard) : m_canvas->shape().smallView(kCard));
    });
    connect(m_exporter, &Exporter::begun, this, [this] { m_banner->clear(Topic::Export); });
    connect(m_exporter, &Exporter::done, this, [this](const QString& text) {
        m_banner->clear(Topic::Export);  // an export that failed before has its file now
        m_fields->showMessage(text);
    });
    connectEach(
        this, [this](const QString& text) { m_banner->tell(Topic::Export, text); }, m_exporter,
        &Exporter::failed, m_material, &MaterialActions::failed);
    connect(m_actions->languages, &LanguageChoice::changed, m_fields, &StatusFields::showMessage);
    connect(&document, &Document::opened, m_banner, qOverload<>(&InfoBanner::clear));
    auto* notices = new ShapeNotices(m_session, *m_banner, this);
    connect(notices, &ShapeNotices::reasonWanted, this, [this] {
        m_tools->setMode(Mode::Mesh);
        m_rail->openAtSurface();
    });
    new Offers(document, *m_banner, *a.drawingSize, this);
    new RidingOffer(m_session, *m_banner, this);
    new SpringOffer(document, m_session.playback(), *m_banner, this);
    new OpeningNote(*m_files, *m_canvas, *m_pages);
    m_files->fillMenus(*a.recent, *a.samples);
    connect(&document, &Document::opened, this, &MainWindow::showDocument);
    connect(&document, &Document::titleChanged, this, &MainWindow::showTitle);
    connect(&m_session.motion(), &ShapeMotion::problem, this, [this](const QString& text) {
        m_banner->tell(Topic::Shape, text,
                       problemRemedies(m_session.document(), m_session.motion().lacksMemory()));
    });
    connect(&m_session.gestures(), &ShapeGesture::stopped, this, [this](const QString& text) {
        m_banner->tell(Topic::Stop, text, problemRemedies(m_session.document(), false));
    });
}

void MainWindow::connectEdit() {
    const Actions& a = *m_actions;
    const auto selectAll = [this] {
        std::vector<int> all;
        for (const auto& pin : m_session.gestures().pins()) all.push_back(pin.handle);
        m_session.selection().set(std::move(all));
    };
    const auto makePart = [this] {
        if (makePartOfOutline(m_session)) return;
        m_pictureActions->makesPart->setChecked(true);
        m_actions->lassoTool->trigger();
    };
    onTriggered(&m_session, a.remove, &ShapeSession::removeSelected);
    onTriggered(&m_session.selection(), a.selectNone, &Selection::clear);
    onTriggered(this, a.selectAll, selectAll, a.makePart, makePart);
    const MeshPanel* mesh = &m_properties->mesh();
    connect(mesh, &MeshPanel::detailWanted, m_solidActions->chooseDetail, &QAction::trigger);
    connect(mesh, &MeshPanel::sizesWanted, m_solidActions->sizes, &QAction::trigger);
    connect(mesh, &MeshPanel::detailRemoved, m_solidActions->removeDetail, &QAction::trigger);
    connect(mesh, &MeshPanel::partChosen, this, [this](int part) {
        const auto& parts = m_session.document().domain().parts;
        m_pictureActions->pen().change(
            &OutlineSettings::part, part < 0 ? std::string() : parts.at(static_cast<std::size_t>(part)).name);
    });
    connectEach(this, &MainWindow::showSelection, &m_session.selection(), &Selection::changed,
                &m_session.playback(), &Playback::endChanged);
    const auto refresh = [this] {
        m_pins->refresh();
        m_depth->refresh();
        m_curves->refresh();
        m_fields->refresh();
    };
    new CalmFollower(m_session.motion(), this, refresh, &m_session.gestures(), &ShapeGesture::pinsChanged,
                     &m_session.motion(), &ShapeMotion::frameChanged);
    connect(&m_properties->pins(), &PinList::menuWanted, this,
            [this](const QPoint& at) { m_menu->popUp(at, MenuPlace::Handle); });
}

void MainWindow::connectView() {
    const Actions& a = *m_actions;
    connect(&m_properties->detailRegions(), &RegionList::chosen, m_canvas, &ShapeCanvas::setDetailRegions);
    connect(&m_properties->depthRegions(), &RegionList::chosen, m_canvas, &ShapeCanvas::setDepthRegions);
    onTriggered(
        m_canvas, a.fit, &ShapeCanvas::fit, a.zoomIn, [this] { m_canvas->zoomBy(1.25); }, a.zoomOut,
        [this] { m_canvas->zoomBy(0.8); }, a.actualSize,
        [this] { m_canvas->zoomTo(1 / m_canvas->devicePixelRatioF()); });
    const auto tellZoom = [this] {
        const bool isFlat = m_session.document().dimension() == 2;
        m_modes->showZoom(isFlat ? m_canvas->view().zoom() * m_canvas->devicePixelRatioF() : 0);
    };
    connectEach(this, tellZoom, m_canvas, &ShapeCanvas::viewChanged, &m_session.document(),
                &Document::opened);
    onToggled(this, a.fullScreen, [this](bool on) { on ? showFullScreen() : showNormal(); });
    const DistortionPanel* distortion = &m_properties->distortion();
    connectEach(
        this, [this] { m_actions->showMap->setChecked(true); }, distortion, &DistortionPanel::mapChosen,
        distortion, &DistortionPanel::showWorst, distortion, &DistortionPanel::placeWanted);
    connect(distortion, &DistortionPanel::faultsChanged, this,
            [this, distortion] { m_canvas->setFaults(distortion->watch().faults<2>()); });
    connectViewport(m_canvas->viewport());
    connect(m_solids, &SolidWorkshop::viewportMade, this, &MainWindow::connectViewport);
}

/// Connects a viewport of pictures or solids.
void MainWindow::connectViewport(Viewport& view) {
    connect(&view, &Viewport::hintChanged, this, [this](const QString& hint) {
        m_fields->setHint(hint);
        m_curves->refresh();
    });
    connect(&view, &Viewport::menuWanted, m_menu, &ContextMenu::popUp);
    connect(&view, &Viewport::pointed, m_fields, &StatusFields::setPointer);
    connect(&m_properties->layers(), &LayerPanel::chosen, &view,
            [&view](Id layer) { view.set(&Looks::layer, layer); });
    connect(&m_properties->groups(), &GroupList::marked, &view,
            [&view](const GroupMarks& marks) { view.set(&Looks::groups, marks); });
    const DistortionPanel* distortion = &m_properties->distortion();
    connect(distortion, &DistortionPanel::showWorst, &view, &Viewport::showWorst);
    connect(distortion, &DistortionPanel::placeWanted, &view, &Viewport::showPlace);
}

/// Connects what starts a comparison: a tile dragged to the shape, or the action. Hovering over a tile
/// previews it.
void MainWindow::connectComparison() {
    EnergySlider& tiles = *m_properties->material().energySlider();
    for (ShapeCanvas* half : {m_canvas, &m_compare->picture()})
        followLooks(half->viewport(), *m_actions, m_properties->distortion());
    connect(m_compare, &CompareView::solidMade, m_solids, &SolidWorkshop::connectLooks);
    connect(&tiles, &EnergySlider::hovered, m_compare, &CompareView::preview);
    connect(m_compare, &CompareView::splitChanged, m_actions->compare, &QAction::setChecked);
    onToggled(this, m_actions->compare, [this, &tiles](bool on) {
        if (!on) return m_compare->join();
        const auto& stops = tiles.scale().stops();
        const int other = tiles.scale().stopAt(tiles.phi()) == 1 ? 3 : 1;
        if (!m_compare->isSplit()) m_compare->split(stops[other].phi);
    });
    new TilePictures(
        m_session, *m_canvas, [this] { return m_solids->canvas(); }, tiles);
}

/// Connects hiding of overlays and showing the rest shape, by switches or by held keys.
void MainWindow::connectHiding() {
    auto *bare = new HeldKey(Qt::Key_H, *this), *before = new HeldKey(Qt::Key_Backslash, *this);
    const auto show = [this, bare, before] {
        const bool rest = m_actions->showRest->isChecked() || before->isHeld();
        const bool hidden = rest || m_actions->hideOverlays->isChecked() || bare->isHeld();
        std::vector<Viewport*> views = {&m_canvas->viewport(), &m_compare->picture().viewport()};
        for (SolidCanvas* solid : {m_solids->canvas(), m_compare->solid()})
            if (solid) views.push_back(&solid->viewport());
        for (Viewport* view : views) {
            view->set(&Looks::hidden, hidden);
            view->set(&Looks::rest, rest);
        }
    };
    connectEach(this, show, m_actions->hideOverlays, &QAction::toggled, m_actions->showRest,
                &QAction::toggled, bare, &HeldKey::heldChanged, before, &HeldKey::heldChanged);
}

/// Connects playback, recording and time with the strip below the canvas and with the tracks.
void MainWindow::connectFilm() {
    Actions& a = *m_actions;
    Document& document = m_session.document();
    Playback& playback = m_session.playback();
    ShapeGesture& gestures = m_session.gestures();
    m_time->playButton()->setDefaultAction(a.play);
    m_time->loopButton()->setDefaultAction(a.loop);
    onTriggered(
        this, a.play, [&playback] { playback.setPlaying(!playback.isPlaying()); }, a.toStart,
        [&playback] { playback.setTime(0); }, a.toEnd, [&playback] { playback.setTime(playback.end()); },
        a.settle, [&document, &playback] { settleAtEnd(document, playback); });
    connect(a.speed.get(), &QMenu::triggered, this, [&a, &playback](const QAction* chosen) {
        playback.setSpeed(chosen->data().toDouble());
        a.setSpeed(playback.speed());
    });
    connect(&playback, &Playback::playingChanged, &a, &Actions::setPlaying);
    onToggled(&playback, a.loop, &Playback::setLoops);
    onToggled(&gestures, a.record, &ShapeGesture::setRecording, a.keepWay, &ShapeGesture::setKeepsWay);
    const auto pose = [this, &gestures] {
        gestures.setPosing(m_actions->poseHere->isChecked() && m_tools->mode() == Mode::Animate);
    };
    connectEach(this, pose, a.poseHere, &QAction::toggled, m_tools, &Toolbox::changed);
    connectEach(this, &MainWindow::takeCycle, &document, &Document::projectChanged, &document,
                &Document::opened);
    m_tracks->poses().setDrawing(new PoseDrawing(
        *m_canvas, [this] { return m_solids->canvas(); }, this));
}

/// Turns looping on when a cycle is marked or opened.
void MainWindow::takeCycle() {
    const auto cycle = filmMarksOf(m_session.document()).cycle;
    m_session.playback().setCycle(cycle ? cycle->at(0) : 0, cycle ? cycle->at(1) : 0);
    if (!std::exchange(m_hasCycle, cycle.has_value()) && cycle) m_actions->loop->setChecked(true);
}

void MainWindow::openPath(const QString& path) {
    m_files->open(path);
}

void MainWindow::showDocument() {
    const bool has = !m_session.document().isEmpty();
    const bool solid = m_session.document().dimension() == 3;
    m_actions->resetView();
    m_solidActions->resetView();
    m_pictureActions->adds->setChecked(true);
    m_solids->setActive(solid);
    if (solid && m_pages->indexOf(m_solids->page()) < 0) {
        setAttribute(Qt::WA_Moved);  // Qt recreates the window for OpenGL; this keeps its position
        m_pages->addWidget(m_solids->page());
    }
    QWidget* shape = solid ? m_solids->page() : m_canvas;
    m_pages->setCurrentWidget(has ? shape : m_start);
    m_tools->setDimension(has && (!solid || m_solids->canvas()) ? m_session.document().dimension() : 0);
    m_solids->showDomain();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_rail, m_time, m_toolBar, m_topBar, m_options})
        widget->setVisible(has);
    focusView();
    m_fields->setVisible(has);
    m_fields->forgetMessage();
    showSelection();
    showTitle();
}

void MainWindow::showSelection() {
    const Document& document = m_session.document();
    const bool hasPicture = !document.isEmpty() && document.dimension() == 2 &&
                            (document.picture() || !document.domain().texture.empty());
    const bool hasDrawing =
        hasPicture && !drawingIn(document.domain(), document.folder().toStdString()).empty();
    m_actions->setHasFile(!document.isEmpty(), hasPicture, hasDrawing, document.dimension() == 3);
    m_actions->setHasSelection(!m_session.selection().isEmpty());
    m_actions->setHasMotion(m_session.playback().end() > 0);
}

void MainWindow::updateIcons() {
    for (ActionMaker* maker :
         std::initializer_list<ActionMaker*>{m_actions, m_solidActions, m_tools, m_pictureActions, m_pins})
        maker->setIcons(palette());
    m_modes->exportButton()->setIcon(wendIcon(QStringLiteral("export"), primaryPalette(palette())));
    showMoreArrows();
}

bool MainWindow::event(QEvent* event) {
    if (event->type() != QEvent::StatusTip) return QMainWindow::event(event);
    m_fields->showTip(static_cast<QStatusTipEvent*>(event)->tip());
    return true;
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    m_rail->fitTo(width());
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::WindowStateChange) m_actions->fullScreen->setChecked(isFullScreen());
    QMainWindow::changeEvent(event);
}

/// Escape, where nothing else has a use for it, gives the keyboard back to the view.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QMainWindow::keyPressEvent(event);
    focusView();
}

/// Focuses the shape, or the start page.
void MainWindow::focusView() {
    m_pages->currentWidget()->setFocus();
}

/// Moves the focus to the view when the focused widget is hidden: Qt would choose an arbitrary one.
void MainWindow::followFocus(const QWidget* from, const QWidget* to) {
    if (isAncestorOf(from) && isAncestorOf(to) && !from->isVisibleTo(this)) focusView();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(m_files->mayLeave());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (EnergySlider::phiIn(event->mimeData())) return event->acceptProposedAction();
    const QString path =
        event->mimeData()->hasUrls() ? event->mimeData()->urls().first().toLocalFile() : QString();
    if (!mayBeOpened(path)) return;
    event->acceptProposedAction();
    m_start->setDropHighlighted(true);
    const auto count = event->mimeData()->urls().size();
    m_fields->showTip(count > 1 ? tr("Let go to open %n pictures as parts", nullptr, static_cast<int>(count))
                                : tr("Let go to open “%1”").arg(QFileInfo(path).fileName()));
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
    m_start->setDropHighlighted(false);
    m_fields->showTip({});
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (const auto phi = EnergySlider::phiIn(event->mimeData())) {
        const QPoint at = m_compare->mapFrom(this, event->position().toPoint());
        if (m_compare->rect().contains(at)) m_compare->split(*phi);
        return;
    }
    m_start->setDropHighlighted(false);
    m_fields->showTip({});
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) paths << url.toLocalFile();
    m_files->openAll(paths);
    event->acceptProposedAction();
}

void MainWindow::showTitle() {
    const Document& document = m_session.document();
    setWindowTitle(document.isEmpty() ? QStringLiteral("Wend[*]")
                                      : tr("%1[*] – Wend").arg(document.displayName()));
    setWindowModified(document.isModified());
}

/// Styles the button that Qt adds to a tool bar that is too short.
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

int runWindow(int argc, char** argv) {
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's, but files have points in every country
    QApplication::setOrganizationName(QStringLiteral("Wend"));
    QApplication::setApplicationName(QStringLiteral("Wend"));
    QApplication::setApplicationVersion(QStringLiteral(WEND_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("wend"));
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/wend/icons/wend.svg")));
    const SpokenLanguage language;
    MainWindow window;
    window.files().guardWork(Recovery::standardFolder());
    window.show();
    if (const QString file = QApplication::arguments().value(1); !file.isEmpty()) {
        window.files().tellLostWhenOpened();
        window.openPath(file);
    }
    return QApplication::exec();
}

}  // namespace wend
