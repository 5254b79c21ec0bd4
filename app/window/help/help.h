#pragma once

#include <QDialog>
#include <QFrame>
#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "app/project/project_fwd.h"

class QLabel;
class QLineEdit;
class QMainWindow;
class QPushButton;
class QTextBrowser;

namespace wend {

class Actions;
class Document;
class Playback;
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

/// A tutorial of five minutes on a sample: a card in a corner of the view gives the next step and advances
/// when it is done. It ends with its last page, by its button, or when another file is opened.
class Tutorial : public QFrame {
    Q_OBJECT

  public:
    struct Parts {
        Document& document;
        Playback& playback;
        const Actions& actions;
        const Toolbox& tools;
    };
    /// Returns the picture that it runs on; empty if the samples are not installed.
    static QString picture();

    Tutorial(const Parts& parts, QWidget& over);
    /// Starts once its picture has been opened, which the caller does.
    void begin() { m_wanted = true; }
    int page() const { return m_page; }
    /// Returns whether the document is only practice, which may be closed without a question.
    bool isPractice() const;
    int pageCount() const { return static_cast<int>(m_pages.size()); }
    QString text() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Page {
        QString text;
        std::function<double()> measure;  // the step is done when this value changes; none: a button advances
    };
    void makePages();
    int pinCount() const;
    void turnTo(int page);
    void follow();
    void place();

    Document& m_document;
    Playback& m_playback;
    const Actions& m_actions;
    const Toolbox& m_tools;
    QLabel *m_number, *m_text;
    QPushButton *m_next, *m_end;
    std::vector<Page> m_pages;
    bool m_wanted = false;
    int m_page = -1;                        // none: it does not run
    std::shared_ptr<const Project> m_made;  // by its end
    double m_before = 0;                    // value when the page was shown
};

}  // namespace wend
