#pragma once

#include <QKeyEvent>
#include <QString>

namespace wend {

/// A number typed during a drag, which replaces the pointer's amount.
class TypedNumber {
  public:
    /// Returns whether the key belongs to a number.
    bool take(const QKeyEvent& key);
    bool isEmpty() const { return m_text.isEmpty(); }
    double value() const { return m_text.toDouble(); }
    void clear() { m_text.clear(); }

  private:
    QString m_text;
};

}  // namespace wend
