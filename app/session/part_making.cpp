#include "app/session/part_making.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "app/engine/shape/shape.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/part_edits.h"
#include "app/session/shape_session.h"
#include "core/base/disjoint_sets.h"
#include "core/mesh/boundary_loops.h"
#include "core/mesh/cell_geometry.h"
#include "core/meshing/outline_combination.h"
#include "warp/pixels.h"

namespace wend {

namespace {

constexpr double kBeside = 1.5;        // pixels from the border at which both sides are looked at
constexpr double kShortest = 3;        // pixels of a seam
constexpr double kLargestShare = 0.4;  // of the border
constexpr double kOnly = 0.3;          // a stretch that is shorter than that of the longest is noise
constexpr int kCapCorners = 32;
constexpr int kSamplesAcross = 64;  // of an area, in each direction

bool isOpaqueAt(const Sheet& sheet, const Vec2& p) {
    const Image& picture = *sheet.picture;
    const Vec2 pixel = (p - sheet.at).array().floor();
    if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() >= picture.width || pixel.y() >= picture.height)
        return false;
    if (!picture.alpha) return true;
    return withPixelType(picture.type, [&](auto t) {
        using T = decltype(t);
        const T* row = reinterpret_cast<const T*>(picture.row(static_cast<int>(pixel.y())));
        const std::ptrdiff_t x = static_cast<std::ptrdiff_t>(pixel.x());
        return static_cast<float>(row[x * picture.channels + picture.channels - 1]) >= kFull<T> / 2;
    });
}

/// A stretch of samples of a closed border.
struct Stretch {
    std::size_t first = 0, count = 0;
};

/// Samples of a closed polygon's border a pixel apart, and whether the picture is on both sides of each.
class BorderSamples {
  public:
    BorderSamples(const std::vector<Vec2>& loop, const Sheet& sheet) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2& a = loop[i];
            const Vec2 side = loop[(i + 1) % loop.size()] - a;
            const int steps = std::max(1, static_cast<int>(std::lround(side.norm())));
            const Vec2 across = kBeside * Vec2(-side.y(), side.x()).normalized();
            for (int k = 0; k < steps && side.norm() > 0; ++k) {
                const Vec2 p = a + (k + 0.5) / steps * side;
                m_places.push_back(p);
                m_goesOn.push_back(isOpaqueAt(sheet, p + across) && isOpaqueAt(sheet, p - across));
            }
        }
    }

    std::size_t size() const { return m_places.size(); }
    const Vec2& at(std::size_t i) const { return m_places[i % size()]; }

    /// Returns the stretches where the picture continues, the longest first; none if it does so everywhere.
    std::vector<Stretch> stretches() const {
        std::vector<Stretch> all;
        const auto start = std::ranges::find(m_goesOn, false);
        if (start == m_goesOn.end()) return all;
        const auto offset = static_cast<std::size_t>(start - m_goesOn.begin());
        for (std::size_t i = 1; i <= size(); ++i) {
            if (!m_goesOn[(offset + i) % size()]) continue;
            if (!m_goesOn[(offset + i - 1) % size()]) all.push_back({offset + i, 0});
            ++all.back().count;
        }
        std::ranges::sort(all, std::ranges::greater(), &Stretch::count);
        return all;
    }

  private:
    std::vector<Vec2> m_places;
    std::vector<bool> m_goesOn;
};

}  // namespace

double coveredArea(const Outline& area, const Sheet& sheet) {
    Vec2 low = Vec2::Constant(INFINITY), high = -low;
    for (const auto& loop : area.loops)
        for (const Vec2& p : loop) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const Vec2 step = (high - low) / kSamplesAcross;
    int covered = 0;
    for (int j = 0; j < kSamplesAcross; ++j)
        for (int i = 0; i < kSamplesAcross; ++i) {
            const Vec2 p = low + step.cwiseProduct(Vec2(i + 0.5, j + 0.5));
            if (isOpaqueAt(sheet, p) && isInside(area, p)) ++covered;
        }
    return covered * step.prod();
}

std::optional<PartSeam> seamOf(const Outline& area, const Sheet& sheet) {
    if (area.loops.size() != 1) return std::nullopt;
    const BorderSamples border(area.loops.front(), sheet);
    const std::vector<Stretch> stretches = border.stretches();
    if (stretches.empty()) return std::nullopt;
    const auto length = static_cast<double>(stretches.front().count);
    const bool isOnly = stretches.size() == 1 || static_cast<double>(stretches[1].count) < kOnly * length;
    if (!isOnly || length < kShortest || length > kLargestShare * static_cast<double>(border.size()))
        return std::nullopt;
    const Vec2 from = border.at(stretches.front().first),
               to = border.at(stretches.front().first + stretches.front().count - 1);
    return PartSeam{(from + to) / 2, (to - from).norm() / 2};
}

