#pragma once

#include <QFrame>
#include <functional>
#include <memory>
#include <vector>

#include "app/document/project_fwd.h"

class QLabel;
class QPushButton;

namespace wend {

class Actions;
class ShapeSession;
class Toolbox;

/// Five minutes on a sample: a card in the corner of the view says what to do next, and turns to the next
/// page as soon as that is done. It ends with its last page, by its button, or when another file is opened.
class Tutorial : public QFrame {
    Q_OBJECT

  public:
    struct Parts {
        ShapeSession& session;
        const Actions& actions;
        const Toolbox& tools;
    };
    /// The picture that it runs on; empty if the samples are not installed.
    static QString picture();

    Tutorial(const Parts& parts, QWidget& over);
    /// As soon as its picture is opened, which is for others to do.
    void begin() { m_wanted = true; }
    int page() const { return m_page; }
    /// What is open was made for the tutorial, and nothing since: it may be left without a question.
    bool isPractice() const;
    int pageCount() const { return static_cast<int>(m_pages.size()); }
    QString text() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Page {
        QString text;
        std::function<double()>
            measure;  // another value than at first: it is done. None: its button turns it
    };
    void makePages();
    int pinCount() const;
    void turnTo(int page);
    void follow();
    void place();

    ShapeSession& m_session;
    const Actions& m_actions;
    const Toolbox& m_tools;
    QLabel *m_number, *m_text;
    QPushButton *m_next, *m_end;
    std::vector<Page> m_pages;
    bool m_wanted = false;
    int m_page = -1;                        // none: it does not run
    std::shared_ptr<const Project> m_made;  // by its end
    double m_before = 0;                    // the measure of the page when it was turned up
};

}  // namespace wend
