#pragma once

#include "app/panels/fields/number_box.h"

namespace wend {

/// A box for a number that has more digits than it shows: until the user writes another one, exact() is the
/// number as it was put. What is being typed stays as long as the number does.
class ExactBox : public NumberBox {
  public:
    using NumberBox::NumberBox;

    /// Tells nobody.
    void put(double number);
    /// Digits behind the point, where they change; what was put is shown with them.
    void showDigits(int decimals);
    double exact() const { return value() == m_shown ? m_exact : value(); }

  private:
    double m_exact = 0, m_shown = 0;  // m_shown: what became of it in the box
};

}  // namespace wend
