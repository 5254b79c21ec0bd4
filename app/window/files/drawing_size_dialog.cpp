#include "app/window/files/drawing_size_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <cmath>

#include "warp/image.h"

namespace wend {
namespace {

QSpinBox* sideBox(int now, int other, QWidget* parent) {
    auto* box = new QSpinBox(parent);
    const double longest = std::sqrt(1e6 * kMaxMegapixels * now / other);
    box->setRange(1, static_cast<int>(longest));
    box->setValue(now);
    box->setSuffix(DrawingSizeDialog::tr(" px"));
    box->setSingleStep(100);
    return box;
}

QDoubleSpinBox* percentBox(const DrawnSize& now, const DrawnSize& first, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setDecimals(1);
    box->setRange(0.1, 100 * std::sqrt(1e6 * kMaxMegapixels / first[0] / first[1]));
    box->setValue(100.0 * now[0] / first[0]);
    box->setSuffix(DrawingSizeDialog::tr(" %"));
    box->setSingleStep(50);
    return box;
}

}  // namespace

DrawingSizeDialog::DrawingSizeDialog(const DrawnSize& now, const DrawnSize& first, QWidget* parent)
    : QDialog(parent),
      m_first(first),
      m_width(sideBox(now[0], now[1], this)),
      m_height(sideBox(now[1], now[0], this)),
      m_percent(percentBox(now, first, this)) {
    setWindowTitle(tr("Drawing Size"));
    auto* help =
        new QLabel(tr("The drawing becomes a picture of this size. Pins, paths and regions are scaled with "
                      "it; exported SVG files keep the drawing's own units."),
                   this);
    help->setWordWrap(true);
    auto* form = new QFormLayout(this);
    form->addRow(help);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Height"), m_height);
    form->addRow(tr("&Scale"), m_percent);
    m_percent->setToolTip(tr("Of the size at which the drawing is opened"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    const double proportion = static_cast<double>(now[1]) / now[0];
    tie(m_width, m_height, proportion);
    tie(m_height, m_width, 1 / proportion);
    connect(m_percent, &QDoubleSpinBox::valueChanged, this, &DrawingSizeDialog::takePercent);
    m_width->selectAll();
}

/// Lets the other side follow one, and the percent.
void DrawingSizeDialog::tie(QSpinBox* side, QSpinBox* other, double proportion) {
    connect(side, &QSpinBox::valueChanged, this, [=, this](int value) {
        const QSignalBlocker blocker(other), also(m_percent);
        other->setValue(static_cast<int>(std::lround(value * proportion)));
        m_percent->setValue(100.0 * m_width->value() / m_first[0]);
    });
}

void DrawingSizeDialog::takePercent(double percent) {
    const QSignalBlocker blocker(m_width), also(m_height);
    m_width->setValue(static_cast<int>(std::lround(percent / 100 * m_first[0])));
    m_height->setValue(static_cast<int>(std::lround(percent / 100 * m_first[1])));
}

DrawnSize DrawingSizeDialog::size() const {
    return {m_width->value(), m_height->value()};
}

}  // namespace wend
