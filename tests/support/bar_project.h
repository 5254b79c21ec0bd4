#pragma once

#include <QString>

#include "app/document/project.h"

namespace wend::test {

/// A project of that picture with a coarse mesh, for speed.
inline Project barProject(const QString& picture) {
    Project project;
    project.domain.kind = DomainKind::Image;
    project.domain.path = picture.toStdString();
    project.domain.outline = OutlineKind::Alpha;
    project.domain.vertices = 400;
    return project;
}

}  // namespace wend::test
