#include "app/view/picture_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>

#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr int kLargest = 8192;  // what every OpenGL can draw into

}  // namespace

PictureDialog::PictureDialog(const QSize& proposal, QWidget* parent)
    : QDialog(parent),
      m_width(new QSpinBox(this)),
      m_height(new QSpinBox(this)),
      m_transparent(new QCheckBox(tr("&Transparent background"), this)) {
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
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("&Width"), m_width);
    layout->addRow(tr("&Height"), m_height);
    layout->addRow(m_transparent);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    layout->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QSize PictureDialog::size() const {
    return {m_width->value(), m_height->value()};
}

bool PictureDialog::isTransparent() const {
    return m_transparent->isChecked();
}

}  // namespace wend
