#pragma once

#include <QWidget>

class QLabel;
class QToolButton;

namespace wend {

class ShapeSession;

/// Changes of a part's place in the order over time: to the front or the back from the shown time on, and
/// none of them again.
class PartOrderRow : public QWidget {
    Q_OBJECT

  public:
    explicit PartOrderRow(ShapeSession& session, QWidget* parent = nullptr);
    void showPart(int part);

  private:
    void set(bool front);

    ShapeSession& m_session;
    QToolButton *m_front, *m_back, *m_never;
    QLabel* m_times;
    int m_part = -1;
};

}  // namespace wend
