#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/project/project_fwd.h"

class QString;

namespace wend {

class Document;

/// The times of a project that the ruler of the tracks shows.
struct FilmMarks {
    struct Marker {
        double at = 0;
        std::string name;
    };
    double frameRate = 24;
    std::optional<std::array<double, 2>> cycle;
    std::vector<Marker> markers;  // in the order of time
    std::string audio;            // a file; empty: none
};
/// Returns the marks of a document; the defaults while it is empty.
FilmMarks filmMarksOf(const Document& document);

/// Edits of the marks: pure functions to the next project.
using NextProject = std::shared_ptr<const Project>;
/// Marks the part of time that a loop shows; an end that is not given stays. Where the ends cross, the other
/// one gives way.
NextProject withCycle(const Project& project, std::optional<double> from, std::optional<double> to);
NextProject withoutCycle(const Project& project);
/// Adds a marker named `<word> 1`, `<word> 2` …
NextProject withMarker(const Project& project, double at, const std::string& word);
NextProject withMarkerMoved(const Project& project, int marker, double at);
NextProject withMarkerNamed(const Project& project, int marker, const std::string& name);
NextProject withoutMarker(const Project& project, int marker);

/// Gives the film another length, as a step of a document; see withLength().
void changeLength(Document& document, const QString& step, double length);

}  // namespace wend
