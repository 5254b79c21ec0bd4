#include "app/panels/mesh_panel.h"

#include <QComboBox>
#include <QLocale>
#include <QToolButton>
#include <cmath>

#include "app/document/domain.h"
#include "app/document/edits/setting_edits.h"
#include "app/panels/cut_out_panel.h"
#include "app/panels/fields/detail_row.h"
#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/session/shape/shape.h"
#include "warp/image.h"

namespace wend {

namespace {

constexpr int kFewest = 200, kMost = 100000;

// The density slider is logarithmic over the usual range.
int sliderOf(int vertices) {
    return static_cast<int>(
        std::lround(1000 * std::log(vertices / double(kFewest)) / std::log(kMost / double(kFewest))));
}
int verticesOf(int slider) {
    const double exact = kFewest * std::pow(kMost / double(kFewest), slider / 1000.0);
    const double unit = std::pow(10, std::floor(std::log10(exact)) - 1);
    return static_cast<int>(std::lround(exact / unit) * unit);
}

enum Aim { ByVertices, ByVolume };

/// The largest cell that there is now, to two digits.
double largestCell(const PosedFrame<3>& frame) {
    double maximum = 0;
    for (const Cell<3>& cell : frame.rest->cells)
        maximum = std::max(maximum, std::abs(cellMeasure<3>(frame.rest->points, cell)));
    const double unit = std::pow(10, std::floor(std::log10(maximum)) - 1);
    return std::ceil(maximum / unit) * unit;
}

}  // namespace

MeshPanel::MeshPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_settings(session.document(), this, CutOutPanel::notACutOut()),
      m_density(new JumpSlider(this)),
      m_aim(new QComboBox(this)),
      m_sizes(new QToolButton(this)),
      m_detail(new DetailRow(this)),
      m_counts(secondLabel({}, this)) {
    makeControls();
    arrange();
    connectControls();
    connect(&m_session.document(), &Document::projectChanged, this, &MeshPanel::showProject);
    connect(&m_session, &ShapeSession::frameChanged, this, &MeshPanel::showCounts);
    showProject();
}

void MeshPanel::makeControls() {
    m_density->setRange(0, 1000);
    m_aim->addItems({tr("Vertices"), tr("Maximum volume")});
    fitToEntries(m_aim, 150);
    describe(m_aim, tr("Aim"),
             tr("What sets how fine the mesh is: how many vertices it has in total, or how large a "
                "tetrahedron may be."));
    m_sizes->setText(tr("Paint…"));
    m_sizes->setObjectName(QStringLiteral("paintSizes"));
    m_sizes->setProperty("role", "chip");
    describe(m_sizes, tr("Cell sizes"),
             tr("Paints where the mesh should be finer or coarser, or sets it by regions in numbers."));
}

void MeshPanel::arrange() {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("Mesh"), this));
    const auto add = [&](QWidget* widget) {
        layout->addWidget(widget);
        return widget;
    };
    const auto row = [&](const char* key) { return add(m_settings.row(key)); };
    m_pictureRows = {row("domain.outline.from"), row("domain.outline.threshold"),
                     row("domain.outline.margin"), row("domain.border")};
    QWidget* fit = row("domain.cage");
    QWidget* aim = add(panelRowIn(tr("A&im at"), m_aim, this));
    QWidget* vertices = row("domain.vertices");
    describe(m_density, tr("Detail: coarse – fine"),
             m_settings.field("domain.vertices").focusProxy()->statusTip());
    add(m_density);
    m_volumeRows = {row("domain.maxVolume")};
    m_shells = row("domain.shells");
    QWidget* quality = row("domain.quality");
    QWidget* refine = row("domain.refineSurface");
    QWidget* sizes = add(panelRowIn(tr("Finer and coarser"), m_sizes, this));
    add(m_detail);
    m_solidRows = {fit, aim, quality, refine, sizes};
    m_surfaceRows = {vertices, m_density};
    add(m_counts);
}

