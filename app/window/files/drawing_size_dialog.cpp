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

/// Lets another side follow one.
void tie(QSpinBox* side, QSpinBox* other, double proportion) {
    QObject::connect(side, &QSpinBox::valueChanged, other, [other, proportion](int value) {
        const QSignalBlocker blocker(other);
        other->setValue(static_cast<int>(std::lround(value * proportion)));
    });
}

}  // namespace

DrawingSizeDialog::DrawingSizeDialog(const DrawnSize& now, QWidget* parent)
    : QDialog(parent), m_width(sideBox(now[0], now[1], this)), m_height(sideBox(now[1], now[0], this)) {
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
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    const double proportion = static_cast<double>(now[1]) / now[0];
    tie(m_width, m_height, proportion);
    tie(m_height, m_width, 1 / proportion);
    m_width->selectAll();
}

DrawnSize DrawingSizeDialog::size() const {
    return {m_width->value(), m_height->value()};
}

}  // namespace wend
