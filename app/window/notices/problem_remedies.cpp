#include "app/window/notices/problem_remedies.h"

#include <QCoreApplication>

#include "app/project/domain.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/shape_session.h"
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

}  // namespace wend
