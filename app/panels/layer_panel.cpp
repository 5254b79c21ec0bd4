#include "app/panels/layer_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>

#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/panels/fields/stiffness_fields.h"
#include "app/panels/layer_items.h"

namespace wend {

namespace {

constexpr int kGroup = Qt::UserRole;      // the name of an item's regions
constexpr int kCells = Qt::UserRole + 1;  // marks the values per cell

bool hasCells(const MaterialSpec& material) {
    return !(material.cellsFile.empty() && material.cellPhi.empty() && material.cellB.empty());
}

}  // namespace

LayerPanel::LayerPanel(ShapeSession& session, LayerChoice& chosen, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_chosen(chosen),
      m_list(new QListWidget(this)),
      m_up(new QToolButton(this)),
      m_down(new QToolButton(this)),
      m_remove(new QToolButton(this)),
      m_pictureMenu(new QToolButton(this)),
      m_rename(new QAction(tr("&Rename"), m_list)),
      m_merge(new QAction(tr("&Merge Down"), this)),
      m_takeAway(new QAction(tr("Remove"), m_list)),
      m_none(secondLabel(tr("The material is the same everywhere: brush over the shape to change a part."),
                         this)),
      m_values(new QWidget(this)),
      m_paint(new QWidget(m_values)),
      m_pictures(new QWidget(m_values)),
      m_files(secondLabel({}, m_pictures)),
      m_readAgain(new QToolButton(m_pictures)),
      m_hasPhi(new QCheckBox(tr("Keep"), m_paint)),
      m_phi(new EnergySlider(m_paint)),
      m_ratio(stiffnessField(
          tr("How many times stiffer the layer is along its direction; ×1 is the same as everywhere."),
          m_paint)),
      m_axisNote(secondLabel(tr("Each along a direction of its own."), m_paint)),
      m_feather(new MagnitudeBox(m_values)) {
    makeList();
    makeControls();
    arrange();
    connectControls();
    showLayers();
}

void LayerPanel::makeList() {
    m_list->setObjectName(QStringLiteral("layers"));
    m_list->setFixedHeight(76);  // four rows, so that the buttons below fit on a small screen
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->setItemDelegate(new EyeDelegate(m_list));
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_list->addActions({m_rename, m_merge, m_takeAway});
    m_rename->setObjectName(QStringLiteral("layerRename"));
    m_takeAway->setObjectName(QStringLiteral("layerTakeAway"));
    m_merge->setObjectName(QStringLiteral("layerMerge"));
    m_merge->setStatusTip(tr("Makes one layer of the chosen one and the one below it"));
    describe(m_list, tr("Layers"),
             tr("Where the material differs. The topmost layer wins; drag a layer to move it. A click shows "
                "its values, a double-click changes its name, its eye or the space bar switches it off."));
    const auto make = [](QToolButton* button, const char* id, const QString& text, const QString& help) {
        button->setObjectName(QLatin1String(id));
        button->setText(text);
        button->setProperty("role", "chip");
        describe(button, text, help);
    };
    make(m_up, "layerUp", tr("Up"), tr("Lets the chosen layer win over the one above it."));
    make(m_down, "layerDown", tr("Down"), tr("Lets the layer below win over the chosen one."));
    make(m_remove, "layerRemove", tr("Remove"), tr("Removes the chosen layer."));
    make(m_pictureMenu, "layerPictures", tr("Pictures"),
         tr("Imports the material from pictures made in a paint program, and exports it as such."));
    m_pictureMenu->setPopupMode(QToolButton::InstantPopup);
    make(m_readAgain, "layerReadAgain", tr("Read Again"),
         tr("Takes the pictures as they are now, after they have been saved in a paint program."));
}

void LayerPanel::makeControls() {
    describe(m_hasPhi, tr("Keep"), tr("Whether the layer changes Keep, and to what."));
    m_ratio->setObjectName(QStringLiteral("layerRatio"));
    m_axis = directionFields(tr("Stiff direction"), {}, m_paint);
    for (ExactBox* box : m_axis) {
        box->setFixedWidth(56);
        box->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    }
    m_feather->setObjectName(QStringLiteral("layerFeather"));
    m_feather->setRange(0, 1e9);
    m_feather->setDigits(4);
    describe(m_feather, tr("Soft edge"), tr("How wide the edge fades, in the shape's own units."));
}

void LayerPanel::arrange() {
    auto* layout = sectionColumn(this);
    layout->addLayout(sideBySide({panelTitle(tr("Layers"), this), nullptr, m_pictureMenu}));
    layout->addWidget(m_none);
    layout->addWidget(m_list);
    layout->addLayout(sideBySide({m_up, m_down, nullptr, m_remove}));
    const auto column = [](QWidget* of) {
        auto* values = bareColumn(of, 8);
        return values;
    };
    QVBoxLayout* paint = column(m_paint);
    paint->addWidget(m_hasPhi);
    paint->addWidget(m_phi);
    paint->addLayout(panelRow(tr("Stiffness"), m_ratio, m_paint));
    auto* axis = new QHBoxLayout;
    axis->setSpacing(4);
    auto* label = new QLabel(tr("Direction"), m_paint);
    label->setBuddy(m_axis[0]);
    axis->addWidget(label);
    axis->addStretch(1);
    for (ExactBox* box : m_axis) axis->addWidget(box);
    paint->addLayout(axis);
    paint->addWidget(m_axisNote);
    QVBoxLayout* pictures = column(m_pictures);
    pictures->addWidget(m_files);
    pictures->addWidget(m_readAgain, 0, Qt::AlignLeft);
    QVBoxLayout* values = column(m_values);
    values->addWidget(m_paint);
    values->addWidget(m_pictures);
    values->addWidget(m_featherRow = panelRowIn(tr("Soft ed&ge"), m_feather, m_values));
    layout->addWidget(m_values);
}

void LayerPanel::connectControls() {
    connect(&m_session.document(), &Document::projectChanged, this, &LayerPanel::showLayers);
    connect(&m_chosen, &LayerChoice::changed, this, [this] { select(isNameless(), isCells()); });
    connect(&m_session.document(), &Document::opened, this, [this] {
        m_chosen.set({});
        showUnit();
    });
    connect(m_list, &QListWidget::currentRowChanged, this, &LayerPanel::choose);
    connect(m_list, &QListWidget::itemClicked, this,
            &LayerPanel::choose);  // also after a stroke
    connect(m_list, &QListWidget::itemChanged, this, &LayerPanel::takeItem);
    // The list is in the middle of the drop.
    connect(
        m_list->model(), &QAbstractItemModel::rowsMoved, this,
        [this](const QModelIndex&, int from, int, const QModelIndex&, int before) {
            takeOrder(from, before > from ? before - 1 : before);
        },
        Qt::QueuedConnection);
    connect(m_readAgain, &QToolButton::clicked, this, [this] {
        changeBy(tr("Read pictures again"), withPicturesReread(m_session.document().design(), selected()));
    });
    const auto move = [this](int by) {
        changeBy(tr("Move layer"), withGroupMoved(m_session.document().design(), selected(), by));
    };
    connect(m_up, &QToolButton::clicked, this, [move] { move(1); });
    connect(m_down, &QToolButton::clicked, this, [move] { move(-1); });
    connect(m_remove, &QToolButton::clicked, this, &LayerPanel::remove);
    connect(m_takeAway, &QAction::triggered, this, &LayerPanel::remove);
    connect(m_rename, &QAction::triggered, this, [this] { m_list->editItem(m_list->currentItem()); });
    connect(m_merge, &QAction::triggered, this, [this] {
        if (auto next = withGroupMergedDown(m_session.document().design(), selected()))
            changeBy(tr("Merge layers"), *std::move(next));
    });
    const auto changeMaterial = [this] { changePaint(); };
    connect(m_hasPhi, &QCheckBox::clicked, this, changeMaterial);
    connect(m_phi, &EnergySlider::phiChosen, this, changeMaterial);
    connect(m_ratio, &QDoubleSpinBox::valueChanged, this, changeMaterial);
    for (ExactBox* box : m_axis)
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, changeMaterial] {
            m_ownAxes = false;
            changeMaterial();
        });
    connect(m_feather, &QDoubleSpinBox::valueChanged, this, [this](double feather) {
        changeBy(tr("Change soft edge"), withGroupFeather(m_session.document().design(), selected(), feather),
                 QStringLiteral("feather ") + QString::fromStdString(selected()));
    });
}

