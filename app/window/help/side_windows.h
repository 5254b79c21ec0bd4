#pragma once

#include <QDialog>
#include <QObject>

class QLabel;
class QLineEdit;
class QMainWindow;
class QTextBrowser;

namespace wend {

class Actions;
class Document;
class Toolbox;

/// The manual, which is within the program: pages with links, back and forth, and a search over all of them.
class ManualWindow : public QDialog {
    Q_OBJECT

  public:
    explicit ManualWindow(QWidget* parent);
    QTextBrowser* pages() const { return m_pages; }

  private:
    void find();

    QTextBrowser* m_pages;
    QLineEdit* m_search;
    QLabel* m_nowhere;
};

/// Windows beside the main one: manual, keys and their choice, history and licence.
class SideWindows : public QObject {
    Q_OBJECT

  public:
    SideWindows(Document& document, const Actions& actions, Toolbox& tools, QMainWindow& window);

  private:
    void showManual();
    void showKeys();
    void chooseKeys();
    void showHistory();
    void showAbout();

    Document& m_document;
    Toolbox& m_tools;
    QMainWindow& m_window;
};

}  // namespace wend
