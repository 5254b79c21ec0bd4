#include "tests/support/projects.h"

#include "app/project/edits/document.h"
#include "app/project/edits/film_time.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/project.h"

namespace wend::test {

std::shared_ptr<Project> barProject(const QString& picture, int vertices) {
    auto project = newProject();
    project->domain.kind = DomainKind::Image;
    project->domain.path = picture.toStdString();
    project->domain.outline = OutlineKind::Alpha;
    project->domain.vertices = vertices;
    return project;
}

std::shared_ptr<Project> solidProject(const QString& surface, int vertices) {
    auto project = newProject();
    project->domain.kind = DomainKind::Surface;
    project->domain.path = surface.toStdString();
    project->domain.vertices = vertices;
    project->design.dimension = 3;
    return project;
}

void setVertices(Document& document, int vertices) {
    Domain domain = document.domain();
    domain.vertices = vertices;
    document.changeDomain(QStringLiteral("Vertices"), domain);
}

void setLength(Document& document, double length) {
    document.change(QStringLiteral("Length"), withLength(*document.project(), length));
}

template <int Dim>
Project withPin(const Project& project, const Vec<Dim>& rest, const std::string& name) {
    Project next = project;
    next.design = withHandle(designOf(project), std::vector<Vec3>{inSpace(rest)}, name, motionEnd(project));
    return next;
}

template <int Dim>
void addPin(Document& document, const Vec<Dim>& rest, const std::string& name) {
    document.change(QStringLiteral("Pin"), withPin<Dim>(*document.project(), rest, name));
}

template Project withPin<2>(const Project&, const Vec2&, const std::string&);
template void addPin<2>(Document&, const Vec2&, const std::string&);
template void addPin<3>(Document&, const Vec3&, const std::string&);

}  // namespace wend::test
