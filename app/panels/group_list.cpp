#include "app/panels/group_list.h"

#include <QListWidget>
#include <QLocale>
#include <QPixmap>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/free_name.h"
#include "app/project/file/named_files.h"
#include "app/project/file/named_places.h"
#include "app/session/shape_session.h"
#include "core/base/error.h"
#include "core/mesh/group_vertices.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {

namespace {

/// Returns the colour of a group: steps of the golden angle keep neighbours in the list apart.
QColor colourOf(int group) {
    constexpr double kGolden = 0.381966;
    const double hue = group * kGolden;
    return QColor::fromHsvF(static_cast<float>(hue - std::floor(hue)), 0.75F, group % 2 == 0 ? 0.85F : 0.65F);
}

/// Returns the groups of a mesh file. Thread-safe.
std::vector<HeldGroup> heldGroups(const std::string& path) {
    std::vector<HeldGroup> groups;
    const auto file = sharedMeshFile(path);
    for (const GroupFacts& facts : groupFacts(*file)) {
        HeldGroup group{
            facts.name.empty() ? std::to_string(facts.tag) : facts.name, facts.dimension, facts.count, {}};
        try {
            group.vertices = groupVertices(*file, group.name, group.dimension);
        } catch (const InputError&) {
            continue;  // a number that is also the name of another one
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

/// Adds a handle that holds a group, by its name, and selects it.
void holdGroup(Document& document, Selection& selection, const HeldGroup& group) {
    Design design = document.design();
    const std::vector<std::string> names = namesOf(design.handles);
    Pin& handle = design.handles.emplace_back();
    const bool isTaken = std::ranges::count(names, group.name) > 0;
    handle.name = isTaken ? freeName(names, group.name, 2) : group.name;
    placeOnGroup(handle, group.name, group.dimension, group.vertices);
    document.changeDesign(ShapeSession::tr("Hold %1").arg(QString::fromStdString(group.name)),
                          std::move(design));
    selection.set({static_cast<int>(document.design().handles.size()) - 1});
}

}  // namespace

GroupList::GroupList(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_list(new QListWidget(this)),
      m_hold(pushButton(this, "", tr("Hold It"),
                        tr("Makes a pin of the chosen group, which the project names, so that it fits "
                           "other meshes, too."),
                        &GroupList::hold, tr("Hold the group"))),
      m_content(new QWidget(this)) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(m_content);
    auto* layout = sectionColumn(m_content);
    layout->addWidget(panelTitle(tr("Groups of the file"), m_content));
    m_list->setObjectName(QStringLiteral("groups"));
    m_list->setFixedHeight(112);
    layout->addWidget(m_list);
    layout->addWidget(m_hold);
    describe(
        m_list, tr("Groups of the file"),
        tr("What the mesh's file calls by a name or number. A click marks a group on the shape; a double "
           "click, or Enter, pins it."));
    hide();
    connect(&document, &Document::opened, this, &GroupList::read);
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        m_hold->setEnabled(m_list->currentRow() >= 0);
        tell();
    });
    connect(m_list, &QListWidget::itemActivated, this, &GroupList::hold);
}

/// Reads in the background, because the file may be large.
void GroupList::read() {
    m_reading.drop();
    take({});
    const Document& document = m_document;
    if (document.isEmpty() || document.domain().kind == DomainKind::Image) return;
    const std::string path = pathIn(document.folder().toStdString(), document.domain().path);
    m_reading.ask([path] { return heldGroups(path); },
                  [this](const Answer<std::vector<HeldGroup>>& groups) { take(groups.value); });
}

void GroupList::take(const std::vector<HeldGroup>& groups) {
    const QString kinds[] = {tr("vertices"), tr("lines"), tr("surfaces"), tr("volumes")};
    m_groups = groups;
    m_list->clear();
    for (std::size_t g = 0; g < groups.size(); ++g) {
        QPixmap chip(12, 12);
        chip.fill(colourOf(static_cast<int>(g)));
        auto* item = new QListWidgetItem(
            chip, tr("%1 (%2 %3)", "name, number and kind of cells")
                      .arg(QString::fromStdString(groups[g].name), QLocale().toString(groups[g].count),
                           kinds[groups[g].dimension]));
        m_list->addItem(item);
    }
    m_hold->setEnabled(false);
    setVisible(!groups.empty());
    tell();
}

void GroupList::tell() {
    if (!isVisible() || m_groups.empty()) return emit marked(nullptr);
    auto marks = std::make_shared<std::vector<GroupMark>>();
    for (std::size_t g = 0; g < m_groups.size(); ++g)
        marks->push_back({colourOf(static_cast<int>(g)), m_groups[g].vertices,
                          static_cast<int>(g) == m_list->currentRow()});
    emit marked(marks);
}

void GroupList::hold() {
    const int row = m_list->currentRow();
    if (row >= 0) holdGroup(m_document, m_selection, m_groups[static_cast<std::size_t>(row)]);
}

void GroupList::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    tell();
}

void GroupList::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    tell();
}

}  // namespace wend
