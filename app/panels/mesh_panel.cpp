#include "app/panels/mesh_panel.h"

#include <QComboBox>
#include <QLocale>
#include <QSlider>
#include <QStandardItemModel>
#include <cmath>

#include "app/document/options.h"
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

}  // namespace

MeshPanel::MeshPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_outline(new QComboBox(this)),
      m_threshold(new QDoubleSpinBox(this)),
      m_margin(new QDoubleSpinBox(this)),
      m_vertices(new QSpinBox(this)),
      m_density(new QSlider(Qt::Horizontal, this)),
      m_counts(secondLabel({}, this)) {
    makeControls();
    arrange();
    connectControls();
    connect(&m_session.document(), &Document::projectChanged, this, &MeshPanel::showProject);
    connect(&m_session, &ShapeSession::frameChanged, this, &MeshPanel::showCounts);
    showProject();
}

void MeshPanel::makeControls() {
    m_outline->addItem(tr("Opaque part"), static_cast<int>(OutlineKind::Alpha));
    m_outline->addItem(tr("Whole picture"), static_cast<int>(OutlineKind::Frame));
    m_outline->setFixedWidth(150);
    describe(m_outline, tr("Outline"),
             tr("What bends: only what is opaque in the picture, or the picture as a whole."));
    m_threshold->setRange(1, 99);
    m_threshold->setDecimals(0);
    m_threshold->setSuffix(tr(" %"));
    m_threshold->setFixedWidth(116);
    describe(m_threshold, tr("Threshold"), tr("Pixels that are more opaque than this belong to the shape."));
    m_margin->setRange(0, option("domain.outline.margin").range.max);
    m_margin->setDecimals(1);
    m_margin->setSuffix(tr(" px"));
    m_margin->setFixedWidth(116);
    describe(m_margin, tr("Margin"),
             tr("The outline is grown by this much, so that soft edges come along whole."));
    const Range vertices = option("domain.vertices").range;
    m_vertices->setRange(int(vertices.min), int(vertices.max));
    m_vertices->setSingleStep(500);
    m_vertices->setGroupSeparatorShown(true);
    m_vertices->setAccelerated(true);
    m_vertices->setKeyboardTracking(false);
    m_vertices->setFixedWidth(116);
    describe(m_vertices, tr("Vertices"),
             tr("How fine the mesh is. More vertices bend more smoothly and take longer."));
    m_density->setRange(0, 1000);
    describe(m_density, tr("Mesh density"), m_vertices->statusTip());
}

void MeshPanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Mesh"), this));
    layout->addLayout(panelRow(tr("&Outline"), m_outline, this));
    layout->addLayout(panelRow(tr("&Threshold"), m_threshold, this));
    layout->addLayout(panelRow(tr("Ma&rgin"), m_margin, this));
    layout->addLayout(panelRow(tr("&Vertices"), m_vertices, this));
    layout->addWidget(m_density);
    layout->addWidget(m_counts);
}

void MeshPanel::connectControls() {
    connect(m_outline, &QComboBox::activated, this, [this] {
        const auto kind = static_cast<OutlineKind>(m_outline->currentData().toInt());
        if (m_session.document().project()->domain.outline == kind) return;
        edit(tr("Change outline"), {}, [kind](Domain& domain) { domain.outline = kind; });
    });
    connect(m_threshold, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("Change threshold"), QStringLiteral("threshold"),
             [value](Domain& d) { d.alpha.threshold = value / 100; });
    });
    connect(m_margin, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("Change margin"), QStringLiteral("margin"), [value](Domain& d) { d.alpha.margin = value; });
    });
    const auto setVertices = [this](int count) {
        edit(tr("Change mesh density"), QStringLiteral("vertices %1").arg(m_gesture),
             [count](Domain& domain) {
                 domain.vertices = count;
                 domain.edge = 0;
             });
    };
    connect(m_vertices, &QSpinBox::valueChanged, this, setVertices);
    connect(m_density, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(m_density, &QSlider::valueChanged, this,
            [setVertices](int value) { setVertices(verticesOf(value)); });
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
    setEnabled(picture);
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
    m_counts->setText(
        tr("%1 vertices, %2 triangles")
            .arg(locale.toString(frame->rest->vertexCount()), locale.toString(frame->rest->cellCount())));
}

}  // namespace wend
