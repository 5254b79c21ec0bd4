#include "app/panels/mesh_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLocale>
#include <QStandardItemModel>
#include <QToolButton>
#include <cmath>

#include "app/document/options.h"
#include "app/panels/detail_row.h"
#include "app/panels/jump_slider.h"
#include "app/panels/magnitude_box.h"
#include "app/panels/number_box.h"
#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr int kFewest = 200, kMost = 100000;

// The density slider covers what is usual and is logarithmic: equal ways double the mesh equally.
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

/// The greatest cell that there is now, to two digits.
double greatestVolume(const PosedFrame<3>& frame) {
    double greatest = 0;
    for (const Cell<3>& cell : frame.rest->cells)
        greatest = std::max(greatest, std::abs(cellMeasure<3>(frame.rest->points, cell)));
    const double unit = std::pow(10, std::floor(std::log10(greatest)) - 1);
    return std::ceil(greatest / unit) * unit;
}

}  // namespace

MeshPanel::MeshPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_outline(new QComboBox(this)),
      m_threshold(new NumberBox(this)),
      m_margin(new NumberBox(this)),
      m_border(new QComboBox(this)),
      m_vertices(new QSpinBox(this)),
      m_density(new JumpSlider(this)),
      m_quality(new NumberBox(this)),
      m_refine(new QCheckBox(tr("Refine s&urface"), this)),
      m_fit(new QComboBox(this)),
      m_aim(new QComboBox(this)),
      m_volume(new MagnitudeBox(this)),
      m_sizes(new QToolButton(this)),
      m_detail(new DetailRow(this)),
      m_counts(secondLabel({}, this)) {
    makeControls();
    makeSolidControls();
    arrange();
    connectControls();
    connectSolidControls();
    connect(&m_session.document(), &Document::projectChanged, this, &MeshPanel::showProject);
    connect(&m_session, &ShapeSession::frameChanged, this, &MeshPanel::showCounts);
    showProject();
}

void MeshPanel::makeControls() {
    m_outline->addItem(tr("Cut-out"), static_cast<int>(OutlineKind::Alpha));
    m_outline->addItem(tr("Whole picture"), static_cast<int>(OutlineKind::Frame));
    m_outline->setFixedWidth(150);
    describe(m_outline, tr("Outline"),
             tr("What bends: only what is opaque in the picture, or the picture as a whole."));
    m_threshold->setRange(1, 99);
    m_threshold->setDecimals(0);
    m_threshold->setSuffix(tr(" %"));
    m_threshold->setFixedWidth(116);
    describe(m_threshold, tr("Count as solid above"),
             tr("Pixels that are more opaque than this belong to the shape."));
    m_margin->setRange(0, option("domain.outline.margin").range.max);
    m_margin->setDecimals(1);
    m_margin->setSuffix(tr(" px"));
    m_margin->setFixedWidth(116);
    describe(m_margin, tr("Margin"),
             tr("The outline is grown by this much, so that soft edges come along whole."));
    m_border->addItem(tr("Moves freely"), static_cast<int>(Border::Free));
    m_border->addItem(tr("Stays in place"), static_cast<int>(Border::Fixed));
    m_border->addItem(tr("Slides along itself"), static_cast<int>(Border::Slide));
    m_border->setFixedWidth(150);
    m_border->setObjectName(QStringLiteral("border"));
    describe(
        m_border, tr("Picture's border"),
        tr("Holds the frame of a photograph, so that no gap opens beside it: it stays where it is, or its "
           "sides slide along themselves. Pins on it move all the same."));
    const Range vertices = option("domain.vertices").range;
    m_vertices->setRange(int(vertices.min), int(vertices.max));
    m_vertices->setSingleStep(500);
    m_vertices->setGroupSeparatorShown(true);
    m_vertices->setAccelerated(true);
    m_vertices->setFixedWidth(116);
    describe(m_vertices, tr("Vertices"),
             tr("How fine the mesh is. More vertices bend more smoothly and take longer."));
    m_density->setRange(0, 1000);
    describe(m_density, tr("Detail: coarse – fine"), m_vertices->statusTip());
}