void LayerPanel::setPictureMenu(QMenu* menu) {
    m_pictureMenu->setMenu(menu);
}

/// Applies a changed name or visibility.
void LayerPanel::takeItem(QListWidgetItem* item) {
    const Design& design = m_session.document().design();
    const std::string before = item->data(kGroup).toString().toStdString();
    const std::string wish = item->text().trimmed().toStdString();
    const bool hidden = item->checkState() == Qt::Unchecked;
    if (hidden != isGroupHidden(design, before))
        return changeBy(hidden ? tr("Hide layer") : tr("Show layer"),
                        withGroupHidden(design, before, hidden));
    if (wish.empty() || wish == before) return showLayers();
    const std::string name = freeGroupName(design, before, wish);
    const QSignalBlocker quiet(m_list);
    item->setData(kGroup, QString::fromStdString(name));  // it stays the chosen one
    if (m_chosen.now().name == before) m_chosen.set({name, m_chosen.now().aim});
    if (m_pointed == before) m_pointed = name;
    changeBy(tr("Rename layer"), withGroupName(design, before, name));
}

/// Moves a layer. The list shows the topmost first. Values given per cell stay at the bottom.
void LayerPanel::takeOrder(int from, int to) {
    if (m_session.document().isEmpty() || to >= m_list->count()) return;
    const QListWidgetItem* moved = m_list->item(to);
    if (moved->data(kCells).toBool()) return showLayers();
    changeBy(tr("Move layer"), withGroupMoved(m_session.document().design(),
                                              moved->data(kGroup).toString().toStdString(), from - to));
    showLayers();
}

