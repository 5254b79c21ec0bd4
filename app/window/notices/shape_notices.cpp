#include "app/window/notices/shape_notices.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/base/said.h"
#include "app/engine/shape/mesh_rest.h"
#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/shape_session.h"
#include "core/mesh/hanging_parts.h"
#include "core/solver/solver_choice.h"

namespace wend {

namespace {

constexpr int kFewestVertices = 500;  // of which half are still a shape

QString remedyText(const char* text) {
    return QCoreApplication::translate("wend::ProblemRemedies", text);
}

/// The solver's memory grows with the number of vertices only, unlike that of a factor.
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

}  // namespace

QList<InfoBanner::Remedy> problemRemedies(ShapeSession& session) {
    QList<InfoBanner::Remedy> remedies;
    if (session.lacksMemory()) addLessMemory(session.document(), remedies);
    QUndoStack* steps = session.document().undoStack();
    if (steps->canUndo())
        remedies << InfoBanner::Remedy{remedyText(QT_TRANSLATE_NOOP("wend::ProblemRemedies", "Undo")),
                                       [steps] { steps->undo(); }};
    return remedies;
}

ShapeNotices::ShapeNotices(ShapeSession& session, QObject* parent) : QObject(parent), m_session(session) {
    connect(&session, &ShapeSession::frameChanged, this, &ShapeNotices::follow);
    connect(&session.document(), &Document::opened, this, [this] {  // messages belong to the document
        m_shape.reset();
        m_hasTold = false;
    });
}

void ShapeNotices::follow() {
    tell<2>();
    tell<3>();
}

template <int Dim>
void ShapeNotices::tell() {
    const auto frame = m_session.frame<Dim>();
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
    if (!lines.isEmpty() || m_hasTold) emit told(lines.join('\n'), remedies);
    m_hasTold = !lines.isEmpty();
}

/// Core names the vertices; the window shows the parts instead.
template <int Dim>
QString ShapeNotices::hangingText() const {
    const auto parts = static_cast<int>(hangingParts<Dim>(*m_session.frame<Dim>()->rest).size());
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
    const auto frame = m_session.frame<Dim>();
    if (!frame) return;
    m_session.document().beginStep();
    for (const HangingPart& part : hangingParts<Dim>(*frame->rest)) {
        const auto& cell = frame->rest->cells[static_cast<std::size_t>(part.firstCell)];
        m_session.addHandle(std::vector<int>(cell.begin(), cell.end()),
                            ShapeSession::tr("Pin").toStdString());
    }
    m_session.document().endStep();
    m_hasTold = false;
    emit told({}, {});
}

}  // namespace wend