void MeshPanel::makeSolidControls() {
    m_fit->addItem(tr("Automatic"), static_cast<int>(Fit::Automatic));
    m_fit->addItem(tr("Exact surface"), static_cast<int>(Fit::Exact));
    m_fit->addItem(tr("Cage"), static_cast<int>(Fit::Cage));
    m_fit->setFixedWidth(150);
    describe(m_fit, tr("Fit"),
             tr("What is filled: the surface itself, or a cage of even cells around it, in which it rides. "
                "Automatic takes the cage where the surface cannot be filled or has far too many vertices."));
    m_aim->addItems({tr("Vertices"), tr("Greatest volume")});
    m_aim->setFixedWidth(150);
    describe(m_aim, tr("Aim"),
             tr("What says how fine the mesh is: how many vertices it has in all, or how large a "
                "tetrahedron may be."));
    m_volume->setFixedWidth(116);
    describe(m_volume, tr("Greatest volume"),
             tr("Larger tetrahedra are split; in cubed units of the file. Half of it makes about twice as "
                "many. At a surface that is kept some may stay larger."));
    m_sizes->setText(tr("Paint…"));
    m_sizes->setObjectName(QStringLiteral("paintSizes"));
    m_sizes->setProperty("role", "chip");
    describe(m_sizes, tr("Cell sizes"),
             tr("Paints where the mesh is to be finer or coarser, or says it by regions in numbers."));
    m_quality->setRange(1.2, 4);
    m_quality->setDecimals(2);
    m_quality->setSingleStep(0.1);
    m_quality->setFixedWidth(116);
    describe(
        m_quality, tr("Roundness"),
        tr("How flat the tetrahedra may be: the greatest ratio of circumradius to shortest edge. Smaller "
           "is rounder and takes more of them."));
    describe(
        m_refine, tr("Refine surface"),
        tr("Lets the triangles of the surface be split where they are larger than the tetrahedra inside. "
           "Off, the surface is kept exactly as it is."));
}

void MeshPanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Mesh"), this));
    const auto row = [&](const QString& label, QWidget* control) {
        auto* widget = new QWidget(this);
        auto* line = panelRow(label, control, widget);
        line->setContentsMargins(0, 0, 0, 0);
        widget->setLayout(line);
        layout->addWidget(widget);
        return widget;
    };
    m_pictureRows = {row(tr("&Outline"), m_outline), row(tr("Count as so&lid above"), m_threshold),
                     row(tr("Ma&rgin"), m_margin), row(tr("&Border"), m_border)};
    QWidget* fit = row(tr("F&it"), m_fit);
    QWidget* aim = row(tr("A&im at"), m_aim);
    QWidget* vertices = row(tr("Det&ail, in vertices"), m_vertices);
    layout->addWidget(m_density);
    QWidget* volume = row(tr("&Greatest volume"), m_volume);
    QWidget* quality = row(tr("R&oundness"), m_quality);
    layout->addWidget(m_refine);
    QWidget* sizes = row(tr("Finer and coarser"), m_sizes);
    layout->addWidget(m_detail);
    m_solidRows = {fit, aim, quality, m_refine, sizes};
    m_surfaceRows = {vertices, m_density};
    m_volumeRows = {volume};
    layout->addWidget(m_counts);
}

void MeshPanel::connectControls() {
    connect(m_outline, &QComboBox::activated, this, [this] {
        const auto kind = static_cast<OutlineKind>(m_outline->currentData().toInt());
        if (m_session.document().project()->domain.outline == kind) return;
        edit(tr("Change outline"), {}, [kind](Domain& domain) { domain.outline = kind; });
    });
    connect(m_threshold, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("Change what counts as solid"), QStringLiteral("threshold"),
             [value](Domain& d) { d.alpha.threshold = value / 100; });
    });
    connect(m_margin, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("Change margin"), QStringLiteral("margin"), [value](Domain& d) { d.alpha.margin = value; });
    });
    connect(m_border, &QComboBox::activated, this, [this] {
        const auto border = static_cast<Border>(m_border->currentData().toInt());
        if (m_session.document().project()->domain.border == border) return;
        edit(tr("Hold the border"), {}, [border](Domain& domain) { domain.border = border; });
    });
    const auto setVertices = [this](int count) {
        edit(tr("Change detail"), QStringLiteral("vertices %1").arg(m_gesture), [count](Domain& domain) {
            domain.vertices = count;
            domain.edge = 0;
            domain.maxVolume = 0;
        });
    };
    connect(m_vertices, &QSpinBox::valueChanged, this, setVertices);
    connect(m_density, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(m_density, &QSlider::valueChanged, this,
            [setVertices](int value) { setVertices(verticesOf(value)); });
}

void MeshPanel::connectSolidControls() {
    connect(m_quality, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("Change roundness"), QStringLiteral("quality"), [value](Domain& d) { d.quality = value; });
    });
    connect(m_refine, &QCheckBox::clicked, this, [this](bool on) {
        edit(on ? tr("Refine surface") : tr("Keep surface"), {},
             [on](Domain& domain) { domain.refineSurface = on; });
    });
    connect(m_fit, &QComboBox::activated, this, [this] {
        const auto fit = static_cast<Fit>(m_fit->currentData().toInt());
        if (m_session.document().project()->domain.fit == fit) return;
        edit(tr("Change fit"), {}, [fit](Domain& domain) { domain.fit = fit; });
    });
    connect(m_aim, &QComboBox::activated, this, [this](int aim) { setAim(aim == ByVolume); });
    connect(m_volume, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("Change greatest volume"), QStringLiteral("maxVolume"),
             [value](Domain& d) { d.maxVolume = value; });
    });
    connect(m_sizes, &QToolButton::clicked, this, &MeshPanel::sizesWanted);
    connect(m_detail, &DetailRow::wanted, this, &MeshPanel::detailWanted);
    connect(m_detail, &DetailRow::removed, this, &MeshPanel::detailRemoved);
}

