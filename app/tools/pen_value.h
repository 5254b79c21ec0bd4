#pragma once

#include <QObject>

namespace wend {

/// The one number that a brush lays down.
class PenValue : public QObject {
    Q_OBJECT

  public:
    explicit PenValue(double value, QObject* parent = nullptr) : QObject(parent), m_value(value) {}
    double now() const { return m_value; }
    void set(double value);

  signals:
    void changed();

  private:
    double m_value;
};

}  // namespace wend
