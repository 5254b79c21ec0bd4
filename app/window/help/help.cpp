#include "app/window/help/help.h"

#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUndoView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/base/connect_each.h"
#include "app/base/program_files.h"
#include "app/engine/motion/playback.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/design.h"
#include "app/project/edits/document.h"
#include "app/session/opening.h"
#include "app/style/theme.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/help/shortcuts.h"

namespace wend {

namespace {

const char* kFirstPage = "qrc:/wend/docs/manual.md";
const char* kFolder = ":/wend/docs";

constexpr int kWidest = 800, kTallest = 520;  // pixels: a picture that fits without scrolling
constexpr int kBeside = 340, kSpace = 16;     // pixels: width of a picture beside text, and its distance
constexpr int kPageMargin = 20;               // pixels around a page

/// Reads a page; empty if there is none.
void readPage(const QUrl& page, QTextDocument& into) {
    QFile file(':' + page.path());
    if (file.open(QIODevice::ReadOnly)) into.setMarkdown(QString::fromUtf8(file.readAll()));
}

QString picturePath(const QString& name) {
    const QString own = manualFolder() + QStringLiteral("/pictures/") + name;
    return QFile::exists(own) ? own : sampleFolder() + '/' + name;
}

/// Returns whether text flows beside a picture: if it is small and neither a strip nor a column.
bool isBeside(const QSize& picture) {
    constexpr int kSmall = 1000;  // pixels
    constexpr double kStrip = 0.55, kColumn = 1.2;
    const double ratio = picture.height() / std::max(1.0, double(picture.width()));
    return picture.width() < kSmall && ratio > kStrip && ratio < kColumn;
}

/// Returns resources/manual.css in the colours of the palette.
QString manualStyle(const QPalette& palette) {
    QFile file(QStringLiteral(":/wend/manual.css"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QString sheet = QString::fromUtf8(file.readAll());
    const Theme theme = Theme::of(palette);
    for (const auto& [name, colour] : {std::pair{"@line", theme.line},
                                       {"@second", theme.secondText},
                                       {"@accent", theme.accentText},
                                       {"@raised", palette.color(QPalette::AlternateBase)}})
        sheet.replace(QLatin1String(name), colour.name());
    return sheet;
}

/// Replaces the inline styles of Qt's HTML by elements and classes that manual.css describes.
QString withClasses(QString html) {
    const auto replace = [&html](const char* pattern, const char* text) {
        html.replace(
            QRegularExpression(QLatin1String(pattern), QRegularExpression::DotMatchesEverythingOption),
            QLatin1String(text));
    };
    replace("(<(?:h[1-6]|p|ul|ol|li|pre|body)\\b[^>]*?) style=\"[^\"]*\"", "\\1");
    replace("(<h[1-6][^>]*>(?:<a name=\"[^\"]*\"></a>)?)<span[^>]*>([^<]*)</span>", "\\1\\2");
    replace("<span style=\" font-family:'monospace';\">([^<]*)</span>", "<code>\\1</code>");
    replace("(<a href[^>]*>)<span style=\"[^\"]*color:#0000ff;\">([^<]*)</span>", "\\1\\2");
    replace("</pre>\\s*<pre[^>]*>", "<br/>");
    replace("<td>\\s*<p>(.*?)</p></td>", "<td>\\1</td>");
    replace("<table[^>]*>\\s*<tr>", "<table width=\"100%\" cellspacing=\"0\"><tr class=\"head\">");
    return html;
}

/// Gives paragraphs of a picture their class, and lets text flow beside the small ones.
QString withPictures(const QString& html) {
    static const QRegularExpression picture(QStringLiteral("<p>(<img)( src=\"([^\"]*)\")"));
    QString result;
    qsizetype done = 0;
    for (auto found = picture.globalMatch(html); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString path = picturePath(QUrl(match.captured(3)).fileName());
        const bool beside = isBeside(QImageReader(path).size());
        result += html.mid(done, match.capturedStart() - done) + QStringLiteral("<p class=\"picture\"><img") +
                  (beside ? QStringLiteral(" align=\"right\"") : QString()) + match.captured(2);
        done = match.capturedEnd();
    }
    return result + html.mid(done);
}

/// The pages of the manual. They are compiled in; their pictures are files beside the program.
class ManualPages : public QTextBrowser {
  public:
    explicit ManualPages(QWidget* parent) : QTextBrowser(parent) {
        document()->setDocumentMargin(kPageMargin);
    }

  protected:
    /// Converts Markdown to HTML first, because Markdown tables are laid out again for every cell.
    void doSetSource(const QUrl& name, QTextDocument::ResourceType) override {
        document()->setDefaultStyleSheet(manualStyle(palette()));
        QTextBrowser::doSetSource(name, QTextDocument::HtmlResource);
    }

    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource) return html(name);
        QImage image(picturePath(name.fileName()));
        const bool beside = isBeside(image.size());
        const int widest = beside ? kBeside : std::min(kWidest, viewport()->width() - 2 * kPageMargin);
        const QSize room = QSize(widest, kTallest) * devicePixelRatioF();
        if (image.width() > room.width() || image.height() > room.height())
            image = image.scaled(room, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        const int space = qRound(kSpace * devicePixelRatioF());
        if (beside)
            image = image.convertToFormat(QImage::Format_ARGB32)
                        .copy(-space, 0, image.width() + space, image.height());
        image.setDevicePixelRatio(devicePixelRatioF());
        return image;
    }

    void changeEvent(QEvent* event) override {
        QTextBrowser::changeEvent(event);
        if (event->type() == QEvent::PaletteChange && !source().isEmpty()) reload();
    }

  private:
    QString html(const QUrl& name) const {
        QTextDocument page;
        page.setDefaultFont(font());
        readPage(name, page);
        return withPictures(withClasses(page.toHtml()));
    }
};

/// Returns the pages after a page, then those before it, then itself.
QList<QUrl> pagesAfter(const QUrl& page) {
    QList<QUrl> pages;
    for (const QString& name : QDir(QLatin1String(kFolder)).entryList({QStringLiteral("*.md")}))
        pages << QUrl(QStringLiteral("qrc%1/%2").arg(QLatin1String(kFolder), name));
    const auto own = std::ranges::find(pages, page.adjusted(QUrl::RemoveFragment));
    if (own != pages.end()) std::ranges::rotate(pages, own + 1);
    return pages;
}

/// Searches the rendered text, as the window does.
bool isOn(const QUrl& page, const QString& words) {
    QTextDocument text;
    readPage(page, text);
    return !text.find(words).isNull();
}

constexpr int kCardWidth = 340, kCardMargin = 16;  // pixels
constexpr int kHooves = 4;

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
        if (target.fileName().endsWith(QStringLiteral(".webp")))  // a film: another program shows it
            return static_cast<void>(
                QDesktopServices::openUrl(QUrl::fromLocalFile(picturePath(target.fileName()))));
        target.scheme() == QStringLiteral("qrc") ? m_pages->setSource(target)
                                                 : static_cast<void>(QDesktopServices::openUrl(target));
    });
    auto* row = new QHBoxLayout;
    const auto button = [&](const QString& name, const QString& help, auto act) {
        QPushButton* one = pushButton(m_pages, "", name, help, act);
        one->setAutoDefault(false);
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

/// Finds the next place on the page, then on the following pages.
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

SideWindows::SideWindows(Document& document, const Actions& actions, Toolbox& tools, QMainWindow& window)
    : QObject(&window), m_document(document), m_tools(tools), m_window(window) {
    onTriggered(this, actions.manual, &SideWindows::showManual, actions.shortcuts, &SideWindows::showKeys,
                actions.chooseKeys, &SideWindows::chooseKeys, actions.history, &SideWindows::showHistory,
                actions.about, &SideWindows::showAbout);
}

/// Shows the single manual window where it was.
void SideWindows::showManual() {
    auto* manual = m_window.findChild<ManualWindow*>();
    if (!manual) manual = new ManualWindow(&m_window);
    manual->show();
    manual->raise();
    manual->activateWindow();
}

void SideWindows::showKeys() {
    CheatSheet(*m_window.menuBar(), m_document.dimension(), &m_window).exec();
}

void SideWindows::chooseKeys() {
    ShortcutDialog(*m_window.menuBar(), m_tools, &m_window).exec();
}

/// Shows the undo history; a click moves to that step.
void SideWindows::showHistory() {
    auto* history = m_window.findChild<QDialog*>(QStringLiteral("history"));
    if (!history) {
        history = new QDialog(&m_window, Qt::Tool);
        history->setObjectName(QStringLiteral("history"));
        history->setWindowTitle(tr("History"));
        auto* steps = new QUndoView(m_document.undoStack(), history);
        steps->setEmptyLabel(tr("As it was opened"));
        steps->setAccessibleName(tr("History"));
        steps->setAccessibleDescription(tr("What was done; a click goes back or forward to that step."));
        steps->setFrameShape(QFrame::NoFrame);
        auto* column = new QVBoxLayout(history);
        column->setContentsMargins(0, 0, 0, 0);
        column->addWidget(steps);
        history->resize(260, 360);
    }
    history->show();
    history->raise();
    history->activateWindow();
    history->findChild<QUndoView*>()->setFocus();
}

void SideWindows::showAbout() {
    QMessageBox::about(&m_window, tr("About Wend"),
                       tr("<h3>Wend %1</h3><p>Bends pictures and solids by letting them flow.</p>"
                          "<p>After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies "
                          "for Continuous Shape "
                          "Deformation, 2013.</p><p>Free software under the GNU Affero General Public "
                          "License, version 3 or later.</p>")
                           .arg(QCoreApplication::applicationVersion()));
}

QString Tutorial::picture() {
    for (const QString& sample : samplePaths())
        if (sample.endsWith(QStringLiteral("giraffe.wend"))) return lookOf(sample).picture;
    return {};
}

Tutorial::Tutorial(const Parts& parts, QWidget& over)
    : QFrame(&over),
      m_document(parts.document),
      m_playback(parts.playback),
      m_actions(parts.actions),
      m_tools(parts.tools),
      m_number(secondLabel({}, this)),
      m_text(new QLabel(this)),
      m_next(new QPushButton(this)),
      m_end(new QPushButton(tr("End"), this)) {
    setObjectName(QStringLiteral("tutorial"));
    m_text->setWordWrap(true);
    m_next->setFocusPolicy(Qt::NoFocus);  // the view keeps its keys
    m_end->setFocusPolicy(Qt::NoFocus);
    m_end->setToolTip(tr("Ends the tutorial; the picture stays open"));
    m_end->setStatusTip(m_end->toolTip());
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_number, 1);
    buttons->addWidget(m_end);
    buttons->addWidget(m_next);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 12, 12);
    column->addWidget(m_text);
    column->addLayout(buttons);
    hide();
    over.installEventFilter(this);
    makePages();
    connect(m_next, &QPushButton::clicked, this, [this] { turnTo(m_page + 1); });
    connect(m_end, &QPushButton::clicked, this, [this] { turnTo(-1); });
    connect(&m_document, &Document::opened, this, [this] {
        const bool begins = m_wanted && m_document.source() == picture();
        m_wanted = false;
        m_page = -1;
        m_made.reset();
        turnTo(begins ? 0 : -1);
    });
    connectEach(this, &Tutorial::follow, &m_document, &Document::projectChanged, &m_playback,
                &Playback::playingChanged, &m_tools, &Toolbox::changed, m_actions.showMap, &QAction::toggled);
}

