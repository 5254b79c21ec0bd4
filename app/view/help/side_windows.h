#pragma once

#include <QObject>

class QMainWindow;

namespace wend {

class Actions;
class ShapeSession;

/// Windows beside the main one: manual, shortcuts, history and licence.
class SideWindows : public QObject {
    Q_OBJECT

  public:
    SideWindows(ShapeSession& session, const Actions& actions, QMainWindow& window);

  private:
    void showManual();
    void showKeys();
    void showHistory();
    void showAbout();

    ShapeSession& m_session;
    QMainWindow& m_window;
};

}  // namespace wend
