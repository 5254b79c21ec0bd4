#include "app/panels/paint_panel.h"

#include <QStackedWidget>
#include <algorithm>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/stiffness_fields.h"

namespace wend {

namespace {

/// A direction of the list: a source, or an axis.
constexpr int kFirstAxis = 100;

int keyOf(const BrushSettings& brush) {
    if (brush.along != StiffAlong::Axis) return static_cast<int>(brush.along);
    for (int k = 0; k < 3; ++k)
        if (brush.axis == Vec3::Unit(k)) return kFirstAxis + k;
    return static_cast<int>(StiffAlong::Axis);
}

}  // namespace

PaintPanel::PaintPanel(Document& document, Brush& brush, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_brush(brush),
      m_pages(new QStackedWidget(this)),
      m_phi(new EnergySlider(this)),
      m_ratio(stiffnessField(
          tr("How many times stiffer the painted part is along its direction; ×1 is the same as everywhere."),
          this)),
      m_direction(choiceBox(
          this, "", tr("Stiff direction"),
          tr("The direction at rest, which turns with the shape: the stroke's own, the one that is there, "
             "an axis, numbers, or the path of the selected pin where it is nearest."),
          {}, &PaintPanel::chooseDirection)),
      m_numbersRow(new QWidget(this)) {
    makeControls();
    arrange();
    setDimension(2);
    connectControls();
    showBrush();
}

void PaintPanel::makeControls() {
    m_phi->setName(tr("What the brush paints"));
    m_ratio->setObjectName(QStringLiteral("brushRatio"));
    fitToEntries(m_direction, 150);
    auto* row = new QHBoxLayout(m_numbersRow);
    row->setContentsMargins(0, 0, 0, 0);
    m_numbers =
        directionFields(tr("Direction in numbers"), tr("At rest; its length does not matter."), m_numbersRow);
    for (ExactBox* box : m_numbers) row->addWidget(box);
}

QWidget* PaintPanel::stiffPage() {
    auto* page = new QWidget(this);
    auto* layout = bareColumn(page, 8);
    layout->addLayout(panelRow(tr("St&iffness"), m_ratio, page));
    layout->addLayout(panelRow(tr("Di&rection"), m_direction, page));
    layout->addWidget(m_numbersRow);
    layout->addStretch(1);
    return page;
}

void PaintPanel::arrange() {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("The brush paints"), this));
    m_pages->addWidget(m_phi);
    m_pages->addWidget(stiffPage());
    layout->addWidget(m_pages);
}

template <class Change>
void PaintPanel::change(const Change& change) {
    BrushSettings next = m_brush.now();
    change(next);
    m_brush.set(next);
}

void PaintPanel::connectControls() {
    connect(&m_brush, &Brush::changed, this, &PaintPanel::showBrush);
    connect(&m_document, &Document::opened, this, [this] {
        if (!m_document.isEmpty()) setDimension(m_document.dimension());
    });
    connect(m_phi, &EnergySlider::phiChosen, this,
            [this](double phi) { change([&](BrushSettings& brush) { brush.phi = phi; }); });
    connect(m_ratio, &QDoubleSpinBox::valueChanged, this,
            [this] { change([&](BrushSettings& brush) { brush.ratio = m_ratio->exact(); }); });
    whenChanged(m_numbers, this, [this] {
        change([&](BrushSettings& brush) {
            brush.along = StiffAlong::Axis;
            for (int k = 0; k < 3; ++k) brush.axis[k] = m_numbers[k]->exact();
        });
    });
}

void PaintPanel::setDimension(int dimension) {
    if (dimension == m_dimension) return;
    m_dimension = dimension;
    m_phi->setDimension(dimension);
    m_numbers[2]->setVisible(dimension == 3);
    fillDirections();
    change([&](BrushSettings& brush) {
        brush.phi = std::min(brush.phi, phi::conformal(dimension));
        if (dimension == 3) return;
        brush.axis[2] = 0;
        if (brush.axis.isZero()) brush.axis = Vec3::UnitX();
        if (brush.along == StiffAlong::View) brush.along = StiffAlong::Stroke;
    });
    showBrush();
}

void PaintPanel::fillDirections() {
    m_direction->clear();
    const auto add = [this](const QString& name, int key) { m_direction->addItem(name, key); };
    const auto addAlong = [&](const QString& name, StiffAlong along) { add(name, static_cast<int>(along)); };
    addAlong(tr("along the stroke"), StiffAlong::Stroke);
    addAlong(tr("as it is there"), StiffAlong::AsItIs);
    add(tr("along X"), kFirstAxis);
    add(tr("along Y"), kFirstAxis + 1);
    if (m_dimension == 3) add(tr("along Z"), kFirstAxis + 2);
    addAlong(tr("as numbers"), StiffAlong::Axis);
    if (m_dimension == 3) addAlong(tr("along the view"), StiffAlong::View);
    addAlong(tr("along the pin's path"), StiffAlong::Way);
}

void PaintPanel::chooseDirection(int index) {
    const int key = m_direction->itemData(index).toInt();
    change([&](BrushSettings& brush) {
        brush.along = key >= kFirstAxis ? StiffAlong::Axis : static_cast<StiffAlong>(key);
        if (key >= kFirstAxis) brush.axis = Vec3::Unit(key - kFirstAxis);
    });
    // Numbers that are an axis are still numbers.
    m_direction->setCurrentIndex(index);
    m_numbersRow->setVisible(m_brush.now().along == StiffAlong::Axis);
}

void PaintPanel::showBrush() {
    const BrushSettings& brush = m_brush.now();
    m_pages->setCurrentIndex(brush.target == BrushTarget::Keep ? 0 : 1);
    m_phi->setPhi(brush.phi);
    m_ratio->put(brush.ratio);
    if (!m_numbersRow->isAncestorOf(focusWidget()) || brush.along != StiffAlong::Axis)
        m_direction->setCurrentIndex(m_direction->findData(keyOf(brush)));
    for (int k = 0; k < 3; ++k) m_numbers[k]->put(brush.axis[k]);
    m_numbersRow->setVisible(brush.along == StiffAlong::Axis);
}

}  // namespace wend
