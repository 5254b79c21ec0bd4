#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QListWidget;
class QListWidgetItem;

namespace wend {

/// All pins by name: to select them, to rename and remove them, without the pointer. Enter goes on to the
/// view, where the arrow keys move what is selected.
class PinList : public QWidget {
    Q_OBJECT

  public:
    explicit PinList(ShapeSession& session, QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }

  signals:
    /// The keyboard is for the view now.
    void done();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void showPins();
    void showRow(int row, const QString& name, bool holds);
    void takeSelection();
    void rename(const QListWidgetItem* item);

    ShapeSession& m_session;
    QListWidget* m_list;
    bool m_showing = false;
};

}  // namespace wend
