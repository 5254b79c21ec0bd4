#pragma once

#include <QUndoCommand>
#include <memory>

#include "app/document/edits/document.h"

namespace wend {

/// One gesture: the project before and after it. Redo and undo set the value, so doing either twice changes
/// nothing. Commands of the same merge key that follow each other become one.
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