void MeshPanel::connectControls() {
    connect(m_density, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(m_density, &QSlider::valueChanged, this, [this](int value) {
        changeSetting(m_session.document(), "domain.vertices", verticesOf(value), m_gesture);
    });
    connect(m_aim, &QComboBox::activated, this, [this](int aim) { setAim(aim == ByVolume); });
    connect(m_sizes, &QToolButton::clicked, this, &MeshPanel::sizesWanted);
    connect(m_detail, &DetailRow::wanted, this, &MeshPanel::detailWanted);
    connect(m_detail, &DetailRow::removed, this, &MeshPanel::detailRemoved);
}

/// Begins with the volume that the mesh has now, so that it stays about as fine.
void MeshPanel::setAim(bool volume) {
    const bool isVolume = m_session.document().domain().maxVolume > 0;
    if (volume == isVolume) return;
    const auto frame = m_session.frame<3>();
    if (volume && !frame) {
        showProject();
        return;
    }
    Domain next = m_session.document().domain();
    next.maxVolume = volume ? largestCell(*frame) : 0;
    m_session.document().changeDomain(volume ? tr("Aim at a volume") : tr("Aim at vertices"),
                                      std::move(next));
}

void MeshPanel::showProject() {
    const Document& document = m_session.document();
    const bool meshed = !document.isEmpty() && document.domain().kind != DomainKind::Mesh;
    showRows();
    setEnabled(meshed);
    setToolTip(document.isEmpty() || meshed ? QString()
                                            : tr("The mesh comes from a file and is used as it is."));
    if (document.isEmpty()) return;
    m_settings.show();
    const Domain& domain = document.domain();
    OptionField& outline = m_settings.field("domain.outline.from");
    outline.allow(static_cast<int>(OutlineKind::Alpha), document.picture() && document.picture()->alpha,
                  tr("This picture has no transparency."));
    outline.allow(kFilledCutOut, document.picture() && document.picture()->alpha,
                  tr("This picture has no transparency."));
    outline.allow(static_cast<int>(OutlineKind::Polygons), !domain.polygons.loops.empty(),
                  tr("No outline has been drawn."));
    const QSignalBlocker quiet(m_density);
    if (!m_density->isSliderDown()) m_density->setValue(sliderOf(domain.vertices));
    m_aim->setCurrentIndex(domain.maxVolume > 0 ? ByVolume : ByVertices);
    m_detail->showDomain(domain);
}

/// Rows that stay are not hidden in between, because their fields would lose the focus.
void MeshPanel::showRows() {
    const Document& document = m_session.document();
    const bool solid = document.dimension() == 3;
    const bool surface = solid && document.domain().kind == DomainKind::Surface;
    const bool volume = surface && document.domain().maxVolume > 0;
    const auto show = [](const std::vector<QWidget*>& rows, bool visible) {
        for (QWidget* row : rows) row->setVisible(visible);
    };
    show(m_pictureRows, !solid);
    show(m_surfaceRows, !solid || (surface && !volume));
    show(m_solidRows, surface);
    show(m_volumeRows, volume);
    m_detail->setVisible(solid);
    showShells();
}

/// Shows the choice where there is one.
void MeshPanel::showShells() {
    const Document& document = m_session.document();
    const bool surface = document.dimension() == 3 && document.domain().kind == DomainKind::Surface;
    const auto frame = m_session.frame<3>();
    m_shells->setVisible(surface && (document.domain().shells != Shells::Automatic ||
                                     (frame && frame->built && frame->built->hasSpaces)));
}

void MeshPanel::showCounts() {
    const FramePtr& frame = m_session.frame();
    showShells();
    if (!frame) {
        m_counts->clear();
        return;
    }
    const QLocale locale;
    const QString text =
        frame->dimension == 3 ? tr("%1 vertices, %2 tetrahedra") : tr("%1 vertices, %2 triangles");
    m_counts->setText(text.arg(locale.toString(frame->used), locale.toString(frame->cells)));
}

}  // namespace wend
