// Fixes of a surface's faults, computed in the background and previewed.

#include <QLocale>
#include <QStringList>
#include <map>
#include <utility>

#include "app/base/in_background.h"
#include "app/panels/surface_panel.h"
#include "app/project/domain.h"
#include "app/window/surface/surface_check.h"
#include "core/base/disjoint_sets.h"
#include "core/meshing/fix_all.h"

namespace wend {

/// Computes the fix of this fault.
void SurfaceCheck::propose() {
    m_fix.reset();
    if (m_all.kind != m_place.kind || m_all.found != m_found) m_all = {m_found, m_place.kind};
    tellOfFix();
    if (m_found->faults.empty()) return;
    const auto find = [found = m_found, place = m_place] {
        const FaultKind& kind = found->faults[place.kind];
        return std::make_shared<const FaultFix>(
            fixFor(found->source, found->fixes, kind.name, kind.cases[place.number]));
    };
    const auto take = [this, found = m_found, place = m_place](const std::shared_ptr<const FaultFix>& fix) {
        if (m_found != found || m_place != place) return;
        m_fix = fix;
        tellOfFix();
        if (m_isPlaceShown && m_canvas) showPlace(true);
    };
    inBackground(this, find, take);
}

/// Computes the fix of all faults of this kind once one of them is shown: it takes seconds for dense
/// surfaces.
void SurfaceCheck::proposeAll() {
    if (!m_found || m_all.isSought || m_found->faults[m_place.kind].cases.size() < 2) return;
    m_all.isSought = true;
    const auto find = [found = m_found, kind = m_place.kind, largestHole = m_panel.largestHole()] {
        return std::make_shared<const FaultFix>(
            fixForAll(found->source, found->fixes, found->faults[kind].name, largestHole));
    };
    const auto take = [this, sought = m_all](const std::shared_ptr<const FaultFix>& all) {
        if (m_all.found != sought.found || m_all.kind != sought.kind || m_all.limit != sought.limit) return;
        m_all.fix = all;
        const bool isWanted = std::exchange(m_all.isWanted, false);
        tellOfFix();
        if (isWanted) fixAll();
    };
    inBackground(this, find, take);
}

QString SurfaceCheck::textOf(const FaultFix& fix) const {
    int all = 0;
    for (const FaultKind& kind : m_found->faults) all += static_cast<int>(kind.cases.size());
    const QString does = wouldDo({{tr("drop triangles (%1)"), fix.dropped},
                                  {tr("turn triangles (%1)"), fix.turned},
                                  {tr("add triangles (%1)"), fix.added}});
    return does + ' ' +
           tr("It would leave %1 of %2 faults.").arg(QLocale().toString(fix.faults), QLocale().toString(all));
}

void SurfaceCheck::tellOfFix() {
    const auto told = [this](const std::shared_ptr<const FaultFix>& fix, const QString& none) {
        if (!fix) return QString();
        return fix->steps.empty() ? none : textOf(*fix);
    };
    if (m_all.isWanted) {
        m_panel.showFix(tr("Looking for what fixes all of these …"), false);
        return m_panel.showFixOfAll({}, false);
    }
    m_panel.showFix(told(m_fix, tr("No simple step fixes this one.")), m_fix && !m_fix->steps.empty());
    m_panel.showFixOfAll(told(m_all.fix, tr("No simple steps fix all of these.")),
                         !m_all.fix || !m_all.fix->steps.empty());
}

/// Applies a fix in one undo step and shows the next fault of the kind.
void SurfaceCheck::fix(const std::shared_ptr<const FaultFix>& fix, const QString& name) {
    if (!m_found || !fix || fix->steps.empty()) return;
    Document& document = m_session.document();
    Domain next = document.domain();
    next.fixes = m_found->fixes;
    next.fixes.insert(next.fixes.end(), fix->steps.begin(), fix->steps.end());
    m_goesOn = true;
    m_fixedKind = m_found->faults[m_place.kind].name;
    m_fix.reset();
    m_all = {};
    m_panel.showFix({}, false);  // once only
    m_panel.showFixOfAll({}, false);
    document.changeDomain(name, std::move(next));
}

/// Applies the fix as soon as it is known.
void SurfaceCheck::fixAll() {
    if (const auto known = m_all.fix) return fix(known, tr("Fix all faults of a kind"));
    m_all.isWanted = true;
    tellOfFix();
    proposeAll();
}

void SurfaceCheck::repair(int largestHole) {
    Document& document = m_session.document();
    Domain next = document.domain();
    next.repair = true;
    next.largestHole = largestHole;
    document.changeDomain(tr("Repair surface"), std::move(next));
}

/// Previews the repair with another limit.
void SurfaceCheck::tryLimit(int largestHole) {
    if (!m_found) return;
    m_all = {m_found, m_place.kind, largestHole};
    tellOfFix();
    if (m_isPlaceShown) proposeAll();
    const auto attempt = [found = m_found, largestHole] {
        return std::make_shared<const Repaired>(found->surface, largestHole);
    };
    inBackground(this, attempt,
                 [this, found = m_found, largestHole](const std::shared_ptr<const Repaired>& repaired) {
                     if (m_found != found || m_panel.largestHole() != largestHole) return;
                     m_repaired = repaired;
                     tellOfRepair();
                 });
}

/// Returns the numbers of edges of the holes: open edges that hang together.
std::vector<int> SurfaceCheck::holesIn(const SurfaceProblems& problems) {
    std::map<int, int> places;  // of vertices
    for (const auto& edge : problems.openEdges)
        for (const int v : edge) places.try_emplace(v, static_cast<int>(places.size()));
    DisjointSets sets(static_cast<int>(places.size()));
    for (const auto& edge : problems.openEdges) sets.join(places[edge[0]], places[edge[1]]);
    std::map<int, int> counts;
    for (const auto& edge : problems.openEdges) ++counts[sets.root(places[edge[0]])];
    std::vector<int> edges;
    for (const auto& [set, count] : counts) edges.push_back(count);
    return edges;
}

void SurfaceCheck::tellOfRepair() {
    m_panel.tellOfHoles(m_session.document().domain().repair ? std::vector<int>()
                                                             : holesIn(m_repaired->left));
    const bool done = m_session.document().domain().repair;
    m_panel.tellOfRepair(!done && m_repaired->left.boundsVolume(), done ? QString() : repairText());
}

QString SurfaceCheck::repairText() const {
    const RepairReport& report = m_repaired->report;
    return wouldDo({{tr("merge points (%1)"), report.mergedVertices},
                    {tr("drop triangles (%1)"), report.droppedDegenerate + report.droppedDuplicate},
                    {tr("turn triangles (%1)"), report.flipped},
                    {tr("fill holes (%1)"), report.filledHoles}});
}

/// Describes the effect of those that change something; empty if none does.
QString SurfaceCheck::wouldDo(const std::vector<std::pair<QString, int>>& repairs) {
    QStringList parts;
    for (const auto& [text, count] : repairs)
        if (count > 0) parts << text.arg(QLocale().toString(count));
    return parts.isEmpty() ? QString() : tr("It would %1.").arg(parts.join(QStringLiteral(", ")));
}

}  // namespace wend
