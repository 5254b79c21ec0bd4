#pragma once

#include <QObject>

class QKeyEvent;
class QLineEdit;
class QWidget;

namespace wend {

/// How the fields of the panels take keys and the wheel, all alike: a number that is typed counts when it is
/// complete, and Enter then gives the keyboard back; so does Escape, without it; the wheel changes what was
/// clicked before and scrolls the panels elsewhere.
class PanelFields : public QObject {
    Q_OBJECT

  public:
    /// For all fields that are in `panels` by now.
    explicit PanelFields(QWidget& panels);

  signals:
    /// A field has taken what was typed: the keyboard is for the view again.
    void done();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void selectOnlyWithKeyboard(QLineEdit& text);
    void takeEnter(QObject& field, QKeyEvent& key);
    void giveUp(QObject& field);
};

}  // namespace wend
