#include "app/panels/mesh_panel.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/engine/shape/shape.h"
#include "app/panels/cut_out_panel.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/domain.h"
#include "app/project/edits/part_edits.h"
#include "app/project/edits/setting_edits.h"
#include "warp/image.h"

namespace wend {

namespace {

constexpr int kFewest = 200, kMost = 100000;

// The density slider is logarithmic over the usual range.
int sliderOf(int vertices) {
    return static_cast<int>(
        std::lround(1000 * std::log(vertices / double(kFewest)) / std::log(kMost / double(kFewest))));
}
int verticesOf(int slider) {
    const double exact = kFewest * std::pow(kMost / double(kFewest), slider / 1000.0);
    const double unit = std::pow(10, std::floor(std::log10(exact)) - 1);
    return static_cast<int>(std::lround(exact / unit) * unit);
}

enum Aim { ByVertices, ByVolume };

/// Returns the size of the largest cell, rounded up to two digits.
double largestCell(const PosedFrame<3>& frame) {
    double maximum = 0;
    for (const Cell<3>& cell : frame.rest->cells)
        maximum = std::max(maximum, std::abs(cellMeasure<3>(frame.rest->points, cell)));
    const double unit = std::pow(10, std::floor(std::log10(maximum)) - 1);
    return std::ceil(maximum / unit) * unit;
}

}  // namespace

MeshPanel::MeshPanel(Document& document, ShapeMotion& motion, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_motion(motion),
      m_settings(document, this, CutOutPanel::notACutOut()),
      m_density(new JumpSlider(this)),
      m_skin(secondLabel({}, this)),
      m_counts(secondLabel({}, this)) {
    makeControls();
    makeSkin();
    arrange();
    connect(&m_document, &Document::projectChanged, this, &MeshPanel::showProject);
    connect(&m_motion, &ShapeMotion::frameChanged, this, &MeshPanel::showCounts);
    showProject();
}

void MeshPanel::makeControls() {
    m_density->setRange(0, 1000);
    connect(m_density, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(m_density, &QSlider::valueChanged, this, [this](int value) {
        if (m_part < 0)
            changeSetting(m_document, "domain.vertices", verticesOf(value), m_gesture);
        else
            changePartSetting(m_document, m_part, "domain.vertices", verticesOf(value), m_gesture);
    });
    m_aim = choiceBox(this, "", tr("Aim"),
                      tr("What sets how fine the mesh is: how many vertices it has in total, or how large a "
                         "tetrahedron may be."),
                      {tr("Vertices"), tr("Maximum volume")}, [this](int aim) { setAim(aim == ByVolume); });
    m_whose = choiceBox(
        this, "outlineOf", tr("Outline and detail of"),
        tr("Which part of the picture has the outline and detail below; all have the same unless one "
           "has its own. Choosing a part in the list of parts chooses it here."),
        {}, [this](int row) { setPart(row - 1); });
    for (QComboBox* box : {m_aim, m_whose}) fitToEntries(box, 150);
    m_asAll =
        chip(this, "outlineAsAll", tr("As All Parts"),
             tr("Gives this part the outline and detail of all parts again."), [this] {
                 if (m_part >= 0)
                     m_document.change(m_asAll->text(), withoutOwnOutline(*m_document.project(), m_part));
             });
    m_sizes = chip(this, "paintSizes", tr("Paint…"),
                   tr("Paints where the mesh should be finer or coarser, or sets it by regions in numbers."),
                   &MeshPanel::sizesWanted, tr("Cell sizes"));
}

/// Makes the rows of the detailed surface that is embedded in a solid.
void MeshPanel::makeSkin() {
    auto* choose =
        chip(this, "chooseDetail", tr("Choose…"),
             tr("Takes a detailed, perhaps textured surface from a file and embeds it in the solid; the view "
                "shows it, and surface formats contain it."),
             &MeshPanel::detailWanted, tr("Choose skin"));
    m_removeSkin = chip(this, "removeDetail", tr("Remove"),
                        tr("Shows and exports the solid with its own surface again."),
                        &MeshPanel::detailRemoved, tr("Remove skin"));
    m_skinRows = new QWidget(this);
    auto* layout = bareColumn(m_skinRows, 6);
    layout->addLayout(panelRow(tr("Skin"), choose, m_skinRows));
    auto* row = sideBySide({m_skin, m_removeSkin});
    row->setStretch(0, 1);
    layout->addLayout(row);
}

void MeshPanel::showSkin(const std::string& file) {
    const QString path = QString::fromStdString(file);
    m_skin->setText(QFileInfo(path).fileName());
    m_skin->setToolTip(QDir::toNativeSeparators(path));
    for (QWidget* part : std::initializer_list<QWidget*>{m_skin, m_removeSkin})
        part->setVisible(!path.isEmpty());
}

void MeshPanel::arrange() {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("Mesh"), this));
    const auto add = [&](QWidget* widget) {
        layout->addWidget(widget);
        return widget;
    };
    const auto row = [&](const char* key) { return add(m_settings.row(key)); };
    m_whoseRow = add(panelRowIn(tr("&Of"), m_whose, this));
    add(m_asAll);
    m_pictureRows = {row("domain.outline.from"), row("domain.outline.threshold"),
                     row("domain.outline.margin")};
    m_border = row("domain.border");
    QWidget* fit = row("domain.cage");
    QWidget* aim = add(panelRowIn(tr("A&im at"), m_aim, this));
    QWidget* vertices = row("domain.vertices");
    describe(m_density, tr("Detail: coarse – fine"),
             m_settings.field("domain.vertices").focusProxy()->statusTip());
    add(m_density);
    m_volumeRows = {row("domain.maxVolume")};
    m_shells = row("domain.shells");
    QWidget* quality = row("domain.quality");
    QWidget* refine = row("domain.refineSurface");
    QWidget* sizes = add(panelRowIn(tr("Finer and coarser"), m_sizes, this));
    add(m_skinRows);
    m_solidRows = {fit, aim, quality, refine, sizes};
    m_surfaceRows = {vertices, m_density};
    add(m_counts);
}

/// Begins with the volume that the mesh has now, so that it stays about as fine.
void MeshPanel::setAim(bool volume) {
    const bool isVolume = m_document.domain().maxVolume > 0;
    if (volume == isVolume) return;
    const auto frame = m_motion.frame<3>();
    if (volume && !frame) {
        showProject();
        return;
    }
    Domain next = m_document.domain();
    next.maxVolume = volume ? largestCell(*frame) : 0;
    m_document.changeDomain(volume ? tr("Aim at a volume") : tr("Aim at vertices"), std::move(next));
}

void MeshPanel::showProject() {
    const Document& document = m_document;
    const bool meshed = !document.isEmpty() && document.domain().kind != DomainKind::Mesh;
    showRows();
    setEnabled(meshed);
    setToolTip(document.isEmpty() || meshed ? QString()
                                            : tr("The mesh comes from a file and is used as it is."));
    if (document.isEmpty()) return;
    showParts();
    m_settings.show();
    const Domain& domain = document.domain();
    const auto whole = m_part < 0 ? document.project() : asWhole(*document.project(), m_part);
    OptionField& outline = m_settings.field("domain.outline.from");
    const bool clear = hasAlpha();
    outline.allow(static_cast<int>(OutlineKind::Alpha), clear, tr("This picture has no transparency."));
    outline.allow(kFilledCutOut, clear, tr("This picture has no transparency."));
    outline.allow(static_cast<int>(OutlineKind::Polygons), !domainOf(*whole).polygons.loops.empty(),
                  tr("No outline has been drawn."));
    showDetail();
    m_aim->setCurrentIndex(domain.maxVolume > 0 ? ByVolume : ByVertices);
    showSkin(domain.detail);
}

void MeshPanel::setPart(int part) {
    if (m_document.isEmpty()) return;
    const std::vector<PicturePart>& parts = m_document.domain().parts;
    const bool isPart = part >= 0 && part < static_cast<int>(parts.size());
    m_partName = isPart ? parts[static_cast<std::size_t>(part)].name : std::string();
    showProject();
}

/// Shows the choice of a part, which may have moved or be gone.
void MeshPanel::showParts() {
    const std::vector<PicturePart>& parts = m_document.domain().parts;
    const auto found = std::ranges::find(parts, m_partName, &PicturePart::name);
    const int before =
        std::exchange(m_part, found == parts.end() ? -1 : static_cast<int>(found - parts.begin()));
    m_settings.setPart(m_part);
    if (m_part != before) emit partChosen(m_part);
    m_whose->clear();
    m_whose->addItem(tr("All parts"));
    for (const PicturePart& part : parts) m_whose->addItem(QString::fromStdString(part.name));
    m_whose->setCurrentIndex(m_part + 1);
    m_asAll->setVisible(m_part >= 0 && hasOwnOutline(parts[static_cast<std::size_t>(m_part)]));
}

/// Returns whether the picture that is chosen has transparency; of all parts one is enough.
bool MeshPanel::hasAlpha() const {
    const Document& document = m_document;
    const auto frame = m_motion.frame<2>();
    const Texture* texture = frame && frame->built ? frame->built->texture.get() : nullptr;
    if (document.domain().parts.empty() || !texture || !texture->drawn)
        return document.picture() && document.picture()->alpha;
    for (std::size_t i = 0; i < texture->sheets.size(); ++i) {
        const bool counts = m_part < 0 || texture->drawn->parts[i].name ==
                                              document.domain().parts[static_cast<std::size_t>(m_part)].name;
        if (counts && texture->sheets[i].picture->alpha) return true;
    }
    return false;
}

/// Returns how many vertices the mesh of the chosen part has.
int MeshPanel::partVertices() const {
    const auto frame = m_motion.frame<2>();
    const std::string& name = m_document.domain().parts[static_cast<std::size_t>(m_part)].name;
    if (frame)
        for (const MeshPart& part : frame->rest->parts)
            if (part.name == name) return part.endVertex - part.firstVertex;
    return kFewest;
}

/// Shows the number of vertices that is aimed at; of a part without an own one, how many it has.
void MeshPanel::showDetail() {
    const Domain& domain = m_document.domain();
    int vertices = domain.vertices;
    if (m_part >= 0) {
        const int own = domain.parts[static_cast<std::size_t>(m_part)].vertices;
        vertices = own > 0 ? own : partVertices();
        m_settings.field("domain.vertices").setNumber(vertices);
    }
    const QSignalBlocker quiet(m_density);
    if (!m_density->isSliderDown()) m_density->setValue(sliderOf(std::max(vertices, kFewest)));
}

/// Rows that stay are not hidden in between, because their fields would lose the focus.
void MeshPanel::showRows() {
    const Document& document = m_document;
    const bool solid = document.dimension() == 3;
    const bool surface = solid && document.domain().kind == DomainKind::Surface;
    const bool volume = surface && document.domain().maxVolume > 0;
    const auto show = [](const std::vector<QWidget*>& rows, bool visible) {
        for (QWidget* row : rows) row->setVisible(visible);
    };
    show(m_pictureRows, !solid);
    const bool parted = !solid && !document.isEmpty() && !document.domain().parts.empty();
    m_border->setVisible(!solid && m_part < 0);
    m_whoseRow->setVisible(parted);
    if (!parted) m_asAll->hide();
    show(m_surfaceRows, !solid || (surface && !volume));
    show(m_solidRows, surface);
    show(m_volumeRows, volume);
    m_skinRows->setVisible(solid);
    showShells();
}

/// Shows the choice where there is one.
void MeshPanel::showShells() {
    const Document& document = m_document;
    const bool surface = document.dimension() == 3 && document.domain().kind == DomainKind::Surface;
    const auto frame = m_motion.frame<3>();
    m_shells->setVisible(surface && (document.domain().shells != Shells::Automatic ||
                                     (frame && frame->built && frame->built->hasSpaces)));
}

void MeshPanel::showCounts() {
    const FramePtr& frame = m_motion.frame();
    showShells();
    if (m_part >= 0 && m_part < static_cast<int>(m_document.domain().parts.size())) showDetail();
    if (!frame) {
        m_counts->clear();
        return;
    }
    const QLocale locale;
    const QString text =
        frame->dimension == 3 ? tr("%1 vertices, %2 tetrahedra") : tr("%1 vertices, %2 triangles");
    m_counts->setText(text.arg(locale.toString(frame->used), locale.toString(frame->cells)));
}

}  // namespace wend
