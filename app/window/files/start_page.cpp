#include "app/window/files/start_page.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "app/base/in_background.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/session/opening.h"
#include "app/style/theme.h"
#include "app/window/files/file_workflow.h"
#include "app/window/files/thumbnail.h"

namespace wend {

namespace {

constexpr int kPictureHeight = 118, kPadding = 12, kTitleHeight = 20, kLineHeight = 18;

QString titleOf(const QString& path) {
    QString name = QFileInfo(path).completeBaseName().replace('-', ' ').replace('_', ' ');
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

struct Sample {
    const char *name = nullptr, *lesson = nullptr;  // what it demonstrates
};

/// Returns empty strings for an unknown sample.
Sample sampleOf(const QString& path) {
    static const QMap<QString, Sample> samples = {
        {"frog", {QT_TRANSLATE_NOOP("FileCard", "Frog"), QT_TRANSLATE_NOOP("FileCard", "Eyes stay round")}},
        {"giraffe",
         {QT_TRANSLATE_NOOP("FileCard", "Giraffe"), QT_TRANSLATE_NOOP("FileCard", "Pins and paths")}},
        {"octopus",
         {QT_TRANSLATE_NOOP("FileCard", "Octopus"), QT_TRANSLATE_NOOP("FileCard", "Many pins at once")}},
        {"strip",
         {QT_TRANSLATE_NOOP("FileCard", "Strip"), QT_TRANSLATE_NOOP("FileCard", "Choose what to keep")}},
        {"walker",
         {QT_TRANSLATE_NOOP("FileCard", "Walker"), QT_TRANSLATE_NOOP("FileCard", "A walk that loops")}},
        {"eagle",
         {QT_TRANSLATE_NOOP("FileCard", "Eagle"), QT_TRANSLATE_NOOP("FileCard", "Flight, with a skin")}},
        {"bar", {QT_TRANSLATE_NOOP("FileCard", "Bar"), QT_TRANSLATE_NOOP("FileCard", "A stiff middle")}},
    };
    return samples.value(QFileInfo(path).completeBaseName());
}

QString translated(const char* text) {
    return text ? QCoreApplication::translate("FileCard", text) : QString();
}

constexpr int kPageWidth = 1064;
constexpr int kMostSamples = 7;
constexpr int kMostCards = 6;

/// The large dashed target.
class DropArea : public QWidget {
  public:
    using QWidget::QWidget;

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const Theme theme = Theme::of(palette());
        const bool hot = property("hot").toBool();
        QColor fill = hot ? theme.accent : palette().color(QPalette::Base);
        if (hot) fill.setAlpha(40);
        QPen pen(hot ? theme.accent : palette().color(QPalette::Mid), 1.6);
        pen.setDashPattern({5, 4});
        painter.setPen(pen);
        painter.setBrush(fill);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 12, 12);
    }
};

/// Cards in as many columns as there is room for.
class Shelf : public QWidget {
  public:
    explicit Shelf(QWidget* parent) : QWidget(parent), m_grid(new QGridLayout(this)) {
        m_grid->setContentsMargins(0, 0, 0, 0);
        m_grid->setSpacing(kCardGap);
        m_grid->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    }
    QSize minimumSizeHint() const override {
        return {m_cards.first()->sizeHint().width(), QWidget::minimumSizeHint().height()};
    }
    void add(QWidget* card) {
        m_cards << card;
        arrange();
    }

  protected:
    void resizeEvent(QResizeEvent*) override { arrange(); }

  private:
    static constexpr int kCardGap = 14;
    void arrange() {
        const int card = m_cards.first()->sizeHint().width() + kCardGap;
        const int columns = std::clamp((width() + kCardGap) / card, 1, static_cast<int>(m_cards.size()));
        if (columns == m_columns && m_grid->count() == m_cards.size()) return;
        m_columns = columns;
        for (QWidget* one : m_cards) m_grid->removeWidget(one);
        for (int i = 0; i < m_cards.size(); ++i) m_grid->addWidget(m_cards[i], i / columns, i % columns);
    }

