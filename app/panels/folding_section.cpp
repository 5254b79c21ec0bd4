#include "app/panels/folding_section.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "app/panels/fields/panel_parts.h"

namespace wend {

FoldingSection::FoldingSection(const QString& title, const QString& help, const QString& name,
                               QWidget* parent)
    : QWidget(parent),
      m_title(new QToolButton(this)),
      m_body(new QWidget(this)),
      m_parts(new QVBoxLayout(m_body)),
      m_isOpen(QStringLiteral("open/") + name) {
    setObjectName(name);
    m_title->setText(title);
    m_title->setCheckable(true);
    m_title->setProperty("role", "fold");
    m_title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_title->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe(m_title, title, help);
    m_parts->setContentsMargins(0, 0, 0, 0);
    m_parts->setSpacing(0);
    auto* column = bareColumn(this, 0);
    column->addWidget(m_title);
    column->addWidget(m_body);
    connect(m_title, &QToolButton::toggled, this, [this](bool open) {
        m_body->setVisible(open);
        m_title->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        m_isOpen.set(open);
    });
    m_title->setArrowType(Qt::RightArrow);
    m_body->hide();
    m_title->setChecked(m_isOpen.value());
}

void FoldingSection::add(QWidget* part) {
    m_parts->addWidget(part);
}

bool FoldingSection::isOpen() const {
    return m_title->isChecked();
}

void FoldingSection::setOpen(bool open) {
    m_title->setChecked(open);
}

}  // namespace wend
