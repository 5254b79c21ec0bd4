#pragma once

#include <QObject>

class QMainWindow;

namespace wend {

class Actions;
class ShapeSession;
class Toolbox;

/// Windows beside the main one: manual, keys and their choice, history and licence.
class SideWindows : public QObject {
    Q_OBJECT

  public:
    SideWindows(ShapeSession& session, const Actions& actions, Toolbox& tools, QMainWindow& window);

  private:
    void showManual();
    void showKeys();
    void chooseKeys();
    void showHistory();
    void showAbout();

    ShapeSession& m_session;
    Toolbox& m_tools;
    QMainWindow& m_window;
};

}  // namespace wend
