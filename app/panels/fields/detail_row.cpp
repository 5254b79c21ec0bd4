#include "app/panels/fields/detail_row.h"

#include <QDir>
#include <QFileInfo>
#include <QToolButton>

#include "app/panels/fields/panel_parts.h"
#include "app/project/domain.h"

namespace wend {

DetailRow::DetailRow(QWidget* parent)
    : QWidget(parent),
      m_name(secondLabel({}, this)),
      m_choose(new QToolButton(this)),
      m_remove(new QToolButton(this)) {
    auto* layout = bareColumn(this, 6);
    m_choose->setText(tr("Choose…"));
    m_choose->setObjectName(QStringLiteral("chooseDetail"));
    m_remove->setText(tr("Remove"));
    m_remove->setObjectName(QStringLiteral("removeDetail"));
    for (QToolButton* button : {m_choose, m_remove}) button->setProperty("role", "chip");
    describe(m_choose, tr("Choose skin"),
             tr("Takes a detailed, perhaps textured surface from a file and embeds it in the solid; the view "
                "shows it, and surface formats contain it."));
    describe(m_remove, tr("Remove skin"), tr("Shows and exports the solid with its own surface again."));
    layout->addLayout(panelRow(tr("Skin"), m_choose, this));
    auto* row = new QHBoxLayout;
    row->addWidget(m_name, 1);
    row->addWidget(m_remove);
    layout->addLayout(row);
    connect(m_choose, &QToolButton::clicked, this, &DetailRow::wanted);
    connect(m_remove, &QToolButton::clicked, this, &DetailRow::removed);
}

void DetailRow::showDomain(const Domain& domain) {
    const QString path = QString::fromStdString(domain.detail);
    m_name->setText(QFileInfo(path).fileName());
    m_name->setToolTip(QDir::toNativeSeparators(path));
    m_name->setVisible(!path.isEmpty());
    m_remove->setVisible(!path.isEmpty());
}

}  // namespace wend
