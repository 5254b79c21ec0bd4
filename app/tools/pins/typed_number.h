#pragma once

#include <QKeyEvent>
#include <QString>

namespace wend {

/// A number that is typed while something is dragged, in place of what the pointer says.
class TypedNumber {
  public:
    /// True if the key belongs to a number.
    bool take(const QKeyEvent& key);
    bool isEmpty() const { return m_text.isEmpty(); }
    double value() const { return m_text.toDouble(); }
    void clear() { m_text.clear(); }

  private:
    QString m_text;
};

}  // namespace wend
