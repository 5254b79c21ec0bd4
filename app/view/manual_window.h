#pragma once

#include <QDialog>

class QLineEdit;
class QTextBrowser;

namespace wend {

/// The manual, which is within the program: pages with links, back and forth, and a search on the page.
class ManualWindow : public QDialog {
    Q_OBJECT

  public:
    explicit ManualWindow(QWidget* parent);
    QTextBrowser* pages() const { return m_pages; }

  private:
    void find();

    QTextBrowser* m_pages;
    QLineEdit* m_search;
};

}  // namespace wend