Outline withCap(const Outline& area, const PartSeam& seam) {
    std::vector<Vec2> disc;
    for (int k = 0; k < kCapCorners; ++k) {
        const double angle = 2 * std::numbers::pi * k / kCapCorners;
        disc.push_back(seam.middle + seam.radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return combined(area, {{disc}}, OutlineOperation::Add);
}

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

/// Returns the sheets that an area may be cut from, from front to back, without those that are locked or
/// hidden; none while a picture of parts is being built.
std::vector<NamedSheet> sheetsOf(const ShapeSession& session, const std::string& wholeName) {
    const Document& document = session.document();
    if (document.domain().parts.empty()) return {{wholeName, Sheet{document.picture()}}};
    const auto frame = session.motion().frame<2>();
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

/// Returns the frontmost sheet that fills the area about as well as the best one; null if none does.
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
    if (sheets.empty() && session.motion().isMeshing())
        return session.document().notify(
            words(QT_TRANSLATE_NOOP("PartMaking",
                                    "The parts are still being made. Another one can be made as soon as "
                                    "they are there.")));
    const NamedSheet* below = sheetBelow(area, sheets);
    if (!below)
        return session.document().notify(
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
    session.document().notify(
        (seam ? words(QT_TRANSLATE_NOOP("PartMaking",
                                        "“%1” is a part now, joined to “%2” where it hangs on "
                                        "it. What is behind it is being filled."))
              : words(QT_TRANSLATE_NOOP("PartMaking",
                                        "“%1” is a part now, cut from “%2”. What is behind it "
                                        "is being filled. Pin it, or join it under Parts.")))
            .arg(name, QString::fromStdString(made.from)));
}

constexpr std::size_t kMostIslands = 24;  // more are noise
constexpr int kTried = 40;                // vertices of a part whose distance to others is measured

/// The vertices of a picture's mesh that move together: through cells and joints.
class HeldPieces {
  public:
    HeldPieces(const ShapeSession& session, const SimplicialMesh<2>& rest)
        : m_rest(rest), m_sets(rest.vertexCount()) {
        for (const Cell<2>& cell : rest.cells)
            for (const int v : cell) m_sets.join(cell[0], v);
        for (const Weld& weld : rest.welds)
            for (const auto& [v, weight] : weld.terms) m_sets.join(weld.terms.front().first, v);
        for (const auto& pins : {session.gestures().pins(true), session.gestures().ghosts()})
            for (const PinView& pin : pins)
                for (const Place& place : pin.places) m_held.insert(rootOfCell(place.cell));
    }

    int rootOfCell(int cell) { return m_sets.root(m_rest.cells[static_cast<std::size_t>(cell)][0]); }
    bool isHeld(int cell) { return m_held.contains(rootOfCell(cell)); }
    bool isAnyHeld() const { return !m_held.empty(); }

  private:
    const SimplicialMesh<2>& m_rest;
    DisjointSets m_sets;
    std::set<int> m_held;
};

double distanceBetween(const SimplicialMesh<2>& rest, const MeshPart& one, const MeshPart& other) {
    const int step = std::max(1, (one.endVertex - one.firstVertex) / kTried);
    double least = std::numeric_limits<double>::infinity();
    for (int v = one.firstVertex; v < one.endVertex; v += step)
        for (int w = other.firstVertex; w < other.endVertex; ++w)
            least = std::min(least, (rest.points.col(v) - rest.points.col(w)).squaredNorm());
    return least;
}

double areaOf(const SimplicialMesh<2>& rest, const MeshPart& part) {
    double area = 0;
    for (int c = part.firstCell; c < part.endCell; ++c)
        area += std::abs(cellMeasure<2>(rest.points, rest.cells[static_cast<std::size_t>(c)]));
    return area;
}

bool isIn(const SimplicialMesh<2>& rest, const MeshPart& part, const Vec2& p) {
    const auto cells = std::span(rest.cells)
                           .subspan(static_cast<std::size_t>(part.firstCell),
                                    static_cast<std::size_t>(part.endCell - part.firstCell));
    return std::ranges::any_of(
        cells, [&](const Cell<2>& cell) { return barycentric<2>(rest.points, cell, p).minCoeff() >= 0; });
}

/// Returns whether another part is under at least half of a part.
bool liesOn(const SimplicialMesh<2>& rest, const MeshPart& part, const MeshPart& other) {
    const auto points = rest.points.middleCols(other.firstVertex, other.endVertex - other.firstVertex);
    const Eigen::AlignedBox2d box(Vec2(points.rowwise().minCoeff()), Vec2(points.rowwise().maxCoeff()));
    const int step = std::max(1, (part.endVertex - part.firstVertex) / kTried);
    int tried = 0, inside = 0;
    for (int v = part.firstVertex; v < part.endVertex; v += step, ++tried) {
        const Vec2 p = rest.points.col(v);
        inside += box.contains(p) && isIn(rest, other, p);
    }
    return 2 * inside >= tried;
}

/// Finds parts whose cells are all stray, each with what it could ride on.
class StrayFinder {
  public:
    StrayFinder(const std::vector<PicturePart>& parts, const SimplicialMesh<2>& rest, HeldPieces& pieces)
        : m_parts(parts), m_rest(rest) {
        for (const MeshPart& part : rest.parts) {
            bool isHeld = false;
            for (int c = part.firstCell; c < part.endCell && !isHeld; ++c) isHeld = pieces.isHeld(c);
            (isHeld ? m_held : m_stray).push_back(&part);
        }
    }

    /// Returns the stray parts with their hosts. A part on top of another stray part gets that one as its
    /// host, once that one has a host itself.
    std::vector<StrayPart> find() {
        if (m_held.empty()) return {};
        std::vector<std::pair<const MeshPart*, const MeshPart*>> lying;
        for (const MeshPart* part : m_stray) {
            const MeshPart* nearest = *std::ranges::min_element(
                m_held, {}, [&](const MeshPart* other) { return distanceBetween(m_rest, *part, *other); });
            const MeshPart* carrier = carrierOf(*part, *nearest);
            if (carrier)
                lying.emplace_back(part, carrier);
            else if (areaOf(m_rest, *part) < areaOf(m_rest, *nearest))  // a larger one is a ground
                add(*part, *nearest);
        }
        for (std::size_t count = m_found.size() + 1; count != m_found.size();) {
            count = m_found.size();
            for (const auto& [part, carrier] : lying)
                if (isFound(*carrier) && !isFound(*part)) add(*part, *carrier);
        }
        return std::move(m_found);
    }

  private:
    /// Returns the smallest stray part under a part; null if there is none. A part that is also under the
    /// held one is the ground of both and does not count.
    const MeshPart* carrierOf(const MeshPart& part, const MeshPart& held) const {
        const MeshPart* smallest = nullptr;
        for (const MeshPart* other : m_stray) {
            const double area = areaOf(m_rest, *other);
            if (area > areaOf(m_rest, part) && (!smallest || area < areaOf(m_rest, *smallest)) &&
                liesOn(m_rest, part, *other) && !liesOn(m_rest, held, *other))
                smallest = other;
        }
        return smallest;
    }
    bool isFound(const MeshPart& part) const {
        return std::ranges::find(m_found, part.name, &StrayPart::name) != m_found.end();
    }
    void add(const MeshPart& part, const MeshPart& host) {
        if (mayRide(m_parts, placeOf(part), placeOf(host))) m_found.push_back({part.name, host.name});
    }
    int placeOf(const MeshPart& part) const {
        return static_cast<int>(std::ranges::find(m_parts, part.name, &PicturePart::name) - m_parts.begin());
    }

    const std::vector<PicturePart>& m_parts;
    const SimplicialMesh<2>& m_rest;
    std::vector<const MeshPart*> m_stray, m_held;
    std::vector<StrayPart> m_found;
};

/// Islands of a picture without parts.
std::vector<StrayPart> islandsOf(const SimplicialMesh<2>& rest, HeldPieces& pieces) {
    std::map<int, SimplicialMesh<2>> islands;
    for (int c = 0; c < rest.cellCount(); ++c) {
        if (pieces.isHeld(c)) continue;
        SimplicialMesh<2>& island = islands[pieces.rootOfCell(c)];
        island.points = rest.points;
        island.cells.push_back(rest.cells[static_cast<std::size_t>(c)]);
        if (islands.size() > kMostIslands) return {};
    }
    std::vector<StrayPart> found;
    for (const auto& [root, island] : islands) found.push_back({{}, {}, {boundaryLoops(island)}});
    return found;
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

std::vector<StrayPart> strayParts(const ShapeSession& session) {
    const auto frame = session.motion().frame<2>();
    const Document& document = session.document();
    if (!frame || document.isEmpty() || document.domain().kind != DomainKind::Image) return {};
    HeldPieces pieces(session, *frame->rest);
    if (!pieces.isAnyHeld()) return {};
    const std::vector<PicturePart>& parts = document.domain().parts;
    return parts.empty() ? islandsOf(*frame->rest, pieces) : StrayFinder(parts, *frame->rest, pieces).find();
}

std::shared_ptr<const Project> withRiders(const Project& project, const std::vector<StrayPart>& strays) {
    auto next = copyOf(project);
    std::vector<PicturePart>& parts = domainOf(*next).parts;
    if (parts.empty()) {
        PicturePart& whole = parts.emplace_back();
        whole.path = std::exchange(domainOf(*next).path, {});
        whole.name = QFileInfo(QString::fromStdString(whole.path)).completeBaseName().toStdString();
    }
    const std::string whole = parts.back().name;
    int count = 0;
    for (const StrayPart& stray : strays) {
        if (!stray.name.empty()) {
            std::ranges::find(parts, stray.name, &PicturePart::name)->ridesOn = stray.host;
            continue;
        }
        PicturePart island;
        do island.name = QCoreApplication::translate("PartMaking", "Part %1").arg(++count).toStdString();
        while (std::ranges::find(parts, island.name, &PicturePart::name) != parts.end());
        island.cutFrom = island.ridesOn = whole;
        island.cut = stray.island;
        island.outline = PartOutline{OutlineKind::Alpha, {}, {}};
        parts.insert(parts.end() - 1, std::move(island));
    }
    return next;
}

}  // namespace wend
