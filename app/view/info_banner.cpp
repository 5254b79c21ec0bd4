#include "app/view/info_banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "core/mesh/printable.h"

namespace wend {

InfoBanner::InfoBanner(QWidget* parent) : QWidget(parent), m_text(new QLabel(this)) {
    setObjectName(QStringLiteral("infoBanner"));
    setAttribute(Qt::WA_StyledBackground);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);  // names from files are no HTML
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setToolTip(tr("Close this message"));
    close->setAccessibleName(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 8, 8);
    row->addWidget(m_text, 1);
    row->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void InfoBanner::showText(const QString& text) {
    QStringList lines = text.split('\n');
    for (QString& line : lines) line = QString::fromStdString(printable(line.toStdString()));
    m_text->setText(lines.join('\n'));
    m_text->setAccessibleName(m_text->text());
    setVisible(!text.isEmpty());
}

QString InfoBanner::text() const {
    return isHidden() ? QString() : m_text->text();
}

}  // namespace wend
