#include "app/window/actions/number_action.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <cmath>

#include "app/panels/fields/panel_parts.h"

namespace wend {

NumberAction::NumberAction(const QString& name, const QString& help, const QString& unit, const Range& range,
                           QObject* parent, std::function<void(int)> take)
    : QWidgetAction(parent), m_box(new QSpinBox) {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(8, 0, 8, 0);
    m_box->setSuffix(unit);
    m_box->setRange(range.least, range.most);
    m_box->setSingleStep(range.step);
    m_box->setKeyboardTracking(false);
    describe(m_box, name, help);
    auto* label = new QLabel(name);
    label->setBuddy(m_box);
    row->addWidget(label);
    row->addWidget(m_box);
    setText(name);
    setDefaultWidget(holder);
    connect(m_box, &QSpinBox::valueChanged, this, std::move(take));
}

void NumberAction::put(double value) {
    const QSignalBlocker quiet(m_box);
    m_box->setValue(static_cast<int>(std::lround(value)));
}

}  // namespace wend
