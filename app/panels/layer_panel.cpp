#include "app/panels/layer_panel.h"

#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <cmath>

#include "app/base/connect_each.h"
#include "app/engine/shape/stated_units.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/panels/fields/stiffness_fields.h"
#include "app/panels/list_items.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"

namespace wend {

namespace {

constexpr int kCells = Qt::UserRole;  // marks the values per cell

bool hasCells(const MaterialSpec& material) {
    return !(material.cellsFile.empty() && material.cellPhi.empty() && material.cellB.empty());
}

}  // namespace

LayerPanel::LayerPanel(Document& document, LayerChoice& chosen, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_chosen(chosen),
      m_list(new QListWidget(this)),
      m_none(secondLabel(tr("The material is the same everywhere: brush over the shape to change a part."),
                         this)),
      m_values(new QWidget(this)),
      m_paint(new QWidget(m_values)),
      m_pictures(new QWidget(m_values)),
      m_files(secondLabel({}, m_pictures)),
      m_axisNote(secondLabel(tr("Each along a direction of its own."), m_paint)) {
    makeList();
    makeMenu();
    makeChips();
    makeControls();
    arrange();
    connect(&m_document, &Document::projectChanged, this, &LayerPanel::showLayers);
    connect(&m_chosen, &LayerChoice::changed, this, [this] { select(m_chosen.now().id, isCells()); });
    connect(&m_document, &Document::opened, this, [this] {
        m_chosen.set({});
        showUnit();
    });
    showLayers();
}

void LayerPanel::makeList() {
    m_list->setObjectName(QStringLiteral("layers"));
    m_list->setFixedHeight(76);  // four rows, so that the buttons below fit on a small screen
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->setItemDelegate(new EyeDelegate(m_list));
    describe(m_list, tr("Layers"),
             tr("Where the material differs. The topmost layer wins; drag a layer to move it. A click shows "
                "its values, a double-click changes its name, its eye or the space bar switches it off."));
    connectEach(this, &LayerPanel::choose, m_list, &QListWidget::currentRowChanged, m_list,
                &QListWidget::itemClicked);  // a click on the current one counts after a stroke
    connect(m_list, &QListWidget::itemChanged, this, &LayerPanel::takeItem);
    // The list is in the middle of the drop.
    connect(
        m_list->model(), &QAbstractItemModel::rowsMoved, this,
        [this](const QModelIndex&, int from, int, const QModelIndex&, int before) {
            takeOrder(from, before > from ? before - 1 : before);
        },
        Qt::QueuedConnection);
}

void LayerPanel::makeMenu() {
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_rename = m_list->addAction(tr("&Rename"), this, [this] { m_list->editItem(m_list->currentItem()); });
    m_merge = m_list->addAction(tr("&Merge Down"), this, [this] {
        if (auto next = withLayerMergedDown(layers(), selected()))
            change(tr("Merge layers"), *std::move(next));
    });
    m_takeAway = m_list->addAction(tr("Remove"), this, &LayerPanel::remove);
    m_rename->setObjectName(QStringLiteral("layerRename"));
    m_takeAway->setObjectName(QStringLiteral("layerTakeAway"));
    m_merge->setObjectName(QStringLiteral("layerMerge"));
    m_merge->setStatusTip(tr("Makes one layer of the chosen one and the one below it"));
}

void LayerPanel::makeChips() {
    const auto move = [this](int by) { change(tr("Move layer"), withLayerMoved(layers(), selected(), by)); };
    m_up = chip(this, "layerUp", tr("Up"), tr("Lets the chosen layer win over the one above it."),
                [move] { move(1); });
    m_down = chip(this, "layerDown", tr("Down"), tr("Lets the layer below win over the chosen one."),
                  [move] { move(-1); });
    m_remove = chip(this, "layerRemove", tr("Remove"), tr("Removes the chosen layer."), &LayerPanel::remove);
    m_pictureMenu = new QToolButton(this);
    setWords(m_pictureMenu, "layerPictures", tr("Pictures"),
             tr("Imports the material from pictures made in a paint program, and exports it as such."));
    m_pictureMenu->setProperty("role", "chip");
    m_pictureMenu->setPopupMode(QToolButton::InstantPopup);
    m_readAgain =
        chip(this, "layerReadAgain", tr("Read Again"),
             tr("Takes the pictures as they are now, after they have been saved in a paint program."),
             [this] { changeChosen(tr("Read pictures again"), rereadPictures); });
}

void LayerPanel::makeControls() {
    m_hasPhi = new QCheckBox(m_paint);
    setWords(m_hasPhi, "", tr("Keep"), tr("Whether the layer changes Keep, and to what."));
    m_phi = new EnergySlider(m_paint);
    m_ratio = stiffnessField(
        tr("How many times stiffer the layer is along its direction; ×1 is the same as everywhere."),
        m_paint);
    m_ratio->setObjectName(QStringLiteral("layerRatio"));
    m_axis = directionFields(tr("Stiff direction"), {}, m_paint);
    for (ExactBox* box : m_axis) {
        box->setFixedWidth(56);
        box->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    }
    connectEach(this, &LayerPanel::changePaint, m_hasPhi, &QCheckBox::clicked, m_phi,
                &EnergySlider::phiChosen, m_ratio, &QDoubleSpinBox::valueChanged);
    whenChanged(m_axis, this, [this] {
        m_ownAxes = false;
        changePaint();
    });
    m_feather = numberBox<MagnitudeBox>(
        this, "layerFeather", tr("Soft edge"), tr("How wide the edge fades, in the shape's own units."),
        {0, 1e9, -1}, [this](double feather) {
            changeChosen(
                tr("Change soft edge"), [&](MaterialLayer& layer) { setLayerFeather(layer, feather); },
                QStringLiteral("feather %1").arg(qulonglong(selected())));
        });
    m_feather->setDigits(4);
}

void LayerPanel::arrange() {
    auto* layout = sectionColumn(this);
    layout->addLayout(sideBySide({panelTitle(tr("Layers"), this), nullptr, m_pictureMenu}));
    layout->addWidget(m_none);
    layout->addWidget(m_list);
    layout->addLayout(sideBySide({m_up, m_down, nullptr, m_remove}));
    QVBoxLayout* paint = bareColumn(m_paint, 8);
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
    QVBoxLayout* pictures = bareColumn(m_pictures, 8);
    pictures->addWidget(m_files);
    pictures->addWidget(m_readAgain, 0, Qt::AlignLeft);
    QVBoxLayout* values = bareColumn(m_values, 8);
    values->addWidget(m_paint);
    values->addWidget(m_pictures);
    values->addWidget(m_featherRow = panelRowIn(tr("Soft ed&ge"), m_feather, m_values));
    layout->addWidget(m_values);
}

void LayerPanel::setPictureMenu(QMenu* menu) {
    m_pictureMenu->setMenu(menu);
}

/// Applies a changed name or visibility.
void LayerPanel::takeItem(QListWidgetItem* item) {
    const Id id = layerOf(item);
    const MaterialLayer* layer = layerOf(layers(), id);
    if (!layer) return showLayers();
    const std::string wish = item->text().trimmed().toStdString();
    const bool hidden = item->checkState() == Qt::Unchecked;
    if (hidden != layer->isHidden())
        return change(hidden ? tr("Hide layer") : tr("Show layer"),
                      withLayer(layers(), id, [&](MaterialLayer& one) { setLayerHidden(one, hidden); }));
    if (wish.empty() || wish == layer->name) return showLayers();
    change(tr("Rename layer"), withLayerName(layers(), id, wish));
}

/// Moves a layer. The list shows the topmost first. Values given per cell stay at the bottom.
void LayerPanel::takeOrder(int from, int to) {
    if (m_document.isEmpty() || to >= m_list->count()) return;
    const QListWidgetItem* moved = m_list->item(to);
    if (moved->data(kCells).toBool()) return showLayers();
    change(tr("Move layer"), withLayerMoved(layers(), layerOf(moved), from - to));
    showLayers();
}

void LayerPanel::remove() {
    Document& document = m_document;
    if (isCells())
        document.changeDesign(tr("Remove layer"), withoutCells(document.design()));
    else
        change(tr("Remove layer"), withoutLayer(layers(), selected()));
}

const std::vector<MaterialLayer>& LayerPanel::layers() const {
    return m_document.design().material.layers;
}

bool LayerPanel::isCells() const {
    return m_list->currentItem() && m_list->currentItem()->data(kCells).toBool();
}

Id LayerPanel::selected() const {
    return layerOf(m_list->currentItem());
}

void LayerPanel::change(const QString& step, std::vector<MaterialLayer> next, const QString& key) {
    Document& document = m_document;
    if (document.isEmpty()) return;
    Design design = document.design();
    design.material.layers = std::move(next);
    document.changeDesign(step, std::move(design), key);
}

template <class Change>
void LayerPanel::changeChosen(const QString& step, const Change& change, const QString& key) {
    if (!m_document.isEmpty()) this->change(step, withLayer(layers(), selected(), change), key);
}

void LayerPanel::showValues() {
    const bool has = m_list->currentItem() && !m_document.isEmpty();
    m_values->setVisible(has);
    m_none->setVisible(m_list->count() == 0);
    m_list->setVisible(m_list->count() > 0);
    for (QToolButton* button : {m_up, m_down, m_remove}) {
        button->setVisible(m_list->count() > 0);
        allow(button, has, chooseFirst());
    }
    if (const MaterialLayer* layer = has ? layerOf(layers(), selected()) : nullptr) showLayer(*layer);
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
    const bool merges = !isCells() && withLayerMergedDown(layers(), selected());
    allow(m_merge, merges,
          why(below ? tr("One of the two is switched off, is a picture, or erases.")
                    : tr("There is no layer below it.")));
}

void LayerPanel::tellChosen() {
    emit chosen(isVisible() && m_pointed == selected() ? selected() : Id::None);
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
    const Design& design = m_document.design();
    int row = 0;
    for (const MaterialLayer& layer : layers() | std::views::reverse) {
        const LayerValues values = valuesOf(layer);
        QListWidgetItem* item = itemAt(row++);
        item->setIcon(values.pictures.any() ? graySwatch()
                                            : layerSwatch(values.paint, m_document.dimension()));
        item->setText(layer.name.empty() ? tr("Unnamed") : QString::fromStdString(layer.name));
        setLayerOf(*item, layer.id);
        item->setData(kCells, false);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled | Qt::ItemIsEditable |
                       Qt::ItemIsUserCheckable);
        item->setCheckState(layer.isHidden() ? Qt::Unchecked : Qt::Checked);
    }
    if (hasCells(design.material)) {
        QListWidgetItem* cells = itemAt(row++);
        cells->setIcon(graySwatch());
        cells->setText(tr("Values of cells"));
        setLayerOf(*cells, Id::None);
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
    const bool cells = isCells();
    {
        const QSignalBlocker quiet(m_list);
        m_document.isEmpty() ? m_list->clear() : fill();
    }
    select(m_chosen.now().id, cells);
}

/// Selects the layer that was chosen here or elsewhere, or the values of cells, which can be chosen only
/// here; nothing if it no longer exists.
void LayerPanel::select(Id layer, bool cells) {
    int row = -1;
    for (int i = 0; i < m_list->count(); ++i) {
        const QListWidgetItem* item = m_list->item(i);
        if (layer == Id::None ? cells && item->data(kCells).toBool() : layerOf(item) == layer) row = i;
    }
    if (row < 0 && layer != Id::None) return m_chosen.set({});
    {
        const QSignalBlocker quiet(m_list);
        m_list->setCurrentRow(row);
    }
    showValues();
}

/// Outline the layer only if the user clicked it, not after a stroke.
void LayerPanel::choose() {
    m_pointed = selected();
    const bool cells = isCells();
    if (m_chosen.now().id == m_pointed) return select(m_pointed, cells);
    const QSignalBlocker quiet(m_chosen);
    m_chosen.set({m_pointed});
    select(m_pointed, cells);
}

// --- Values of the chosen layer ---

/// Ignores a change that would empty the layer.
void LayerPanel::changePaint() {
    MaterialPaint paint;
    if (m_hasPhi->isChecked()) paint.phi = m_phi->phi();
    Vec3 axis = Vec3::Zero();
    for (int k = 0; k < m_document.dimension(); ++k) axis[k] = m_axis[k]->exact();
    if (axis.isZero(0)) axis = Vec3::UnitX();
    if (std::abs(axis.norm() - 1) >= 1e-12) axis.normalize();  // unit vectors keep their bits
    if (m_ratio->exact() != 1) paint.stiffness = Stiffness{axis, m_ratio->exact()};
    if (!paint.phi && !paint.stiffness) return showValues();
    m_phi->setEnabled(paint.phi.has_value());
    changeChosen(
        tr("Change layer"), [&](MaterialLayer& layer) { setLayerPaint(layer, paint, m_ownAxes); },
        QStringLiteral("layer %1").arg(qulonglong(selected())));
}

void LayerPanel::showLayer(const MaterialLayer& layer) {
    const LayerValues values = valuesOf(layer);
    const std::optional<double>& phi = values.paint.phi;
    const double ratio = values.paint.stiffness ? values.paint.stiffness->ratio : 1;
    const int dimension = m_document.dimension();
    m_phi->setDimension(dimension);
    m_hasPhi->setChecked(phi.has_value());
    m_phi->setEnabled(phi.has_value());
    if (phi) m_phi->setPhi(*phi);
    m_ratio->put(ratio);
    allowDirection(ratio != 1);
    m_ownAxes = !values.oneAxis;
    m_axisNote->setVisible(m_ownAxes);
    const Vec3 axis = values.axis.value_or(Vec3::UnitX());
    for (int k = 0; k < 3; ++k) m_axis[k]->setVisible(k < dimension);
    for (int k = 0; k < dimension; ++k) m_axis[k]->put(axis[k]);
    m_feather->put(values.feather);
    showPictures(values.pictures);
}

void LayerPanel::allowDirection(bool isStiff) {
    for (ExactBox* box : m_axis) {
        box->setEnabled(isStiff);
        describe(box, tr("Stiff direction"),
                 isStiff ? tr("At rest; it turns with the shape. A change is for all regions of the layer.")
                         : tr("Stiffness ×1 has no direction: first choose how many times stiffer it is."));
    }
}

/// Shows the unit of a picture, or of a mesh file.
void LayerPanel::showUnit() {
    const Document& document = m_document;
    if (document.isEmpty()) return;
    const Domain& domain = document.domain();
    const QString unit = QString::fromStdString(
        domain.kind == DomainKind::Image ? "px"
                                         : statedUnits(pathIn(document.folder().toStdString(), domain.path)));
    m_feather->setSuffix(unit.isEmpty() ? unit : ' ' + unit);
}

void LayerPanel::showPictures(const MaterialPictures& pictures) {
    QStringList lines;
    for (const auto& [text, file] : {std::pair{tr("Keep: %1"), pictures.phi},
                                     {tr("Stiffness: %1"), pictures.stiffness},
                                     {tr("Direction: %1"), pictures.direction}})
        if (!file.empty()) lines << text.arg(QFileInfo(QString::fromStdString(file)).fileName());
    m_files->setText(lines.join('\n'));
    m_paint->setVisible(lines.isEmpty());
    m_pictures->setVisible(!lines.isEmpty());
    m_readAgain->show();
    m_featherRow->show();
}

void LayerPanel::showCells() {
    const std::string& file = m_document.design().material.cellsFile;
    m_files->setText(file.empty()
                         ? tr("As the project's file says, cell by cell.")
                         : tr("Cell by cell: %1").arg(QFileInfo(QString::fromStdString(file)).fileName()));
    m_paint->hide();
    m_pictures->show();
    m_readAgain->hide();
    m_featherRow->hide();
}

}  // namespace wend