/// Begins with the volume that the mesh has now, so that it stays about as fine.
void MeshPanel::setAim(bool volume) {
    const bool isVolume = m_session.document().project()->domain.maxVolume > 0;
    if (volume == isVolume) return;
    const auto frame = m_session.frame<3>();
    if (volume && !frame) {
        showProject();
        return;
    }
    const double greatest = volume ? greatestVolume(*frame) : 0;
    edit(volume ? tr("Aim at a volume") : tr("Aim at vertices"), {},
         [greatest](Domain& domain) { domain.maxVolume = greatest; });
}

template <class Edit>
void MeshPanel::edit(const QString& name, const QString& key, Edit change) {
    Document& document = m_session.document();
    if (document.isEmpty()) return;
    Project next = *document.project();
    change(next.domain);
    document.change(name, std::move(next), key);
}

void MeshPanel::showProject() {
    const bool empty = m_session.document().isEmpty();
    const bool picture = !empty && m_session.document().project()->domain.kind == DomainKind::Image;
    const bool solid = m_session.document().dimension() == 3;
    showRows();
    setEnabled(solid || picture);
    if (solid) {
        showSolid(m_session.document().project()->domain);
        return;
    }
    setToolTip(empty || picture ? QString() : tr("The mesh comes from a file and is used as it is."));
    if (empty) return;
    const Domain& domain = m_session.document().project()->domain;
    const QSignalBlocker a(m_threshold), b(m_margin), c(m_vertices), d(m_density);
    const bool hasAlpha = m_session.document().picture() && m_session.document().picture()->alpha;
    auto* model = qobject_cast<QStandardItemModel*>(m_outline->model());
    model->item(0)->setEnabled(hasAlpha);
    model->item(0)->setToolTip(hasAlpha ? QString() : tr("This picture has no transparency."));
    const int polygons = m_outline->findData(static_cast<int>(OutlineKind::Polygons));
    if (domain.outline == OutlineKind::Polygons && polygons < 0)
        m_outline->addItem(tr("Drawn polygons"), static_cast<int>(OutlineKind::Polygons));
    m_outline->setCurrentIndex(m_outline->findData(static_cast<int>(domain.outline)));
    const bool alpha = domain.outline == OutlineKind::Alpha;
    m_threshold->setEnabled(alpha);
    m_margin->setEnabled(alpha);
    m_threshold->setValue(domain.alpha.threshold * 100);
    m_margin->setValue(domain.alpha.margin);
    m_border->setCurrentIndex(m_border->findData(static_cast<int>(domain.border)));
    m_vertices->setValue(domain.vertices);
    if (!m_density->isSliderDown()) m_density->setValue(sliderOf(domain.vertices));
}

/// What stays is not hidden in between, since its field would lose the keyboard.
void MeshPanel::showRows() {
    const Document& document = m_session.document();
    const bool solid = document.dimension() == 3;
    const bool surface = solid && document.project()->domain.kind == DomainKind::Surface;
    const bool volume = surface && document.project()->domain.maxVolume > 0;
    const auto show = [](const std::vector<QWidget*>& rows, bool visible) {
        for (QWidget* row : rows) row->setVisible(visible);
    };
    show(m_pictureRows, !solid);
    show(m_surfaceRows, !solid || (surface && !volume));
    show(m_solidRows, surface);
    show(m_volumeRows, volume);
    m_detail->setVisible(solid);
}

void MeshPanel::showSolid(const Domain& domain) {
    const bool surface = domain.kind == DomainKind::Surface;
    const bool volume = domain.maxVolume > 0;
    setToolTip(surface ? QString() : tr("The mesh comes from a file and is used as it is."));
    const QSignalBlocker a(m_vertices), b(m_density), c(m_quality), d(m_volume);
    m_fit->setCurrentIndex(m_fit->findData(static_cast<int>(domain.fit)));
    m_aim->setCurrentIndex(volume ? ByVolume : ByVertices);
    if (volume) m_volume->setValue(domain.maxVolume);
    m_detail->showDomain(domain);
    m_quality->setValue(domain.quality);
    m_refine->setChecked(domain.refineSurface);
    m_vertices->setValue(domain.vertices);
    if (!m_density->isSliderDown()) m_density->setValue(sliderOf(domain.vertices));
}

void MeshPanel::showCounts() {
    const FramePtr& frame = m_session.frame();
    if (!frame) {
        m_counts->clear();
        return;
    }
    const QLocale locale;
    const QString text =
        frame->dimension == 3 ? tr("%1 vertices, %2 tetrahedra") : tr("%1 vertices, %2 triangles");
    m_counts->setText(text.arg(locale.toString(frame->vertices), locale.toString(frame->cells)));
}

}  // namespace wend
