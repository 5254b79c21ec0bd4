#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QTextBrowser;

namespace wend {

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

}  // namespace wend
