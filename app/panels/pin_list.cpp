#include "app/panels/pin_list.h"

#include <QKeyEvent>
#include <QListWidget>
#include <QPainter>
#include <QVBoxLayout>

#include "app/document/handle_edits.h"
#include "app/panels/marks.h"
#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr int kHeight = 92, kSwatch = 12;

QIcon swatch(const QColor& colour) {
    QPixmap picture(kSwatch, kSwatch);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(1, 1, kSwatch - 2, kSwatch - 2);
    return picture;
}

}  // namespace

PinList::PinList(ShapeSession& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_list(new QListWidget(this)) {
    m_list->setObjectName(QStringLiteral("pinList"));
    m_list->setFixedHeight(kHeight);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    describe(m_list, tr("Pins"),
             tr("Choose pins here; F2 renames, Delete removes, Enter goes to the picture, where the arrow "
                "keys move them."));
    m_list->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 10, 16, 10);
    layout->setSpacing(8);
    layout->addWidget(panelTitle(tr("Pins"), this));
    layout->addWidget(m_list);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &PinList::takeSelection);
    connect(m_list, &QListWidget::itemChanged, this, &PinList::rename);
    connect(&m_session, &ShapeSession::pinsChanged, this, &PinList::showPins);
    connect(&m_session.playback(), &Playback::timeChanged, this, &PinList::showPins);
    showPins();
}

void PinList::showRow(int row, const QString& name, bool holds) {
    if (row >= m_list->count()) m_list->addItem(new QListWidgetItem(swatch(pinColour(row)), name));
    QListWidgetItem* item = m_list->item(row);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    if (item->text() != name) item->setText(name);
    QFont font = m_list->font();
    font.setItalic(!holds);
    if (item->font() != font) item->setFont(font);
    const QString tip = holds ? QString() : tr("Does not hold at the time that is shown.");
    if (item->toolTip() != tip) item->setToolTip(tip);
    const bool selected = m_session.selection().contains(row);
    if (item->isSelected() != selected) item->setSelected(selected);
}

/// While a drag goes on nothing of it changes.
void PinList::showPins() {
    if (m_showing || m_session.isDragging()) return;
    m_showing = true;
    int count = 0;
    if (!m_session.document().isEmpty())
        std::visit(
            [&](const auto& design) {
                for (const auto& handle : design.handles)
                    showRow(count++, QString::fromStdString(handle.name),
                            isActive(handle, m_session.playback().time()));
            },
            m_session.document().project()->design);
    while (m_list->count() > count) delete m_list->takeItem(m_list->count() - 1);
    m_showing = false;
}

void PinList::takeSelection() {
    if (m_showing) return;
    std::vector<int> handles;
    for (const QListWidgetItem* item : m_list->selectedItems()) handles.push_back(m_list->row(item));
    m_session.selection().set(std::move(handles));
}

void PinList::rename(const QListWidgetItem* item) {
    if (m_showing) return;
    Document& document = m_session.document();
    const int handle = m_list->row(item);
    const std::string name = item->text().trimmed().toStdString();
    const std::string before = std::visit(
        [handle](const auto& design) { return design.handles.at(handle).name; }, document.project()->design);
    if (name == before) return;
    if (name.empty())
        showPins();
    else
        document.change(tr("Rename"), withHandleName(*document.project(), handle, name));
}

bool PinList::eventFilter(QObject* watched, QEvent* event) {
    const bool pressed = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched != m_list || !pressed) return QWidget::eventFilter(watched, event);
    auto& key = static_cast<QKeyEvent&>(*event);
    const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (!enter && key.key() != Qt::Key_Delete) return QWidget::eventFilter(watched, event);
    key.accept();
    if (event->type() == QEvent::ShortcutOverride) return true;
    if (enter)
        emit done();
    else
        m_session.removeSelected();
    return true;
}

}  // namespace wend
