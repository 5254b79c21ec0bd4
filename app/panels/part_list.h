#pragma once

#include <QWidget>

#include "app/document/part.h"

class QComboBox;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace wend {

class NumberBox;
class ShapeSession;

/// Lists the parts of a picture, the frontmost first: an eye, a name that a double click changes, and an
/// order that dragging and Alt with the arrow keys change. Below are the properties of the chosen part: its
/// opacity, its blend mode, its joints, and the part to which it is attached. Hidden for a picture of a
/// single part.
class PartList : public QWidget {
    Q_OBJECT

  public:
    explicit PartList(ShapeSession& session, QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    const std::vector<PicturePart>& parts() const;
    int chosen() const;
    void makeControls();
    void connectControls();
    void showParts();
    void showChosen();
    void showBlend();
    void fillChoices();
    void takeItem(QListWidgetItem* item);
    void takeOrder(int from, int to);
    void move(int by);
    void change(const QString& step, std::vector<PicturePart> parts, const QString& key = {});
    void blend(int mode);
    void join(const QString& to);
    void ride(const QString& on);

    ShapeSession& m_session;
    QListWidget* m_list;
    QToolButton *m_forward, *m_backward;
    NumberBox* m_opacity;
    QComboBox *m_blend, *m_joined, *m_rides;
    QWidget* m_rows = nullptr;
};

}  // namespace wend
