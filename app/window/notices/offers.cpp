#include "app/window/notices/offers.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "app/base/connect_each.h"
#include "app/base/in_background.h"
#include "app/base/said.h"
#include "app/engine/motion/playback.h"
#include "app/engine/shape/mesh_rest.h"
#include "app/engine/shape/shape.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/document.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/part_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/shape_session.h"
#include "app/window/notices/info_banner.h"
#include "core/base/error.h"
#include "core/mesh/hanging_parts.h"
#include "core/mesh/segments.h"
#include "core/motion/constraints.h"
#include "core/solver/solver_choice.h"
#include "warp/convert.h"
#include "warp/drawn_picture.h"
#include "warp/outline.h"

namespace wend {

namespace {

constexpr double kFaint = 0.01;  // opacity above which the wider outline includes a pixel

bool isDrawingFile(const QString& path) {
    try {
        return isDrawing(path.toStdString());
    } catch (const std::exception&) {
        return false;
    }
}

constexpr double kBack = 1e-6;  // relative to how far the map was from the identity
constexpr int kSamples = 64;

constexpr int kFewestVertices = 500;  // of which half are still a shape

QString remedyText(const char* text) {
    return QCoreApplication::translate("wend::ProblemRemedies", text);
}

/// Offers multigrid, whose memory only grows with the number of vertices, unlike that of a factor, and fewer
/// vertices.
void addLessMemory(Document& document, QList<InfoBanner::Remedy>& remedies) {
    constexpr auto kMultigrid = static_cast<double>(SolverKind::Multigrid);
    if (settingOf(document, "integration.solver") != kMultigrid)
        remedies << InfoBanner::Remedy{
            remedyText(QT_TRANSLATE_NOOP("wend::ProblemRemedies", "Use Multigrid")),
            [&document, kMultigrid] { changeSetting(document, "integration.solver", kMultigrid); }};
    const double vertices = settingOf(document, "domain.vertices");
    const bool isMeshed = document.domain().kind != DomainKind::Mesh;
    if (isMeshed && vertices >= 2 * kFewestVertices)
        remedies << InfoBanner::Remedy{
            remedyText(QT_TRANSLATE_NOOP("wend::ProblemRemedies", "Half as Many Vertices")),
            [&document, vertices] { changeSetting(document, "domain.vertices", vertices / 2); }};
}

/// Makes a sentence of a remark. An initial file path keeps its case: only a first word, followed by a space,
/// is capitalized.
QString sentence(const QString& remark) {
    QString result = remark;
    const QString first = remark.section(' ', 0, 0);
    if (!first.isEmpty() && std::ranges::all_of(first, [](QChar c) { return c.isLower(); }))
        result[0] = result[0].toUpper();
    if (!result.endsWith('.')) result += '.';
    return result;
}

// --- Soft edges ---

constexpr float kLeastMissed = 0.02F;  // less is not missed
constexpr double kMuch = 0.01;         // of the pixels within

enum Pixel : std::uint8_t { Nothing, Faint, Within };

class PixelKinds {
  public:
    PixelKinds(const Image& picture, double threshold)
        : m_width(picture.width),
          m_height(picture.height),
          m_kinds(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height)) {
        const auto channels = static_cast<std::size_t>(picture.channels);
        std::vector<float> row(static_cast<std::size_t>(m_width) * channels);
        std::size_t at = 0;
        for (int y = 0; y < m_height; ++y) {
            loadRow(picture, y, row.data());
            for (std::size_t i = channels - 1; i < row.size(); i += channels)
                m_kinds[at++] = row[i] >= static_cast<float>(threshold) ? Within
                                : row[i] > kLeastMissed                 ? Faint
                                                                        : Nothing;
        }
    }
    std::size_t count(Pixel kind) const {
        return static_cast<std::size_t>(std::ranges::count(m_kinds, kind));
    }
    /// Counts faint pixels farther than `reach` pixels from the outline.
    std::size_t countFar(int reach) const {
        std::size_t count = 0;
        for (int y = 0; y < m_height; ++y)
            for (int x = 0; x < m_width; ++x) count += at(x, y) == Faint && isFar(x, y, reach);
        return count;
    }