    QGridLayout* m_grid;
    QList<QWidget*> m_cards;
    int m_columns = 0;
};

QLabel* sectionTitle(const QString& text, QWidget* parent) {
    QLabel* label = panelTitle(text, parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 1.1);
    label->setFont(font);
    return label;
}

/// Makes a box for a title and a shelf, empty and hidden at first.
QWidget* makeBox(QVBoxLayout*& column, QWidget* parent) {
    auto* box = new QWidget(parent);
    column = bareColumn(box, 10);
    box->hide();
    return box;
}

void empty(QLayout& layout) {
    while (QLayoutItem* item = layout.takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

}  // namespace

FileCard::FileCard(const QString& path, Kind kind, QWidget* parent, const QString& line)
    : QAbstractButton(parent), m_path(path), m_line(line) {
    const bool sample = kind == Kind::Sample;
    const Sample known = sample ? sampleOf(path) : Sample();
    if (line.isEmpty())
        m_line = sample ? translated(known.lesson) : QDir::toNativeSeparators(QFileInfo(path).absolutePath());
    setText(!sample ? QFileInfo(path).fileName() : known.name ? translated(known.name) : titleOf(path));
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);
    setFixedSize(sizeHint());
    setAccessibleDescription(m_line);
    switch (kind) {
        case Kind::Sample:
            setAccessibleName(tr("Sample: %1").arg(text()));
            setToolTip(tr("Open the sample “%1”").arg(text()));
            break;
        case Kind::Recent:
            setAccessibleName(tr("Open %1").arg(text()));
            setToolTip(QDir::toNativeSeparators(path));
            break;
        case Kind::Lost:
            setAccessibleName(tr("Recover %1").arg(text()));
            setToolTip(tr("Open the unsaved changes to “%1”").arg(text()));
            break;
    }
    setStatusTip(toolTip());
    setAttribute(Qt::WA_Hover);
}

void FileCard::load() {
    m_isAsked = true;
    const auto look = [path = m_path] { return thumbnailOf(path); };
    inBackground(this, look, [this](const Thumbnail& shown) {
        m_picture = shown.picture;
        m_isSolid = shown.isSolid;
        if (m_isSolid) setAccessibleName(tr("%1, solid").arg(accessibleName()));
        update();
    });
}

void FileCard::paintPicture(QPainter& painter) const {
    const QRectF space(kPadding, kPadding, width() - 2 * kPadding, kPictureHeight - 2 * kPadding + 4);
    if (m_picture.isNull()) {
        const QRectF icon(space.center() - QPointF(20, 20), QSizeF(40, 40));
        wendIcon(QStringLiteral("picture"), palette())
            .paint(&painter, icon.toRect(), Qt::AlignCenter, QIcon::Disabled);
        return;
    }
    const QSizeF size = QSizeF(m_picture.size()).scaled(space.size(), Qt::KeepAspectRatio);
    painter.drawImage(QRectF(space.center() - QPointF(size.width(), size.height()) / 2, size), m_picture);
}

/// Draws the badge at the top right.
void FileCard::paintBadge(QPainter& painter) const {
    const QString text = tr("Solid");
    const int wide = painter.fontMetrics().horizontalAdvance(text) + 14;
    const QRectF badge(width() - wide - 8, 8, wide, 20);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::of(palette()).accent);
    painter.drawRoundedRect(badge, 10, 10);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(badge, Qt::AlignCenter, text);
}

void FileCard::paintEvent(QPaintEvent*) {
    if (!m_isAsked) load();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const Theme theme = Theme::of(palette());
    const bool lively = underMouse() || hasFocus();
    painter.setPen(QPen(lively ? theme.accentText : theme.line, lively ? 2 : 1));
    painter.setBrush(palette().color(QPalette::Button));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8, 8);
    paintPicture(painter);
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    const QFontMetrics bold(font);
    const int room = this->room();
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(8, kPictureHeight, room, kTitleHeight), Qt::AlignCenter,
                     bold.elidedText(text(), Qt::ElideMiddle, room));
    font = this->font();
    font.setPixelSize(12);
    painter.setFont(font);
    painter.setPen(theme.secondText);
    painter.drawText(QRectF(8, kPictureHeight + kTitleHeight, room, kLineHeight), Qt::AlignCenter,
                     QFontMetrics(font).elidedText(m_line, Qt::ElideMiddle, room));
    if (m_isSolid) paintBadge(painter);
}

StartPage::StartPage(FileWorkflow& files, QAction& tutorial, QWidget* parent)
    : QWidget(parent), m_files(files) {
    auto* page = new QWidget(this);  // scrolls where the window is small
    auto* content = new QWidget(page);
    content->setMaximumWidth(kPageWidth);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(24, 16, 24, 16);
    column->setSpacing(12);
    column->addWidget(makeHeader(tutorial));
    column->addWidget(makeDropArea());
    column->addSpacing(4);
    m_lostBox = makeBox(m_lost, content);
    column->addWidget(m_lostBox);
    if (QWidget* samples = makeSamples()) column->addWidget(samples);
    m_recentBox = makeBox(m_recent, content);
    column->addWidget(m_recentBox);
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(0, 0, 0, 0);
    row->addStretch(1);
    row->addWidget(content, 20);
    row->addStretch(1);
    row->setAlignment(content, Qt::AlignVCenter);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll);
    connect(&files, &FileWorkflow::recentChanged, this, &StartPage::showRecent);
    connect(&files, &FileWorkflow::lostChanged, this, &StartPage::showLost);
    showRecent();
}

