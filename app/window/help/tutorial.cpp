#include "app/window/help/tutorial.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/engine/motion/playback.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/design.h"
#include "app/project/edits/document.h"
#include "app/session/opening.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"

namespace wend {

namespace {

constexpr int kCardWidth = 340, kCardMargin = 16;  // pixels
constexpr int kHooves = 4;

}  // namespace

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
    connect(&m_document, &Document::projectChanged, this, &Tutorial::follow);
    connect(&m_playback, &Playback::playingChanged, this, &Tutorial::follow);
    connect(&m_tools, &Toolbox::changed, this, &Tutorial::follow);
    connect(m_actions.showMap, &QAction::toggled, this, &Tutorial::follow);
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
