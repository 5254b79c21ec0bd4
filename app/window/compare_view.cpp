#include "app/window/compare_view.h"

#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/base/connect_each.h"
#include "app/engine/shape/shape.h"
#include "app/engine/shape/shape_builder.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/domain.h"
#include "app/project/edits/material_edits.h"
#include "app/project/options/options.h"
#include "app/project/options/settings.h"
#include "app/style/energy_scale.h"
#include "app/style/theme.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"
#include "core/energy/distortion.h"

namespace wend {

namespace {

constexpr int kHead = 44;  // two lines, where a half is narrow

QString nameOf(double phi, int dimension) {
    const EnergyScale scale(dimension);
    if (const int stop = scale.stopAt(phi); stop >= 0) return scale.stops()[stop].name;
    const int below = static_cast<int>(scale.positionOf(phi));
    return CompareView::tr("%1 – %2").arg(scale.stops()[below].name, scale.stops()[below + 1].name);
}

/// Returns the three totals in the order of the properties.
QString totalsOf(const ShapeSession& session) {
    if (!session.motion().frame()) return CompareView::tr("is being computed …");
    const Distortion& distortion = *session.motion().frame()->distortion;
    const QLocale locale;
    const bool about = session.motion().frame()->live || session.motion().isStale();
    const auto text = [&](double value) {
        return (about ? QStringLiteral("≈ ") : QString()) + locale.toString(value, 'f', 3);
    };
    const QString all = session.motion().frame()->dimension == 3
                            ? CompareView::tr("angle %1 · volume %2 · stretch %3")
                            : CompareView::tr("angle %1 · area %2 · stretch %3");
    return all.arg(text(distortion.totalAngle), text(distortion.totalVolume), text(distortion.totalMetric));
}

constexpr int kIdle = 500;  // milliseconds
constexpr int kVertices = 600;
constexpr double kTileMargin = 2;  // pixels

}  // namespace

Comparison::Comparison(ShapeSession& session, QObject* parent) : QObject(parent), m_session(session) {
    m_other.document().undoStack()->setUndoLimit(1);
    connect(&m_session.document(), &Document::opened, this, [this] {
        end();
        m_generation = -1;
        m_other.document().close();
    });
    connect(&m_session.document(), &Document::projectChanged, this, &Comparison::take);
    connect(&m_session.playback(), &Playback::timeChanged, &m_other.playback(), &Playback::setTime);
    connect(&m_session.selection(), &Selection::changed, this, &Comparison::takeSelection);
    const ShapeGesture* gestures = &m_session.gestures();
    ShapeGesture& others = m_other.gestures();
    connect(gestures, &ShapeGesture::began, this, [this, gestures, &others] {
        if (!m_on) return;
        m_other.selection().set(gestures->drag()->handles());
        others.begin(gestures->drag()->grip());
    });
    connect(gestures, &ShapeGesture::moved, &others,
            [&others](const Amount& amount) { others.moveBy(amount); });
    connect(gestures, &ShapeGesture::ended, &others, &ShapeGesture::letGo);
    connect(gestures, &ShapeGesture::cancelled, &others, &ShapeGesture::cancel);
}

void Comparison::begin(std::optional<double> phi) {
    if (m_session.document().isEmpty()) return;
    m_phi = phi;
    m_on = true;
    take();
    emit changed();
}

void Comparison::end() {
    if (std::exchange(m_on, false)) emit changed();
}

FramePtr Comparison::frame() const {
    return m_on && !m_other.motion().isStale() && !m_other.motion().isMeshing() ? m_other.motion().frame()
                                                                                : FramePtr();
}

std::shared_ptr<const Project> Comparison::wanted() const {
    const auto project = copyOf(*m_session.document().project());
    if (m_phi)
        option("material.phi").field.at.set(*project, *m_phi);
    else
        designOf(*project) = withoutCells(withAllHidden(designOf(*project)));
    return project;
}

void Comparison::take() {
    if (!m_on) return;
    const Document& document = m_session.document();
    if (std::exchange(m_generation, document.generation()) == document.generation()) {
        m_other.document().change({}, wanted());
    } else {
        OpenedFile file;
        file.project = wanted();
        file.picture = document.picture();
        file.path = document.path();
        file.source = document.source();
        m_other.document().open(std::move(file));
    }
    m_other.playback().setTime(m_session.playback().time());
    takeSelection();
}

/// Copies the selection, which decides whose influence a map shows.
void Comparison::takeSelection() {
    if (m_on) m_other.selection().set(m_session.selection().handles());
}

CompareView::CompareView(const Parts& parts, QWidget* parent)
    : QWidget(parent),
      m_parts(parts),
      m_comparison(parts.session),
      m_ownName(new QLabel),
      m_ownTotals(secondLabel({}, nullptr)),
      m_otherTotals(secondLabel({}, nullptr)),
      m_energy(
          choiceBox(this, "comparedEnergy", tr("Compare with"),
                    tr("What this half keeps, or how it is without paint, with the same pins and motions."),
                    {}, [this](int i) { split(m_energy->itemData(i).value<std::optional<double>>()); })),
      m_ownHead(ownHead()),
      m_otherHead(otherHead()),
      m_other(new QWidget),
      m_picture(new ShapeCanvas(m_comparison.other())) {
    auto* row = bareRow(this, 1);
    auto* own = new QVBoxLayout;
    own->setSpacing(0);
    own->addWidget(m_ownHead);
    own->addWidget(&m_parts.page, 1);
    row->addLayout(own, 1);
    auto* other = bareColumn(m_other, 0);
    other->addWidget(m_otherHead);
    other->addWidget(m_picture, 1);
    row->addWidget(m_other, 1);
    m_picture->followOther();
    m_picture->setAccessibleName(tr("The same with another energy"));
    m_ownHead->hide();
    m_other->hide();
    connectViews();
}

QWidget* CompareView::ownHead() {
    auto* head = new QWidget(this);
    head->setFixedHeight(kHead);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(12, 0, 12, 0);
    m_ownName->setProperty("role", "title");
    m_ownTotals->setObjectName(QStringLiteral("ownTotals"));
    for (QLabel* totals : {m_ownTotals, m_otherTotals})
        totals->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_ownName);
    row->addWidget(m_ownTotals, 1);
    return head;
}

