#include "app/window/notices/info_banner.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "app/style/theme.h"
#include "core/base/printable.h"

namespace wend {

namespace {

constexpr int kHeight = 44, kSign = 20;  // pixels

/// Returns whether a topic is an offer rather than an error.
bool isOffer(InfoBanner::Topic topic) {
    using enum InfoBanner::Topic;
    return topic == Remark || topic == Lost || topic == Mesh || topic == Border || topic == SoftEdges ||
           topic == LineArt || topic == Parts || topic == Riding || topic == Spring;
}

QString readable(const QString& text) {
    QStringList lines = text.split('\n');
    for (QString& line : lines) line = QString::fromStdString(printable(line.toStdString()));
    return lines.join('\n');
}

}  // namespace

InfoBanner::InfoBanner(QWidget* parent)
    : QWidget(parent),
      m_sign(new QLabel(this)),
      m_text(new QLabel(this)),
      m_close(new QToolButton(this)),
      m_buttons(new QHBoxLayout) {
    setObjectName(QStringLiteral("infoBanner"));
    setAttribute(Qt::WA_StyledBackground);
    setMinimumHeight(kHeight);
    m_sign->setObjectName(QStringLiteral("bannerSign"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);  // names from files are no HTML
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(tr("Close this message"));
    connect(m_close, &QToolButton::clicked, this, [this] {
        if (!m_lines.isEmpty()) m_lines.removeLast();
        showNewest();
    });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 8, 4);
    row->setSpacing(8);
    row->addWidget(m_sign);
    row->addWidget(m_text, 1);
    row->addLayout(m_buttons);
    row->addWidget(m_close);
    showSigns();
    hide();
}

void InfoBanner::tell(Topic topic, const QString& text, const QList<Remedy>& remedies) {
    const auto removed = m_lines.removeIf([topic](const Line& line) { return line.topic == topic; });
    if (text.isEmpty() && removed == 0) return;  // the buttons of another line stay
    if (!text.isEmpty()) m_lines << Line{topic, readable(text), remedies};
    showNewest();
}

void InfoBanner::clear() {
    m_lines.clear();
    showNewest();
}

void InfoBanner::showNewest() {
    while (QLayoutItem* item = m_buttons->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();  // it may be the one that was pressed
        delete item;
    }
    const Line newest = m_lines.isEmpty() ? Line{} : m_lines.last();
    if (const bool offers = isOffer(newest.topic); property("offers").toBool() != offers) {
        setProperty("offers", offers);
        style()->unpolish(this), style()->polish(this);
        showSigns();
    }
    m_text->setText(newest.text);
    m_text->setAccessibleName(newest.text);
    for (const Remedy& remedy : newest.remedies) {
        auto* button = new QPushButton(remedy.text, this);
        m_buttons->addWidget(button);
        connect(button, &QPushButton::clicked, this, remedy.act);
    }
    setVisible(!m_lines.isEmpty());
}

/// Draws the signs, since not every font has letters like them.
void InfoBanner::showSigns() {
    const Theme theme = Theme::of(palette());
    const bool offers = property("offers").toBool();
    const QIcon sign = wendIcon(offers ? QStringLiteral("notice") : QStringLiteral("warning"),
                                offers ? theme.accentText : theme.danger);
    m_sign->setPixmap(sign.pixmap(QSize(kSign, kSign), devicePixelRatioF()));
    m_close->setIcon(wendIcon(QStringLiteral("close"), palette()));
}

void InfoBanner::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showSigns();
}

QString InfoBanner::text() const {
    return m_lines.isEmpty() ? QString() : m_lines.last().text;
}

}  // namespace wend