  private:
    Pixel at(int x, int y) const {
        return static_cast<Pixel>(m_kinds[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                                          static_cast<std::size_t>(x)]);
    }
    bool isFar(int x, int y, int reach) const {
        for (int v = std::max(0, y - reach); v <= std::min(m_height - 1, y + reach); ++v)
            for (int u = std::max(0, x - reach); u <= std::min(m_width - 1, x + reach); ++u)
                if (at(u, v) == Within) return false;
        return true;
    }

    int m_width, m_height;
    std::vector<std::uint8_t> m_kinds;
};

// --- Line art ---

constexpr double kMostInk = 0.4;    // of what the strokes enclose
constexpr double kThickest = 0.04;  // of the picture's diagonal: the mean width of a stroke

struct InkMeasure {
    double area = 0, length = 0;
};

/// Measures with the even-odd rule: holes count against what they are in.
InkMeasure measured(const Outline& outline) {
    InkMeasure sum;
    for (const auto& loop : outline.loops) {
        sum.area += loopArea(loop);
        for (std::size_t k = 0; k < loop.size(); ++k)
            sum.length += (loop[(k + 1) % loop.size()] - loop[k]).norm();
    }
    sum.area = std::abs(sum.area);
    return sum;
}

}  // namespace

bool hasOpaqueEdges(const Image& picture) {
    constexpr float kFull = 0.99F;
    if (!picture.alpha) return true;
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<float> row(static_cast<std::size_t>(picture.width) * channels);
    for (const int y : {0, picture.height - 1}) {
        loadRow(picture, y, row.data());
        for (std::size_t i = channels - 1; i < row.size(); i += channels)
            if (row[i] < kFull) return false;
    }
    return true;
}

bool cutsSoftEdges(const Image& picture, const AlphaOutlineOptions& outline) {
    if (!picture.alpha) return false;
    const PixelKinds pixels(picture, outline.threshold);
    const double much = kMuch * static_cast<double>(pixels.count(Within));
    if (static_cast<double>(pixels.count(Faint)) <= much) return false;
    return static_cast<double>(pixels.countFar(static_cast<int>(std::ceil(outline.margin)))) > much;
}

bool isLineArt(const Image& picture, const AlphaOutlineOptions& outline) {
    if (!picture.alpha) return false;
    try {
        AlphaOutlineOptions strokes = outline;
        strokes.margin = 0;
        strokes.holes = OutlineHoles::Kept;
        const InkMeasure ink = measured(outlineFromAlpha(picture, strokes));
        strokes.holes = OutlineHoles::Filled;
        const InkMeasure whole = measured(outlineFromAlpha(picture, strokes));
        const double width = ink.length > 0 ? 2 * ink.area / ink.length : 0;
        return ink.area < kMostInk * whole.area &&
               width < kThickest * std::hypot(picture.width, picture.height);
    } catch (const InputError&) {
        return false;
    }
}

