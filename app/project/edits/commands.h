#pragma once

#include <QUndoCommand>
#include <memory>

#include "app/project/edits/document.h"

namespace wend {

/// An undo command with the project before and after a gesture. Undo and redo set the value, so repeating
/// either has no effect. Consecutive commands with the same merge key merge.
class ProjectCommand : public QUndoCommand {
  public:
    ProjectCommand(Document& document, const QString& name, std::shared_ptr<const Project> before,
                   std::shared_ptr<const Project> after, const QString& mergeKey);

    void undo() override;
    void redo() override;
    int id() const override;
    bool mergeWith(const QUndoCommand* next) override;
    const QString& mergeKey() const { return m_mergeKey; }

  private:
    Document& m_document;
    std::shared_ptr<const Project> m_before, m_after;
    QString m_mergeKey;
};

}  // namespace wend