void Tutorial::makePages() {
    const auto moved = [this] {
        return std::ranges::count_if(m_document.design().handles,
                                     [](const Pin& handle) { return !handle.motions.empty(); });
    };
    m_pages = {
        {tr("Only what is pinned holds. <b>Click a hoof</b> of the giraffe to pin it."),
         [this] { return pinCount(); }},
        {tr("<b>Pin the other hooves</b>, too, with a click each. Ctrl+Z undoes a pin."),
         [this] { return pinCount() >= kHooves; }},
        {tr("<b>Click its nose</b>, and <b>drag the new pin</b> down to the ground. The shape flows along."),
         moved},
        {tr("What it keeps on the way is your choice: at the top right, under <b>Keep</b>, <b>choose Area, "
            "Rigid or "
            "Angle</b>, and see the neck change."),
         [this] { return m_document.design().material.phi; }},
        {tr("<b>Press D</b> to see in colours what the bend has changed, and where most. D again hides it."),
         [this] { return m_actions.showMap->isChecked(); }},
        {tr("The same for a part only: <b>press Ctrl+3</b> for the step <i>Paint</i>, and <b>brush over the "
            "neck</b>. "
            "[ and ] change the size of the brush."),
         [this] { return std::ranges::distance(regionsOf(m_document.design().material.layers)); }},
        {tr("Your drag is already a film: <b>press K</b> to play it. Click into the strip below to go to a "
            "time, and "
            "drag on from there."),
         [this] { return m_playback.isPlaying(); }},
        {tr("Finally, <b>press Ctrl+5</b> for the step <i>Export</i>: a picture, a sequence, an ST "
            "map, or the mesh."),
         [this] { return m_tools.mode() == Mode::Export; }},
        {tr("That is all you need to begin. <b>F1</b> opens the manual, <b>?</b> lists the keys. Drop a "
            "picture of your "
            "own on the window."),
         {}}};
}

