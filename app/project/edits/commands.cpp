#include "app/project/edits/commands.h"

namespace wend {

ProjectCommand::ProjectCommand(Document& document, const QString& name, std::shared_ptr<const Project> before,
                               std::shared_ptr<const Project> after, const QString& mergeKey)
    : QUndoCommand(name),
      m_document(document),
      m_before(std::move(before)),
      m_after(std::move(after)),
      m_mergeKey(mergeKey) {}

void ProjectCommand::undo() {
    setObsolete(m_document.isDropping());
    m_document.setProject(m_before);
}

void ProjectCommand::redo() {
    m_document.setProject(m_after);
}

int ProjectCommand::id() const {
    return m_mergeKey.isEmpty() ? -1 : 1;
}

bool ProjectCommand::mergeWith(const QUndoCommand* next) {
    const auto* other = static_cast<const ProjectCommand*>(next);
    if (other->m_mergeKey != m_mergeKey) return false;
    m_after = other->m_after;
    return true;
}

}  // namespace wend
