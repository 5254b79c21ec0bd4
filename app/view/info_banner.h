#pragma once

#include <QWidget>

class QLabel;

namespace wend {

/// A line above the canvas that says what went wrong and what to do; it goes away by itself when that is
/// done, or on a click.
class InfoBanner : public QWidget {
    Q_OBJECT

  public:
    explicit InfoBanner(QWidget* parent = nullptr);
    void showText(const QString& text);
    QString text() const;

  private:
    QLabel* m_text;
};

}  // namespace wend