QWidget* CompareView::otherHead() {
    auto* head = new QWidget(this);
    head->setFixedHeight(kHead);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(12, 0, 4, 0);
    m_energy->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_otherTotals->setObjectName(QStringLiteral("otherTotals"));
    m_close = buttonFor<QToolButton>(this, "endComparison", {}, tr("Shows one shape again."),
                                     &CompareView::join, tr("End the comparison"));
    m_close->setIcon(wendIcon(QStringLiteral("close"), palette()));
    m_close->setAutoRaise(true);
    row->addWidget(m_energy);
    row->addWidget(m_otherTotals, 1);
    row->addWidget(m_close);
    return head;
}

void CompareView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_close)
        m_close->setIcon(wendIcon(QStringLiteral("close"), palette()));
}

void CompareView::connectViews() {
    connect(&m_parts.picture, &ShapeCanvas::viewChanged, this,
            [this] { m_picture->takeView(m_parts.picture); });
    connect(m_picture, &ShapeCanvas::viewChanged, this, [this] {
        if (m_picture->underMouse()) m_parts.picture.takeView(*m_picture);
    });
    m_picture->installEventFilter(this);
    connect(&m_comparison.other().motion(), &ShapeMotion::frameChanged, this, &CompareView::takeFrame);
    connect(&m_parts.session.motion(), &ShapeMotion::frameChanged, this, &CompareView::showHeads);
    connect(&m_parts.session.document(), &Document::opened, this, &CompareView::join);
    connect(&m_parts.session.document(), &Document::projectChanged, this, [this] {
        if (m_split) showEnergies();
    });
}

void CompareView::split(std::optional<double> phi) {
    if (m_parts.session.document().isEmpty()) return;
    preview(std::nan(""));
    m_comparison.begin(phi);
    const bool first = !std::exchange(m_split, true);
    if (m_parts.session.document().dimension() == 3) makeSolid();
    showHalf();
    showEnergies();
    takeFrame();
    if (first) emit splitChanged(true);
}

void CompareView::join() {
    if (!std::exchange(m_split, false)) return;
    if (const QWidget* focus = QApplication::focusWidget(); focus && m_other->isAncestorOf(focus)) focusOwn();
    m_comparison.end();
    showHalf();
    emit splitChanged(false);
}

/// Moves the focus before the focused half is removed.
void CompareView::focusOwn() {
    SolidCanvas* solid = m_parts.solid();
    const bool space = m_parts.session.document().dimension() == 3 && solid;
    (space ? static_cast<QWidget&>(*solid) : m_parts.picture).setFocus();
}

void CompareView::makeSolid() {
    SolidCanvas* own = m_parts.solid();
    if (m_solid || !own) return;
    m_solid = new SolidCanvas(m_comparison.other());
    m_other->layout()->addWidget(m_solid);
    m_solid->installEventFilter(this);
    connectEach(
        this, [this, own] { m_solid->takeView(*own); }, own, &VolumeView::cameraChanged, own,
        &SolidCanvas::cutChanged);
    connect(m_solid, &VolumeView::cameraChanged, this, [this, own] {
        if (m_solid->underMouse()) own->takeView(*m_solid);
    });
    emit solidMade(m_solid);
}

