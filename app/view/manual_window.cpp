#include "app/view/manual_window.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTextBrowser>

#include "app/panels/panel_parts.h"

namespace wend {

namespace {

const char* kFirstPage = "qrc:/wend/docs/manual.md";

}  // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QDialog(parent), m_pages(new QTextBrowser(this)), m_search(new QLineEdit(this)) {
    setWindowTitle(tr("Manual"));
    resize(860, 720);
    m_pages->setObjectName(QStringLiteral("manualPages"));
    m_pages->setAccessibleName(tr("Manual"));
    m_pages->setOpenLinks(false);
    connect(m_pages, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        const QUrl target = m_pages->source().resolved(link);
        target.scheme() == QStringLiteral("qrc") ? m_pages->setSource(target)
                                                 : static_cast<void>(QDesktopServices::openUrl(target));
    });
    auto* row = new QHBoxLayout;
    const auto button = [&](const QString& name, const QString& help, auto act) {
        auto* one = new QPushButton(name, this);
        one->setAutoDefault(false);
        describe(one, name, help);
        connect(one, &QPushButton::clicked, m_pages, act);
        row->addWidget(one);
        return one;
    };
    button(tr("Contents"), tr("The first page"), &QTextBrowser::home);
    QPushButton* back = button(tr("Back"), tr("The page before"), &QTextBrowser::backward);
    back->setEnabled(false);
    connect(m_pages, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    row->addStretch(1);
    m_search->setPlaceholderText(tr("Search this page"));
    m_search->setClearButtonEnabled(true);
    m_search->setFixedWidth(240);
    describe(m_search, tr("Search this page"), tr("Enter goes to the next place where these words stand."));
    connect(m_search, &QLineEdit::returnPressed, this, &ManualWindow::find);
    row->addWidget(m_search);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(m_pages, 1);
    m_pages->setSource(QUrl(QString::fromLatin1(kFirstPage)));
}

/// From the beginning again behind the last place.
void ManualWindow::find() {
    if (m_pages->find(m_search->text())) return;
    m_pages->moveCursor(QTextCursor::Start);
    m_pages->find(m_search->text());
}

}  // namespace wend