void LayerPanel::remove() {
    const Design& design = m_session.document().design();
    changeBy(tr("Remove layer"), isCells() ? withoutCells(design) : withoutGroup(design, selected()));
}

bool LayerPanel::isCells() const {
    return m_list->currentItem() && m_list->currentItem()->data(kCells).toBool();
}

std::string LayerPanel::selected() const {
    const QListWidgetItem* item = m_list->currentItem();
    return item ? item->data(kGroup).toString().toStdString() : std::string();
}

void LayerPanel::changeBy(const QString& step, Design next, const QString& key) {
    if (m_session.document().isEmpty()) return;
    m_session.document().changeDesign(step, std::move(next), key);
}

void LayerPanel::showValues() {
    const bool has = m_list->currentItem() && !m_session.document().isEmpty();
    m_values->setVisible(has);
    m_none->setVisible(m_list->count() == 0);
    m_list->setVisible(m_list->count() > 0);
    for (QToolButton* button : {m_up, m_down, m_remove}) {
        button->setVisible(m_list->count() > 0);
        allow(button, has, chooseFirst());
    }
    if (has) showGroup();
    if (isCells()) showCells();
    allowOrder(has);
    tellChosen();
}

/// Enables the commands for the chosen layer.
void LayerPanel::allowOrder(bool has) {
    allow(m_takeAway, has, chooseFirst());
    allow(m_rename, has && m_list->currentItem()->flags() & Qt::ItemIsEditable,
          has ? tr("What a file says of each cell has no name.") : chooseFirst());
    if (!has) return allow(m_merge, false, chooseFirst());
    const QListWidgetItem* below = m_list->item(m_list->currentRow() + 1);
    const bool onCells = below && below->data(kCells).toBool();
    const QString stays = tr("What a file gives cell by cell stays lowest."),
                  lowest = tr("This is already the lowest layer.");
    const auto why = [&](const QString& atTheEnd) { return isCells() || onCells ? stays : atTheEnd; };
    allow(m_up, m_list->currentRow() > 0 && !isCells(),
          isCells() ? stays : tr("This is already the topmost layer."));
    allow(m_down, below && !onCells, why(lowest));
    const bool merges = !isCells() && withGroupMergedDown(m_session.document().design(), selected());
    allow(m_merge, merges,
          why(below ? tr("One of the two is switched off, is a picture, or erases.")
                    : tr("There is no layer below it.")));
}

