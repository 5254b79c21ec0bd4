#include "app/view/picture_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>

#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr int kLargest = 20000;  // pixels; drawn in tiles

}  // namespace

PictureDialog::PictureDialog(const QSize& proposal, bool hasLegend, QWidget* parent)
    : QDialog(parent),
      m_width(new QSpinBox(this)),
      m_height(new QSpinBox(this)),
      m_transparent(new QCheckBox(tr("&Transparent background"), this)),
      m_marks(new QCheckBox(tr("&Pins and axes"), this)),
      m_legend(new QCheckBox(tr("&Legend of the map"), this)) {
    setWindowTitle(tr("Export Picture"));
    for (QSpinBox* box : {m_width, m_height}) {
        box->setRange(16, kLargest);
        box->setSuffix(tr(" px"));
    }
    m_width->setValue(proposal.width());
    m_height->setValue(proposal.height());
    m_transparent->setChecked(true);
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
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    layout->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

PictureChoice PictureDialog::choice() const {
    return {{m_width->value(), m_height->value()},
            m_transparent->isChecked(),
            m_marks->isChecked(),
            m_legend->isChecked()};
}

}  // namespace wend
