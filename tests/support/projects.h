#pragma once

#include <QString>
#include <memory>
#include <string>

#include "app/project/project_fwd.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

class Document;

namespace test {

// Common operations of tests on a whole project, out of line, so that few tests are rebuilt when its contents
// change.

/// Returns a project of that picture, cut out, or of that surface, with a coarse mesh, for speed.
std::shared_ptr<Project> barProject(const QString& picture, int vertices = 400);
std::shared_ptr<Project> solidProject(const QString& surface, int vertices);

/// A handle of one point of the rest shape that holds at the end.
template <int Dim = 2>
Project withPin(const Project& project, const Vec<Dim>& rest, const std::string& name);

// Each makes one step of the document.
void setVertices(Document& document, int vertices);
void setLength(Document& document, double length);
template <int Dim = 2>
void addPin(Document& document, const Vec<Dim>& rest, const std::string& name);

}  // namespace test
}  // namespace wend
