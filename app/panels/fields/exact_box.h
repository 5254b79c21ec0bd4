#pragma once

#include "app/panels/fields/number_box.h"

namespace wend {

/// A number box that keeps more digits than it shows: until the user enters another number, exact() returns
/// the number that was set. Text that is being typed survives updates with the same number.
class ExactBox : public NumberBox {
  public:
    using NumberBox::NumberBox;

    /// Sets the number without a signal.
    void put(double number);
    /// Sets the number of decimals and shows the number with them.
    void showDigits(int decimals);
    double exact() const { return value() == m_shown ? m_exact : value(); }

  private:
    double m_exact = 0, m_shown = 0;  // m_shown: m_exact as the box rounds it
};

}  // namespace wend
