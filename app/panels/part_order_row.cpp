#include "app/panels/part_order_row.h"

#include <QLocale>
#include <QToolButton>

#include "app/panels/fields/panel_parts.h"
#include "app/project/domain.h"
#include "app/project/edits/part_edits.h"
#include "app/session/shape_session.h"

namespace wend {

PartOrderRow::PartOrderRow(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_front(new QToolButton(this)),
      m_back(new QToolButton(this)),
      m_never(new QToolButton(this)),
      m_times(secondLabel({}, this)) {
    const auto chip = [](QToolButton* button, const char* id, const QString& text, const QString& help) {
        button->setObjectName(QString::fromLatin1(id));
        button->setText(text);
        button->setProperty("role", "chip");
        describe(button, text, help);
    };
    chip(m_front, "partFrontFromHere", tr("In Front from Here"),
         tr("From the shown time on the part is in front of all others; before, it stays where it is."));
    chip(m_back, "partBehindFromHere", tr("Behind from Here"),
         tr("From the shown time on the part is behind all others; before, it stays where it is."));
    chip(m_never, "partOrderNever", tr("Never"), tr("Removes all changes of the order of this part."));
    m_times->setObjectName(QStringLiteral("partOrderTimes"));
    auto* column = bareColumn(this, 6);
    column->addLayout(sideBySide({m_front, nullptr}));
    column->addLayout(sideBySide({m_back, nullptr}));
    column->addLayout(sideBySide({m_times, nullptr, m_never}));
    connect(m_front, &QToolButton::clicked, this, [this] { set(true); });
    connect(m_back, &QToolButton::clicked, this, [this] { set(false); });
    connect(m_never, &QToolButton::clicked, this, [this] {
        Domain domain = m_session.document().domain();
        domain.parts.at(static_cast<std::size_t>(m_part)).order.clear();
        m_session.document().changeDomain(tr("Keep the order"), std::move(domain));
    });
}

void PartOrderRow::set(bool front) {
    Document& document = m_session.document();
    const auto count = static_cast<int>(document.domain().parts.size());
    if (m_part < 0 || m_part >= count) return;
    document.change(front ? tr("In front from here on") : tr("Behind from here on"),
                    withPartInFront(*document.project(), m_part, m_session.playback().time(), front));
}

void PartOrderRow::showPart(int part) {
    m_part = part;
    if (part < 0) return;
    QStringList times;
    for (const PartOrder& one : m_session.document().domain().parts.at(static_cast<std::size_t>(part)).order)
        times << tr("%1 s").arg(QLocale().toString(one.time * Playback::kSecondsPerUnit, 'f', 2));
    m_never->setVisible(!times.isEmpty());
    m_times->setVisible(!times.isEmpty());
    m_times->setText(tr("Changes at %1").arg(times.join(QStringLiteral(", "))));
}

}  // namespace wend
