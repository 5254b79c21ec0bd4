#pragma once

#include <QWidgetAction>
#include <functional>

class QSpinBox;

namespace wend {

/// A number field beside a tool's name.
class NumberAction : public QWidgetAction {
  public:
    struct Range {
        int least, most, step = 1;
    };
    /// `take` gets the numbers that the user sets.
    NumberAction(const QString& name, const QString& help, const QString& unit, const Range& range,
                 QObject* parent, std::function<void(int)> take);
    QSpinBox& box() const { return *m_box; }
    /// Sets the number without a signal.
    void put(double value);

  private:
    QSpinBox* m_box;
};

}  // namespace wend