Offers::Offers(Document& document, InfoBanner& banner, QAction& size, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_banner(banner),
      m_size(size),
      m_all{border(), softEdges(), lineArt(), drawing(), parts()} {
    connect(&m_document, &Document::opened, this, &Offers::look);
    connect(&m_document, &Document::projectChanged, this, &Offers::follow);
}

bool Offers::isCutOut() const {
    if (m_document.isEmpty() || !m_document.picture()) return false;
    const Domain& domain = m_document.domain();
    return domain.kind == DomainKind::Image && domain.outline == OutlineKind::Alpha;
}

Offers::Offer Offers::border() {
    const auto matters = [this] {
        if (m_document.isEmpty() || !m_document.picture()) return false;
        const Domain& domain = m_document.domain();
        return domain.kind == DomainKind::Image && domain.outline == OutlineKind::Frame &&
               domain.parts.empty() && domain.border == Border::Free && hasOpaqueEdges(*m_document.picture());
    };
    const auto hold = [this] {
        changeSetting(m_document, "domain.border", static_cast<double>(Border::Fixed));
    };
    const Words words{
        tr("This picture fills its frame. If its border is held, it bends inside and no gap opens "
           "at the edges."),
        {{tr("Hold the Border"), hold}}};
    return {InfoBanner::Topic::Border, matters, {}, [words] { return words; }};
}

Offers::Offer Offers::softEdges() {
    const auto matters = [this] { return isCutOut() && m_document.domain().alpha.threshold > kFaint; };
    const auto take = [this] { changeSetting(m_document, "domain.outline.threshold", kFaint); };
    const Words words{tr("Soft edges or shadows of this picture reach beyond the cut-out, and are cut off."),
                      {{tr("Include Them"), take}}};
    return {InfoBanner::Topic::SoftEdges, matters, cutsSoftEdges, [words] { return words; }};
}

Offers::Offer Offers::lineArt() {
    const auto matters = [this] {
        return isCutOut() && m_document.domain().alpha.holes == OutlineHoles::Kept;
    };
    const auto fill = [this] { changeSetting(m_document, "domain.outline.from", double(kFilledCutOut)); };
    const Words words{
        tr("This picture is mostly thin lines, and only the lines would bend. Filled holes bend what "
           "they enclose, too."),
        {{tr("Fill the Holes"), fill}}};
    return {InfoBanner::Topic::LineArt, matters, isLineArt, [words] { return words; }};
}

Offers::Offer Offers::parts() {
    const auto matters = [this] {
        return !m_document.isEmpty() && !m_document.domain().parts.empty() &&
               !m_document.source().endsWith(QStringLiteral(".wend"));
    };
    const auto flatten = [this] {
        m_document.change(tr("Open flattened"),
                          withoutParts(*m_document.project(), m_document.source().toStdString()));
    };
    const auto words = [this, flatten]() -> Words {
        const std::vector<PicturePart>& parts = m_document.domain().parts;
        const int count = static_cast<int>(parts.size());
        if (std::ranges::any_of(parts, [](const PicturePart& part) { return part.layer.empty(); }))
            return {tr("%n pictures were opened as parts: each bends by itself. Join them where they "
                       "meet, under Parts.",
                       nullptr, count),
                    {}};
        return {tr("%n layers were opened as parts: each bends by itself. Join them where they meet, under "
                   "Parts.",
                   nullptr, count),
                m_isDrawing ? QList<InfoBanner::Remedy>{{tr("Open Flattened"), flatten}, sizeButton()}
                            : QList<InfoBanner::Remedy>{{tr("Open Flattened"), flatten}}};
    };
    return {InfoBanner::Topic::Parts, matters, {}, words};
}

InfoBanner::Remedy Offers::sizeButton() {
    return {tr("Another Size…"), [this] { m_size.trigger(); }};
}

/// Returns the offer for a drawing. If it has several layers, the line about its parts has the button.
Offers::Offer Offers::drawing() {
    const auto matters = [this] {
        return m_isDrawing && !m_document.isEmpty() && m_document.picture() &&
               m_document.domain().parts.empty();
    };
    const auto words = [this]() -> Words {
        const Image& picture = *m_document.picture();
        return {tr("This drawing became a picture of %1 × %2 pixels.").arg(picture.width).arg(picture.height),
                {sizeButton()}};
    };
    return {InfoBanner::Topic::Drawing, matters, {}, words};
}

/// Large pictures take a while to check.
void Offers::look() {
    m_made.clear();
    m_isDrawing = false;
    if (!m_document.path().isEmpty()) return;
    m_isDrawing = isDrawingFile(m_document.source());
    for (const Offer& offer : m_all) {
        if (!offer.matters() || !m_document.design().handles.empty()) continue;
        if (!offer.isCalledFor) {
            make(offer);
            continue;
        }
        const auto picture = m_document.picture();
        inBackground(
            this,
            [picture, outline = m_document.domain().alpha, check = offer.isCalledFor] {
                return check(*picture, outline);
            },
            [this, picture, &offer](bool isCalledFor) {
                if (isCalledFor && m_document.picture() == picture && offer.matters()) make(offer);
            });
    }
}

void Offers::make(const Offer& offer) {
    m_made.insert(offer.topic);
    const Words words = offer.words();
    m_banner.tell(offer.topic, words.text, words.remedies);
}

void Offers::follow() {
    for (const Offer& offer : m_all)
        if (m_made.contains(offer.topic) && !offer.matters()) {
            m_made.erase(offer.topic);
            m_banner.clear(offer.topic);
        }
}

RidingOffer::RidingOffer(ShapeSession& session, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_session(session), m_banner(banner) {
    connect(&session.document(), &Document::opened, this, [this] {
        m_offered = 0;
        m_lookedAt.reset();
    });
    connect(&session.motion(), &ShapeMotion::frameChanged, this, &RidingOffer::look);
}

/// Looks at every project once, when its motion is there.
void RidingOffer::look() {
    const Document& document = m_session.document();
    const ShapeMotion& motion = m_session.motion();
    if (document.isEmpty() || document.dimension() != 2 || motion.isDragging() || motion.isBusy() ||
        motion.isStale() || document.project() == m_lookedAt)
        return;
    m_lookedAt = document.project();
    const bool moves = m_session.playback().end() > 0;  // at rest nothing stays behind
    const std::vector<StrayPart> strays = moves ? strayParts(m_session) : std::vector<StrayPart>();
    if (strays.empty()) m_banner.clear(InfoBanner::Topic::Riding);
    if (!strays.empty() && strays.size() != m_offered) offer(strays);
    m_offered = strays.size();
}

void RidingOffer::offer(const std::vector<StrayPart>& strays) {
    const auto count = static_cast<int>(strays.size());
    const std::string& host = strays.front().host;
    const bool isOneHost =
        !host.empty() && std::ranges::all_of(strays, [&](const StrayPart& one) { return one.host == host; });
    const QString name = QString::fromStdString(host);
    const QString one = isOneHost
                            ? tr("A part has no pin and stays behind: let it ride on “%1”?").arg(name)
                            : tr("A part has no pin and stays behind: let it ride on what is beside it?");
    const QString many =
        isOneHost
            ? tr("%n parts have no pin and stay behind: let them ride on “%1”?", nullptr, count).arg(name)
            : tr("%n parts have no pin and stay behind: let them ride on what is beside them?", nullptr,
                 count);
    const auto ride = [this, strays] {
        Document& document = m_session.document();
        m_banner.clear(InfoBanner::Topic::Riding);
        if (document.project() == m_lookedAt)
            document.change(tr("Let parts ride"), withRiders(*document.project(), strays));
    };
    m_banner.tell(InfoBanner::Topic::Riding, count == 1 ? one : many,
                  {{count == 1 ? tr("Let It Ride") : tr("Let Them Ride"), ride}});
}

bool comesBack(const Pin& handle) {
    const auto isField = [](const PinMotion& motion) {
        return std::holds_alternative<FieldMotion<3>>(motion.kind);
    };
    if (handle.motions.empty() || std::ranges::any_of(handle.motions, isField)) return false;
    try {
        const HandleTimeline<3> timeline(handleIn<3>(handle));
        const double from = handle.motions.front().start, to = handle.motions.back().end;
        double farthest = 0, atEnd = 0;
        for (int k = 0; k <= kSamples; ++k) {
            const auto map = timeline.bodyAt(from + (to - from) * k / kSamples, Side::Before).position;
            atEnd = map.b.norm() + (map.A - Mat3::Identity()).norm();
            farthest = std::max(farthest, atEnd);
        }
        return atEnd < kBack * farthest;
    } catch (const InputError&) {
        return false;  // the motion itself says so
    }
}

SpringOffer::SpringOffer(Document& document, const Playback& playback, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_document(document), m_playback(playback), m_banner(banner) {
    connect(&document, &Document::opened, this, [this] {
        m_isOffered = m_isDeclined = false;
        follow();
    });
    connectEach(this, &SpringOffer::follow, &document, &Document::projectChanged, &playback,
                &Playback::loopsChanged);
}

bool SpringOffer::isDue() const {
    if (m_document.isEmpty() || settingOf(m_document, "material.memory") != 0) return false;
    if (motionEnd(*m_document.project()) <= 0) return false;
    if (m_playback.loops()) return true;
    return std::ranges::any_of(m_document.design().handles, comesBack);
}

/// Shows or removes the offer, which is made once for a document.
void SpringOffer::follow() {
    const bool isDue = this->isDue();
    if (isDue == m_isOffered || (isDue && m_isDeclined)) return;
    m_isOffered = isDue;
    if (!isDue) return m_banner.clear(InfoBanner::Topic::Spring);
    m_isDeclined = true;
    const auto take = [this] {
        changeSetting(m_document, "material.memory", std::numeric_limits<double>::infinity());
    };
    m_banner.tell(
        InfoBanner::Topic::Spring,
        tr("What comes back leaves the shape a little different, so that a loop jumps. If the shape "
           "springs back fully, it is as it was."),
        {{tr("Spring Back Fully"), take}});
}

QList<InfoBanner::Remedy> problemRemedies(Document& document, bool lacksMemory) {
    QList<InfoBanner::Remedy> remedies;
    if (lacksMemory) addLessMemory(document, remedies);
    QUndoStack* steps = document.undoStack();
    if (steps->canUndo())
        remedies << InfoBanner::Remedy{remedyText(QT_TRANSLATE_NOOP("wend::ProblemRemedies", "Undo")),
                                       [steps] { steps->undo(); }};
    return remedies;
}

ShapeNotices::ShapeNotices(ShapeSession& session, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_session(session), m_banner(banner) {
    connect(&session.motion(), &ShapeMotion::frameChanged, this, &ShapeNotices::follow);
    connect(&session.document(), &Document::opened, this, [this] {  // messages belong to the document
        m_shape.reset();
        m_hasShown = false;
    });
}

void ShapeNotices::follow() {
    tell<2>();
    tell<3>();
}

template <int Dim>
void ShapeNotices::tell() {
    const auto frame = m_session.motion().frame<Dim>();
    if (!frame || frame->shape == m_shape) return;
    m_shape = frame->shape;
    QStringList lines;
    QList<InfoBanner::Remedy> remedies;
    const auto& notices = frame->built->notices;
    const Message hanging = notices.empty() ? Message() : hangingNotice<Dim>(*frame->rest);
    for (const Message& notice : notices) {
        lines << (notice == hanging.text() ? hangingText<Dim>() : sentence(said(notice)));
        if (notice == hanging.text()) remedies = {{tr("Pin It"), [this] { pinHanging<Dim>(); }}};
    }
    if (frame->built->cage && !frame->built->cage->why.isEmpty())
        remedies << InfoBanner::Remedy{tr("See Why"), [this] { emit reasonWanted(); }};
    if (frame->built->hasSpaces && m_session.document().domain().shells == Shells::Automatic) {
        const auto choose = [this](Shells shells) {
            return [this, shells] {
                changeSetting(m_session.document(), "domain.shells", static_cast<double>(shells));
            };
        };
        remedies << InfoBanner::Remedy{tr("Fill All, with Labels"), choose(Shells::Regions)}
                 << InfoBanner::Remedy{tr("Leave Holes"), choose(Shells::Holes)};
    }
    if (frame->built->refineHelps)
        lines << tr("“Refine surface” in the panel “Mesh” allows the surface's triangles to be split.");
    if (!lines.isEmpty() || m_hasShown) m_banner.tell(InfoBanner::Topic::Mesh, lines.join('\n'), remedies);
    m_hasShown = !lines.isEmpty();
}

/// Core names the vertices; the window shows the parts instead.
template <int Dim>
QString ShapeNotices::hangingText() const {
    const auto parts = static_cast<int>(hangingParts<Dim>(*m_session.motion().frame<Dim>()->rest).size());
    if (parts == 1)
        return tr(
            "A part is joined to the rest at a single point, and may swing around it unless a pin holds it.");
    return tr(
        "%n parts are joined to the rest at single points, and may swing around them unless pins hold them.",
        nullptr, parts);
}

/// Pins one cell of each part, which then neither moves nor rotates, in one step.
template <int Dim>
void ShapeNotices::pinHanging() {
    const auto frame = m_session.motion().frame<Dim>();
    if (!frame) return;
    m_session.document().beginStep();
    for (const HangingPart& part : hangingParts<Dim>(*frame->rest)) {
        const auto& cell = frame->rest->cells[static_cast<std::size_t>(part.firstCell)];
        m_session.addHandle(std::vector<int>(cell.begin(), cell.end()),
                            ShapeSession::tr("Pin").toStdString());
    }
    m_session.document().endStep();
    m_hasShown = false;
    m_banner.clear(InfoBanner::Topic::Mesh);
}

}  // namespace wend
