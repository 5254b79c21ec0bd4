#include "app/view/picture_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <cmath>

#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr int kSmallest = 16, kLargest = 20000;  // pixels; drawn in tiles
constexpr int kTyped = 9999999;                  // what may be written and is then told to be too large

}  // namespace

PictureDialog::PictureDialog(const QSize& proposal, bool hasLegend, QWidget* parent)
    : QDialog(parent),
      m_proportions(proposal),
      m_width(new QSpinBox(this)),
      m_height(new QSpinBox(this)),
      m_tied(new QCheckBox(tr("&Proportions of the view"), this)),
      m_note(new QLabel(this)),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this)),
      m_transparent(new QCheckBox(tr("&Transparent background"), this)),
      m_marks(new QCheckBox(tr("P&ins and axes"), this)),
      m_legend(new QCheckBox(tr("&Legend of the map"), this)) {
    setWindowTitle(tr("Export Picture"));
    for (QSpinBox* box : {m_width, m_height}) {
        box->setRange(1, kTyped);
        box->setSuffix(tr(" px"));
    }
    m_width->setValue(proposal.width());
    m_height->setValue(proposal.height());
    m_transparent->setChecked(true);
    m_tied->setChecked(true);
    describe(m_tied, tr("Proportions of the view"),
             tr("Width and height follow each other, so that the picture shows what the view shows."));
    describe(m_width, tr("Width"), tr("Width of the picture in pixels."));
    describe(m_height, tr("Height"),
             tr("Height of the picture in pixels; it decides how large the solid is."));
    describe(m_transparent, tr("Transparent background"), tr("Only the solid, on nothing."));
    describe(m_marks, tr("Pins and axes"), tr("Pins, their paths and the axes, as large as in the window."));
    describe(m_legend, tr("Legend of the map"),
             hasLegend ? tr("The colours of the map and their values.")
                       : tr("Show a map first: only then there is something to explain."));
    m_legend->setEnabled(hasLegend);
    m_legend->setChecked(hasLegend);
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("&Width"), m_width);
    layout->addRow(tr("&Height"), m_height);
    for (QCheckBox* box : {m_transparent, m_marks, m_legend}) layout->addRow(box);
    m_note->setObjectName(QStringLiteral("sizeNote"));
    m_note->setWordWrap(true);
    layout->insertRow(2, m_tied);
    layout->insertRow(3, m_note);
    layout->addRow(m_buttons);
    for (QSpinBox* box : {m_width, m_height})
        connect(box, &QSpinBox::valueChanged, this, [this, box] { tie(box); });
    connect(m_tied, &QCheckBox::toggled, this, [this] { tie(m_width); });
    check();
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// The other one follows.
void PictureDialog::tie(QSpinBox* changed) {
    const bool width = changed == m_width;
    const double of = width ? m_proportions.width() : m_proportions.height();
    const double other = width ? m_proportions.height() : m_proportions.width();
    if (m_tied->isChecked() && of > 0) {
        QSpinBox* follower = width ? m_height : m_width;
        const QSignalBlocker quiet(follower);
        follower->setValue(static_cast<int>(std::lround(changed->value() * other / of)));
    }
    check();
}

void PictureDialog::check() {
    const auto fits = [](const QSpinBox* box) {
        return box->value() >= kSmallest && box->value() <= kLargest;
    };
    const bool good = fits(m_width) && fits(m_height);
    const QLocale locale;
    m_note->setText(good ? QString()
                         : tr("Width and height must be between %1 and %2 pixels.")
                               .arg(locale.toString(kSmallest), locale.toString(kLargest)));
    m_note->setVisible(!good);
    m_buttons->button(QDialogButtonBox::Save)->setEnabled(good);
}

PictureChoice PictureDialog::choice() const {
    return {{m_width->value(), m_height->value()},
            m_transparent->isChecked(),
            m_marks->isChecked(),
            m_legend->isChecked()};
}

}  // namespace wend
