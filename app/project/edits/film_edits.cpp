#include "app/project/edits/film_edits.h"

#include <algorithm>

#include "app/project/edits/document.h"
#include "app/project/edits/film_time.h"
#include "app/project/edits/free_name.h"
#include "app/project/project.h"

namespace wend {

namespace {

/// Returns the project after an edit of its markers, which are brought into the order of time.
template <class Edit>
NextProject withMarkers(const Project& project, const Edit& edit) {
    auto next = copyOf(project);
    edit(next->markers);
    std::ranges::stable_sort(next->markers, {}, &TimeMarker::at);
    return next;
}

}  // namespace

FilmMarks filmMarksOf(const Document& document) {
    FilmMarks marks;
    if (document.isEmpty()) return marks;
    const Project& project = *document.project();
    marks = {project.frameRate, project.cycle, {}, project.audio};
    for (const TimeMarker& marker : project.markers) marks.markers.push_back({marker.at, marker.name});
    return marks;
}

NextProject withCycle(const Project& project, std::optional<double> from, std::optional<double> to) {
    auto next = copyOf(project);
    auto [start, end] = project.cycle.value_or(std::array{0.0, project.end});
    start = std::max(from.value_or(start), 0.0);
    end = to.value_or(end);
    if (start >= end && !to) end = project.end;
    if (start >= end && !from) start = 0;
    if (start < end) next->cycle = {start, end};
    return next;
}

NextProject withoutCycle(const Project& project) {
    auto next = copyOf(project);
    next->cycle.reset();
    return next;
}

NextProject withMarker(const Project& project, double at, const std::string& word) {
    const std::string name = freeName(namesOf(project.markers), word);
    return withMarkers(project, [&](auto& markers) { markers.push_back({at, name}); });
}

NextProject withMarkerMoved(const Project& project, int marker, double at) {
    return withMarkers(
        project, [=](auto& markers) { markers.at(static_cast<std::size_t>(marker)).at = std::max(at, 0.0); });
}

NextProject withMarkerNamed(const Project& project, int marker, const std::string& name) {
    return withMarkers(project,
                       [&](auto& markers) { markers.at(static_cast<std::size_t>(marker)).name = name; });
}

NextProject withoutMarker(const Project& project, int marker) {
    return withMarkers(project, [=](auto& markers) { markers.erase(markers.begin() + marker); });
}

void changeLength(Document& document, const QString& step, double length) {
    document.change(step, withLength(*document.project(), length), QStringLiteral("length"));
}

}  // namespace wend