QWidget* StartPage::makeHeader(QAction& tutorial) {
    auto* header = new QWidget(this);
    auto* logo = new QLabel(header);
    logo->setPixmap(
        QIcon(QStringLiteral(":/wend/icons/wend.svg")).pixmap(QSize(64, 64), devicePixelRatioF()));
    auto* name = new QLabel(QStringLiteral("Wend"), header);
    QFont font = name->font();
    font.setPointSizeF(font.pointSizeF() * 2.6);
    font.setWeight(QFont::DemiBold);
    font.setLetterSpacing(QFont::AbsoluteSpacing, -1);
    name->setFont(font);
    auto* line = secondLabel(tr("Pin a picture, pull it into shape, and let it flow."), header);
    QFont lineFont = line->font();
    lineFont.setPointSizeF(lineFont.pointSizeF() * 1.15);
    line->setFont(lineFont);
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    column->addWidget(name);
    column->addWidget(line);
    auto* row = bareRow(header, 16);
    row->addWidget(logo);
    row->addLayout(column, 1);
    row->addWidget(pushButton(this, "startTutorial", tr("Five-minute tutorial"),
                              tr("The first steps on a sample, one after another."),
                              [&tutorial] { tutorial.trigger(); }),
                   0, Qt::AlignVCenter);
    return header;
}

QWidget* StartPage::makeDropArea() {
    m_drop = new DropArea(this);
    m_drop->setFixedHeight(160);
    auto* column = new QVBoxLayout(m_drop);
    column->setSpacing(10);
    auto* text = new QLabel(tr("Drop a picture here"), m_drop);
    QFont font = text->font();
    font.setPointSizeF(font.pointSizeF() * 1.5);
    text->setFont(font);
    QPushButton* open =
        pushButton(this, "startOpen", tr("Open…"), tr("Choose a picture, a flat mesh or a project."),
                   [this] { m_files.askOpen(); });
    open->setProperty("role", "primary");
    open->setDefault(true);
    setFocusProxy(open);  // the keyboard begins with it
    auto* kinds = secondLabel(tr("PNG, JPEG, TIFF, EXR, WebP … — cut-outs with transparency work best.\n"
                                 "PSD, ORA, KRA and SVG with their layers. Projects, meshes and solids too."),
                              m_drop);
    kinds->setAlignment(Qt::AlignCenter);
    column->addStretch(1);
    column->addWidget(text, 0, Qt::AlignHCenter);
    column->addWidget(open, 0, Qt::AlignHCenter);
    column->addWidget(kinds);
    column->addStretch(1);
    return m_drop;
}

QWidget* StartPage::makeSamples() {
    const QStringList paths = samplePaths().mid(0, kMostSamples);
    if (paths.isEmpty()) return nullptr;
    auto* box = new QWidget(this);
    auto* column = bareColumn(box, 10);
    column->addWidget(sectionTitle(tr("Try a sample"), box));
    auto* shelf = new Shelf(box);
    for (const QString& path : paths) shelf->add(makeCard(path, true, shelf));
    column->addWidget(shelf);
    return box;
}

QWidget* StartPage::makeCard(const QString& path, bool sample, QWidget* shelf) {
    auto* card = new FileCard(path, sample ? FileCard::Kind::Sample : FileCard::Kind::Recent, shelf);
    connect(card, &FileCard::clicked, this, [this, path] { m_files.open(path); });
    return card;
}

void StartPage::showRecent() {
    const QStringList paths = m_files.recent();
    empty(*m_recent);
    m_recentBox->setVisible(!paths.isEmpty());
    if (paths.isEmpty()) return;
    m_recent->addWidget(sectionTitle(tr("Recent"), m_recentBox));
    auto* shelf = new Shelf(m_recentBox);
    for (const QString& path : paths.mid(0, kMostCards)) shelf->add(makeCard(path, false, shelf));
    m_recent->addWidget(shelf);
}

/// Shows recovered work first.
void StartPage::showLost() {
    const QList<LostWork> lost = m_files.lost();
    empty(*m_lost);
    m_lostBox->setVisible(!lost.isEmpty());
    if (lost.isEmpty()) return;
    m_lost->addWidget(sectionTitle(tr("Not saved when Wend ended"), m_lostBox));
    auto* shelf = new Shelf(m_lostBox);
    for (const LostWork& work : lost.mid(0, kMostCards)) shelf->add(makeLost(work, shelf));
    m_lost->addWidget(shelf);
}

QWidget* StartPage::makeLost(const LostWork& work, QWidget* shelf) {
    auto* both = new QWidget(shelf);
    auto* column = bareColumn(both, 4);
    auto* card = new FileCard(work.path.isEmpty() ? work.source : work.path, FileCard::Kind::Lost, both,
                              QLocale().toString(work.time, QStringLiteral("d MMM, HH:mm")));
    card->setObjectName(QStringLiteral("lostCard"));
    auto* discard = new QPushButton(tr("Discard…"), both);
    discard->setObjectName(QStringLiteral("discardLost"));
    describe(discard, tr("Discard %1").arg(nameOf(work)), tr("Deletes these changes for good."));
    column->addWidget(card);
    column->addWidget(discard);
    connect(card, &FileCard::clicked, this, [this, work] { m_files.recover(work); });
    // The card is destroyed with its work, so this is queued until the click has ended.
    connect(
        discard, &QPushButton::clicked, this, [this, work] { m_files.discard(work); }, Qt::QueuedConnection);
    return both;
}

void StartPage::setDropHighlighted(bool highlighted) {
    m_drop->setProperty("hot", highlighted);
    m_drop->update();
}

}  // namespace wend