/// Returns whether a pin of the edited shape is at that place of its view.
bool CompareView::isOnPin(const QPointF& at) const {
    SolidCanvas* own = m_parts.solid();
    const bool isFlat = m_parts.session.document().dimension() == 2;
    const Tool* tool = isFlat ? m_parts.picture.viewport().tool() : own ? own->viewport().tool() : nullptr;
    return tool && tool->wants(at);
}

/// Forwards drags of pins in the other half to the first. Both halves show the same part at the same scale,
/// with pins at the same places.
bool CompareView::eventFilter(QObject* watched, QEvent* event) {
    const auto type = event->type();
    const bool moves = type == QEvent::MouseMove, presses = type == QEvent::MouseButtonPress;
    if (!moves && !presses && type != QEvent::MouseButtonRelease) return QWidget::eventFilter(watched, event);
    const auto& mouse = static_cast<const QMouseEvent&>(*event);
    if (presses && mouse.button() == Qt::LeftButton && isOnPin(mouse.position())) m_passes = true;
    if (!m_passes) return QWidget::eventFilter(watched, event);
    QWidget& own = watched == m_picture ? static_cast<QWidget&>(m_parts.picture) : *m_parts.solid();
    QMouseEvent passed(type, mouse.position(), own.mapToGlobal(mouse.position()), mouse.button(),
                       mouse.buttons(), mouse.modifiers());
    passed.setTimestamp(mouse.timestamp());
    QCoreApplication::sendEvent(&own, &passed);
    if (type == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton) m_passes = false;
    return true;
}

void CompareView::showHalf() {
    const bool solid = m_split && m_parts.session.document().dimension() == 3;
    m_ownHead->setVisible(m_split);
    m_picture->setVisible(!solid);
    if (m_solid) m_solid->setVisible(solid);
    m_other->setVisible(m_split);
}

void CompareView::showHeads() {
    if (!m_split || m_parts.session.document().isEmpty()) return;
    const int dimension = m_parts.session.document().dimension();
    m_ownName->setText(nameOf(settingOf(*m_parts.session.document().project(), "material.phi"), dimension));
    m_ownTotals->setText(totalsOf(m_parts.session));
    m_otherTotals->setText(totalsOf(m_comparison.other()));
}

void CompareView::showEnergies() {
    const int dimension = m_parts.session.document().dimension();
    const EnergyScale scale(dimension);
    const QSignalBlocker quiet(m_energy);
    m_energy->clear();
    const auto add = [this](const QString& name, std::optional<double> phi) {
        m_energy->addItem(name, QVariant::fromValue(phi));
        if (phi == m_comparison.phi()) m_energy->setCurrentIndex(m_energy->count() - 1);
    };
    for (const EnergyStop& stop : scale.stops()) add(stop.name, stop.phi);
    if (m_comparison.phi() && scale.stopAt(*m_comparison.phi()) < 0)
        add(nameOf(*m_comparison.phi(), dimension), m_comparison.phi());
    if (!m_comparison.phi() || isPainted(m_parts.session.document().design()))
        add(tr("Nothing painted"), std::nullopt);
}

void CompareView::preview(double phi) {
    if (m_split) return;
    if (std::isnan(phi)) {
        if (!std::exchange(m_previews, false)) return;
        m_comparison.end();
    } else {
        m_previews = true;
        m_comparison.begin(phi);
    }
    takeFrame();
}

/// Keeps the shape until the comparison has its own.
void CompareView::takeFrame() {
    const FramePtr frame = m_previews ? m_comparison.frame() : FramePtr();
    m_parts.picture.viewport().set(&Looks::standIn, frame && frame->dimension == 2 ? frame : FramePtr());
    if (SolidCanvas* solid = m_parts.solid())
        solid->viewport().set(&Looks::standIn, frame && frame->dimension == 3 ? frame : FramePtr());
    showOtherHalf();
    showHeads();
}

/// Shows the shape itself until the other half has its own.
void CompareView::showOtherHalf() {
    if (!m_split) return;
    const FramePtr own =
        m_comparison.other().motion().frame() ? FramePtr() : m_parts.session.motion().frame();
    if (m_picture->isVisible()) {
        m_picture->viewport().set(&Looks::standIn, own);
        m_picture->takeView(m_parts.picture);
    }
    if (m_solid && m_solid->isVisible()) {
        m_solid->viewport().set(&Looks::standIn, own);
        m_solid->takeView(*m_parts.solid());
    }
}

