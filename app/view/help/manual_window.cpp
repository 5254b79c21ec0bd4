#include "app/view/help/manual_window.h"

#include <QDesktopServices>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTextBrowser>
#include <QTextDocument>
#include <algorithm>

#include "app/panels/fields/panel_parts.h"
#include "app/session/program_files.h"

namespace wend {

namespace {

const char* kFirstPage = "qrc:/wend/docs/manual.md";
const char* kFolder = ":/wend/docs";

constexpr int kWidest = 800;  // of a picture: what the window shows without being moved to the side

/// What a page says; empty if there is none.
void readPage(const QUrl& page, QTextDocument& into) {
    QFile file(':' + page.path());
    if (file.open(QIODevice::ReadOnly)) into.setMarkdown(QString::fromUtf8(file.readAll()));
}

/// The pages are within the program, their pictures beside it.
class ManualPages : public QTextBrowser {
  public:
    using QTextBrowser::QTextBrowser;

  protected:
    /// As HTML: where it is seen while it is read, Markdown is laid out anew for every cell of its tables.
    void doSetSource(const QUrl& name, QTextDocument::ResourceType) override {
        QTextBrowser::doSetSource(name, QTextDocument::HtmlResource);
    }

    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource) return html(name);
        QImage image(manualFolder() + QStringLiteral("/pictures/") + name.fileName());
        if (image.isNull()) image.load(sampleFolder() + '/' + name.fileName());
        const int width = qRound(std::min(kWidest, viewport()->width()) * devicePixelRatioF());
        if (image.width() > width) image = image.scaledToWidth(width, Qt::SmoothTransformation);
        image.setDevicePixelRatio(devicePixelRatioF());
        return image;
    }

  private:
    QString html(const QUrl& name) const {
        QTextDocument page;
        page.setDefaultFont(font());
        readPage(name, page);
        return page.toHtml();
    }
};

/// Those behind a page, then those before it, at last itself.
QList<QUrl> pagesAfter(const QUrl& page) {
    QList<QUrl> pages;
    for (const QString& name : QDir(QLatin1String(kFolder)).entryList({QStringLiteral("*.md")}))
        pages << QUrl(QStringLiteral("qrc%1/%2").arg(QLatin1String(kFolder), name));
    const auto own = std::ranges::find(pages, page.adjusted(QUrl::RemoveFragment));
    if (own != pages.end()) std::ranges::rotate(pages, own + 1);
    return pages;
}

/// As the window would find it, in what is read rather than in how it is written.
bool isOn(const QUrl& page, const QString& words) {
    QTextDocument text;
    readPage(page, text);
    return !text.find(words).isNull();
}

}  // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QDialog(parent),
      m_pages(new ManualPages(this)),
      m_search(new QLineEdit(this)),
      m_nowhere(secondLabel(tr("No page has these words."), this)) {
    setWindowTitle(tr("Manual"));
    resize(860, 720);
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
    QPushButton* back = button(tr("Back"), tr("The previous page"), &QTextBrowser::backward);
    back->setEnabled(false);
    connect(m_pages, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    row->addStretch(1);
    m_nowhere->setObjectName(QStringLiteral("foundNowhere"));
    m_nowhere->hide();
    row->addWidget(m_nowhere);
    m_search->setPlaceholderText(tr("Search the manual"));
    m_search->setClearButtonEnabled(true);
    m_search->setFixedWidth(240);
    describe(m_search, tr("Search the manual"),
             tr("Enter goes to the next place with these words, on this page or another."));
    connect(m_search, &QLineEdit::textChanged, m_nowhere, &QWidget::hide);
    connect(m_search, &QLineEdit::returnPressed, this, &ManualWindow::find);
    row->addWidget(m_search);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(m_pages, 1);
    m_pages->setSource(QUrl(QString::fromLatin1(kFirstPage)));
}

/// Behind the last place on the page, and on from page to page.
void ManualWindow::find() {
    const QString words = m_search->text();
    if (words.isEmpty() || m_pages->find(words)) return;
    for (const QUrl& page : pagesAfter(m_pages->source())) {
        if (!isOn(page, words)) continue;
        m_pages->setSource(page);
        m_pages->moveCursor(QTextCursor::Start);
        m_pages->find(words);
        return;
    }
    m_nowhere->show();
}

}  // namespace wend
