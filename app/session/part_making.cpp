#include "app/session/part_making.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "app/engine/shape/part_seam.h"
#include "app/engine/shape/shape.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/part_edits.h"
#include "app/session/shape_session.h"
#include "core/meshing/outline_combination.h"

namespace wend {
namespace {

constexpr double kFeather = 2;        // pixels of the soft edge
constexpr double kSmallestArea = 16;  // pixels²
constexpr double kInFront = 0.5;      // of the area that the best part fills: enough to be cut

QString words(const char* text) {
    return QCoreApplication::translate("PartMaking", text);
}

struct NamedSheet {
    std::string name;
    Sheet sheet;
};

/// Returns the name that a project has for a part of the shape, which may be of before a change of the name;
/// empty if it has none.
std::string nameNow(const std::string& name, const std::vector<PicturePart>& parts,
                    const std::vector<MeshPart>& shown) {
    const auto isNamed = [&](const std::string& one) {
        return std::ranges::find(parts, one, &PicturePart::name) != parts.end();
    };
    if (isNamed(name)) return name;
    const auto isShown = [&](const PicturePart& part) {
        return std::ranges::find(shown, part.name, &MeshPart::name) != shown.end();
    };
    const auto isLost = [&](const MeshPart& part) { return !isNamed(part.name); };
    const bool isRenamed = parts.size() == shown.size() && std::ranges::count_if(shown, isLost) == 1;
    return isRenamed ? std::ranges::find_if_not(parts, isShown)->name : std::string();
}

/// The sheets that an area may be cut from, from front to back, without those that are locked or hidden; none
/// while a picture of parts is being built.
std::vector<NamedSheet> sheetsOf(const ShapeSession& session, const std::string& wholeName) {
    const Document& document = session.document();
    if (document.domain().parts.empty()) return {{wholeName, Sheet{document.picture()}}};
    const auto frame = session.frame<2>();
    if (!frame || !frame->built || !frame->built->texture) return {};
    const Texture& texture = *frame->built->texture;
    const std::vector<PicturePart>& parts = document.domain().parts;
    std::vector<NamedSheet> sheets;
    for (std::size_t i = texture.sheets.size(); i-- > 0;) {
        const std::string name = nameNow(texture.drawn->parts[i].name, parts, texture.drawn->parts);
        if (!name.empty() && !isProtected(parts, name)) sheets.push_back({name, texture.sheets[i]});
    }
    return sheets;
}

/// The frontmost sheet that fills the area about as well as any.
const NamedSheet* sheetBelow(const Outline& area, const std::vector<NamedSheet>& sheets) {
    std::vector<double> covered;
    for (const NamedSheet& one : sheets) covered.push_back(coveredArea(area, one.sheet));
    const auto best = std::ranges::max_element(covered);
    if (best == covered.end() || *best < kSmallestArea) return nullptr;
    const auto front = std::ranges::find_if(covered, [&](double one) { return one >= kInFront * *best; });
    return &sheets[static_cast<std::size_t>(front - covered.begin())];
}

std::string unusedName(const std::vector<PicturePart>& parts, const QString& pattern) {
    for (int i = 1;; ++i) {
        const std::string name = pattern.arg(i).toStdString();
        if (std::ranges::find(parts, name, &PicturePart::name) == parts.end()) return name;
    }
}

bool isPhotograph(const Project& project, const Sheet& sheet) {
    const Domain& domain = domainOf(project);
    return domain.parts.empty() && !sheet.picture->alpha && domain.outline == OutlineKind::Frame &&
           designOf(project).handles.empty();
}

void make(ShapeSession& session, const Outline& area, const Project& before) {
    Document& document = session.document();
    const std::string whole =
        QFileInfo(QString::fromStdString(domainOf(before).path)).completeBaseName().toStdString();
    const std::vector<NamedSheet> sheets = sheetsOf(session, whole);
    if (sheets.empty() && session.isMeshing())
        return session.notify(
            words(QT_TRANSLATE_NOOP("PartMaking",
                                    "The parts are still being made. Another one can be made as soon as "
                                    "they are there.")));
    const NamedSheet* below = sheetBelow(area, sheets);
    if (!below)
        return session.notify(
            std::ranges::any_of(domainOf(before).parts, &PicturePart::locked)
                ? words(QT_TRANSLATE_NOOP("PartMaking",
                                          "In this area is nothing but what is locked, if "
                                          "anything. The list of parts unlocks it."))
                : words(QT_TRANSLATE_NOOP("PartMaking", "There is nothing of the picture in this area.")));
    const auto seam = seamOf(area, below->sheet);
    NewPart made;
    made.from = below->name;
    made.name = unusedName(domainOf(before).parts, words(QT_TRANSLATE_NOOP("PartMaking", "Part %1")));
    made.cut = seam ? withCap(area, *seam) : area;
    made.feather = kFeather;
    if (seam) made.joint = seam->middle;
    if (isPhotograph(before, below->sheet))
        made.heldGround =
            Box<3>{Vec3::Zero(), Vec3(below->sheet.picture->width, below->sheet.picture->height, 0)};
    session.selection().clear();
    document.change(words(QT_TRANSLATE_NOOP("PartMaking", "Make a part")), withNewPart(before, made));
    const QString name = QString::fromStdString(made.name);
    session.notify((seam ? words(QT_TRANSLATE_NOOP("PartMaking",
                                                   "“%1” is a part now, joined to “%2” where it hangs on "
                                                   "it. What is behind it is being filled."))
                         : words(QT_TRANSLATE_NOOP("PartMaking",
                                                   "“%1” is a part now, cut from “%2”. What is behind it "
                                                   "is being filled. Pin it, or join it under Parts.")))
                       .arg(name, QString::fromStdString(made.from)));
}

}  // namespace

void makePart(ShapeSession& session, const Outline& area) {
    make(session, area, *session.document().project());
}

bool makePartOfOutline(ShapeSession& session) {
    const Document& document = session.document();
    if (document.isEmpty() || !document.picture() || document.domain().kind != DomainKind::Image ||
        !document.domain().parts.empty() || document.domain().outline != OutlineKind::Polygons)
        return false;
    const auto before = copyOf(*document.project());
    Domain& domain = domainOf(*before);
    const Outline area = std::exchange(domain.polygons, {});
    domain.outline = document.picture()->alpha ? OutlineKind::Alpha : OutlineKind::Frame;
    make(session, area, *before);
    return true;
}

}  // namespace wend
