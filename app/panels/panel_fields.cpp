#include "app/panels/panel_fields.h"

#include <QAbstractSpinBox>
#include <QWidget>

namespace wend {

PanelFields::PanelFields(QWidget& panels) : QObject(&panels) {
    for (auto* box : panels.findChildren<QAbstractSpinBox*>())
        box->setKeyboardTracking(false);  // a change is shown again, and not while the number is being typed
}

}  // namespace wend