TilePictures::TilePictures(ShapeSession& session, const ShapeCanvas& picture,
                           std::function<SolidCanvas*()> solid, EnergySlider& tiles)
    : QObject(&tiles), m_session(session), m_canvas(picture), m_solid(std::move(solid)), m_tiles(tiles) {
    m_coarse.document().undoStack()->setUndoLimit(1);
    m_idle.setSingleShot(true);
    m_idle.setInterval(kIdle);
    m_idle.callOnTimeout(this, &TilePictures::begin);
    connect(&m_session.motion(), &ShapeMotion::frameChanged, this, &TilePictures::expire);
    connect(&m_session.document(), &Document::opened, this, [this] {
        m_coarse.document().close();
        m_project.reset();
        m_tiles.setPictures({});
        expire();
    });
    connect(&m_coarse.motion(), &ShapeMotion::busyChanged, this, &TilePictures::take);
}

/// There is no coarser mesh for a mesh from a file.
bool TilePictures::isPossible() const {
    if (m_session.document().isEmpty() || !m_session.motion().frame() || m_session.playback().end() <= 0)
        return false;
    const DomainKind kind = m_session.document().domain().kind;
    return (kind == DomainKind::Image && m_session.document().picture()) ||
           (kind == DomainKind::Surface && m_solid());
}

void TilePictures::expire() {
    const bool same = m_project == m_session.document().project() && m_time == m_session.playback().time();
    if (same && (m_done || m_running)) return;
    m_running = m_done = false;
    if (!isPossible()) {
        m_idle.stop();
        return m_tiles.setPictures({});
    }
    m_tiles.setPicturesStale(true);
    m_idle.start();
}

void TilePictures::begin() {
    if (!isPossible() || m_running) return;
    const bool moves =
        m_session.motion().isBusy() || m_session.motion().isDragging() || m_session.playback().isPlaying();
    const bool flat = m_session.document().dimension() == 2;
    if (moves || !m_tiles.isVisible() || (flat && !m_canvas.shape().screenPicture())) return m_idle.start();
    m_project = m_session.document().project();
    m_time = m_session.playback().time();
    m_made.clear();
    m_running = true;
    ask();
}

/// Requests the next picture.
void TilePictures::ask() {
    const auto project = copyOf(*m_project);
    Domain& domain = domainOf(*project);
    const auto set = [&](const char* key, double value) { option(key).field.at.set(*project, value); };
    set("material.phi", m_tiles.scale().stops().at(m_made.size()).phi);
    set("domain.vertices", std::min(domain.edge > 0 ? kVertices : domain.vertices, kVertices));
    if (domain.kind == DomainKind::Surface) domain.fit = Fit::Cage;
    Document& document = m_coarse.document();
    if (!document.isEmpty()) {
        document.change({}, project);
    } else {
        const Document& own = m_session.document();
        OpenedFile file;
        file.project = project;
        file.picture = own.picture();
        file.path = own.path();
        file.source = own.source();
        document.open(std::move(file));
    }
    m_coarse.playback().setTime(m_time);
}

void TilePictures::take() {
    if (!m_running || m_coarse.motion().isBusy()) return;
    if (!m_coarse.motion().frame()) {  // failed: the window reports it
        m_running = false;
        m_done = true;
        return m_tiles.setPictures({});
    }
    m_made.push_back(drawn(m_coarse.motion().frame()));
    if (m_made.size() < EnergyScale::kStops) return ask();
    m_running = false;
    m_done = true;
    m_tiles.setPictures(m_made);
}

QPixmap TilePictures::drawn(const FramePtr& frame) {
    return frame->dimension == 2 ? drawnFlat(frame) : drawnSolid(static_cast<const PosedFrame<3>&>(*frame));
}

/// Draws from the view's direction.
QPixmap TilePictures::drawnSolid(const PosedFrame<3>& frame) {
    const double ratio = m_tiles.devicePixelRatioF();
    QPixmap picture = QPixmap::fromImage(m_view.draw(*m_solid(), frame, EnergySlider::pictureSize() * ratio));
    picture.setDevicePixelRatio(ratio);
    return picture;
}

QPixmap TilePictures::drawnFlat(const FramePtr& frame) const {
    RenderRequest request;
    request.frame = posed<2>(frame);
    request.picture = m_canvas.shape().screenPicture();
    if (request.frame->built) request.texture = request.frame->built->texture;
    request.size = EnergySlider::pictureSize();
    request.ratio = m_tiles.devicePixelRatioF();
    request.filter = Filter::Ewa;
    const Points2& pose = request.frame->pose;
    const Vec2 low = pose.rowwise().minCoeff(), size = pose.rowwise().maxCoeff() - low;
    request.view.setZoomLimits(1e-9, 1e9);
    request.view.fit(QRectF(low.x(), low.y(), size.x(), size.y()), request.size, kTileMargin);
    return QPixmap::fromImage(RenderThread::render(request));
}

}  // namespace wend