int Tutorial::pinCount() const {
    return static_cast<int>(m_document.design().handles.size());
}

QString Tutorial::text() const {
    return m_page < 0 ? QString() : m_pages[static_cast<std::size_t>(m_page)].text;
}

bool Tutorial::isPractice() const {
    return m_document.path().isEmpty() && (m_page >= 0 || m_document.project() == m_made);
}

void Tutorial::turnTo(int page) {
    if (m_page >= 0) m_made = m_document.project();
    m_page = page < pageCount() ? page : -1;
    setVisible(m_page >= 0);
    if (m_page < 0) return;
    const Page& current = m_pages[static_cast<std::size_t>(m_page)];
    m_before = current.measure ? current.measure() : 0;
    m_number->setText(tr("%1 of %2").arg(m_page + 1).arg(pageCount()));
    m_text->setText(text());
    setAccessibleName(m_text->text());
    const bool last = m_page + 1 == pageCount();
    m_end->setVisible(!last);
    m_next->setText(last ? tr("Done") : tr("Skip"));
    place();
    // Raises the card later: other receivers of the signal may show a page over it.
    QMetaObject::invokeMethod(this, &QWidget::raise, Qt::QueuedConnection);
}

void Tutorial::follow() {
    if (m_page < 0 || m_document.isEmpty() || m_document.dimension() != 2) return;
    const auto& measure = m_pages[static_cast<std::size_t>(m_page)].measure;
    if (measure && measure() != m_before) turnTo(m_page + 1);
}

void Tutorial::place() {
    const int width = std::min(kCardWidth, parentWidget()->width() - 2 * kCardMargin);
    setFixedWidth(width);
    resize(width, heightForWidth(width));
    move(kCardMargin, kCardMargin);  // where the giraffe is not
}

bool Tutorial::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) place();
    return QFrame::eventFilter(watched, event);
}

}  // namespace wend
