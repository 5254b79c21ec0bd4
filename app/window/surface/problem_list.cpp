#include "app/window/surface/problem_list.h"

#include <QTextStream>

namespace wend {

namespace {

template <class List, class Text>
void writeList(QTextStream& out, const char* title, const List& list, const Text& text) {
    if (list.empty()) return;
    out << title << ' ' << list.size() << '\n';
    for (const auto& entry : list) out << text(entry) << '\n';
}

}  // namespace

QByteArray listOf(const SurfaceProblems& problems, const std::vector<int>& numbers) {
    QByteArray text;
    QTextStream out(&text);
    const auto one = [&](int t) { return QString::number(numbers[t]); };
    const auto pair = [](int a, int b) { return QStringLiteral("%1 %2").arg(a).arg(b); };
    const auto two = [&](const std::array<int, 2>& p) { return pair(numbers[p[0]], numbers[p[1]]); };
    const auto edge = [&](const std::array<int, 2>& p) { return pair(p[0], p[1]); };
    const auto vertex = [](int v) { return QString::number(v); };
    out << "# Numbers count from 0. Triangles unless edges (two vertices) are named.\n";
    writeList(out, "degenerate", problems.degenerate, one);
    writeList(out, "duplicate", problems.duplicate, one);
    writeList(out, "bad_index", problems.badIndex, one);
    writeList(out, "intersecting_pairs", problems.intersecting, two);
    writeList(out, "open_edges", problems.openEdges, edge);
    writeList(out, "non_manifold_edges", problems.nonManifoldEdges, edge);
    writeList(out, "misoriented_edges", problems.misoriented, edge);
    writeList(out, "vertices_not_finite", problems.notFinite, vertex);
    out.flush();
    return text;
}

}  // namespace wend
