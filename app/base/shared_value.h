#pragma once

#include <QObject>

namespace wend {

/// Tells that something of it has changed.
class Changing : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

  signals:
    void changed();
};

inline double bounded(double value) {
    return value;
}

/// A value that tools and panels share, kept within its bounds.
template <class Value>
class SharedValue : public Changing {
  public:
    explicit SharedValue(const Value& value = {}, QObject* parent = nullptr)
        : Changing(parent), m_now(value) {}
    const Value& now() const { return m_now; }
    void set(const Value& value) {
        const Value next = bounded(value);
        if (next == m_now) return;
        m_now = next;
        emit changed();
    }
    /// Changes one member, given by its pointer.
    template <class Member, class Part>
    void change(Member member, const Part& part) {
        Value next = m_now;
        next.*member = part;
        set(next);
    }

  private:
    Value m_now;
};

}  // namespace wend
