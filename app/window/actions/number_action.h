#pragma once

#include <QWidgetAction>

class QSpinBox;

namespace wend {

/// A number field beside a tool's name.
class NumberAction : public QWidgetAction {
  public:
    NumberAction(const QString& name, const QString& help, const QString& unit, QObject* parent);
    QSpinBox& box() const { return *m_box; }
    /// Sets the number without a signal.
    void put(double value);

  private:
    QSpinBox* m_box;
};

}  // namespace wend