void LayerPanel::tellChosen() {
    const bool has = m_list->currentItem() && isVisible() && m_pointed == selected();
    emit chosen(has ? m_list->currentItem()->data(kGroup).toString() : QString());
}

void LayerPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    tellChosen();
}

void LayerPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    tellChosen();
}

void LayerPanel::fill() {
    const Design& design = m_session.document().design();
    const auto groups = regionGroups(design);
    int row = 0;
    for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
        const QString name = QString::fromStdString(group->name);
        QListWidgetItem* item = itemAt(row++);
        item->setIcon(group->pictures.any() ? graySwatch()
                                            : layerSwatch(group->paint, m_session.document().dimension()));
        item->setText(name.isEmpty() ? tr("Unnamed") : name);
        item->setData(kGroup, name);
        item->setData(kCells, false);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled | Qt::ItemIsEditable |
                       Qt::ItemIsUserCheckable);
        item->setCheckState(group->hidden ? Qt::Unchecked : Qt::Checked);
    }
    if (hasCells(design.material)) {
        QListWidgetItem* cells = itemAt(row++);
        cells->setIcon(graySwatch());
        cells->setText(tr("Values of cells"));
        cells->setData(kGroup, {});
        cells->setData(kCells, true);
        cells->setData(Qt::CheckStateRole, {});
        cells->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    }
    while (m_list->count() > row) delete m_list->takeItem(row);
}

/// Reuses existing items: the list may be in the middle of a change.
QListWidgetItem* LayerPanel::itemAt(int row) {
    if (row == m_list->count()) m_list->addItem(new QListWidgetItem);
    return m_list->item(row);
}

void LayerPanel::showLayers() {
    const bool nameless = isNameless(), cells = isCells();
    {
        const QSignalBlocker quiet(m_list);
        m_session.document().isEmpty() ? m_list->clear() : fill();
    }
    select(nameless, cells);
}

/// Unnamed layers and values per cell can be chosen only here.
bool LayerPanel::isNameless() const {
    return m_list->currentItem() && selected().empty();
}

/// Selects the layer that was chosen elsewhere, or the unnamed one; nothing if it no longer exists.
void LayerPanel::select(bool nameless, bool cells) {
    const std::string name = m_chosen.now().name;
    int row = -1;
    for (int i = 0; i < m_list->count(); ++i) {
        const QListWidgetItem* item = m_list->item(i);
        const bool isOne = item->data(kGroup).toString().toStdString() == name;
        if (isOne && (name.empty() ? nameless && item->data(kCells).toBool() == cells : true)) row = i;
    }
    if (row < 0 && !name.empty()) return m_chosen.set({});
    {
        const QSignalBlocker quiet(m_list);
        m_list->setCurrentRow(row);
    }
    showValues();
}

/// Outline the layer only if the user clicked it, not after a stroke.
void LayerPanel::choose() {
    m_pointed = m_list->currentItem() ? std::optional(selected()) : std::nullopt;
    const bool nameless = isNameless(), cells = isCells();
    if (m_chosen.now().name == selected()) return select(nameless, cells);
    const QSignalBlocker quiet(m_chosen);
    m_chosen.set({selected()});
    select(nameless, cells);
}

}  // namespace wend
