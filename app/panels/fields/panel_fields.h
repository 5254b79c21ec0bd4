#pragma once

#include <QObject>

class QKeyEvent;
class QLineEdit;
class QWidget;

namespace wend {

/// Common behaviour of the panels' fields: a typed number is applied when it is complete; Enter applies it
/// and Escape discards it, and both return the focus to the view; the wheel changes only a field that was
/// clicked and scrolls the panels otherwise.
class PanelFields : public QObject {
    Q_OBJECT

  public:
    /// Handles all existing fields inside `panels`.
    explicit PanelFields(QWidget& panels);

  signals:
    /// Emitted after a field has applied its text, to return the focus to the view.
    void done();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void selectOnlyWithKeyboard(QLineEdit& text);
    void takeEnter(QObject& field, QKeyEvent& key);
    void giveUp(QObject& field);
};

}  // namespace wend
