#include "app/project/edits/document.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <memory>

#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "warp/image.h"

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

Document::Document(QObject* parent) : QObject(parent) {
    connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

int Document::dimension() const {
    return m_project ? dimensionOf(*m_project) : 0;
}

const Domain& Document::domain() const {
    return m_project->domain;
}

const Design& Document::design() const {
    return m_project->design;
}

const ValueLayers& Document::depth() const {
    return m_project->depth;
}

double Document::end() const {
    return m_project->end;
}

UpAxis Document::up() const {
    return m_project ? m_project->view.up : SolidView().up;
}

QString Document::folder() const {
    return QFileInfo(m_path.isEmpty() ? m_source : m_path).absolutePath();
}

QString Document::displayName() const {
    return QFileInfo(m_path.isEmpty() ? m_source : m_path).fileName();
}

void Document::open(OpenedFile file) {
    m_undo.clear();
    endStep();
    m_project = std::move(file.project);
    m_picture = std::move(file.picture);
    m_pictures.clear();
    if (m_project) keepPicture(m_project->domain.path, m_project->domain.readings, m_picture);
    m_path = file.path;
    m_source = file.source;
    m_camera = m_cameraInFile = m_project ? m_project->view.camera : std::nullopt;
    ++m_generation;
    if (!file.recoveredFrom.isEmpty()) m_undo.resetClean();
    emit opened();
    emit projectChanged();
    emit titleChanged();
}

void Document::keepPicture(const std::string& file, int reading, std::shared_ptr<const Image> picture) {
    m_pictures[{file, reading}] = std::move(picture);
}

void Document::close() {
    open({});
}

void Document::save(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    emit viewWanted();
    Project project = *m_project;
    project.view.camera = m_camera;
    writeProject(absolute.toStdString(), project);
    m_cameraInFile = m_camera;
    m_path = absolute;
    m_undo.setClean();
    emit titleChanged();
    emit saved();
}

bool Document::hasOtherView() {
    emit viewWanted();
    return m_camera != m_cameraInFile;
}

void Document::change(const QString& name, Project after, const QString& mergeKey) {
    change(name, std::make_shared<const Project>(std::move(after)), mergeKey);
}

void Document::change(const QString& name, std::shared_ptr<const Project> after, const QString& mergeKey) {
    const QString& key = m_stepKey.isEmpty() ? mergeKey : m_stepKey;
    m_undo.push(new ProjectCommand(*this, name, m_project, std::move(after), key));
}

void Document::beginStep() {
    m_stepKey = QStringLiteral("step %1").arg(++m_steps);
}

void Document::dropStep() {
    m_drops = !m_stepKey.isEmpty() && merges(m_stepKey);
    endStep();
    if (m_drops) m_undo.undo();
    m_drops = false;
}

void Document::changeDomain(const QString& name, Domain after, const QString& mergeKey) {
    Project next = *m_project;
    next.domain = std::move(after);
    change(name, std::move(next), mergeKey);
}

void Document::changeDesign(const QString& name, Design after, const QString& mergeKey) {
    Project next = *m_project;
    next.design = std::move(after);
    change(name, std::move(next), mergeKey);
}

void Document::changeSizes(const QString& name, ValueLayers after, const QString& mergeKey) {
    if (after == m_project->domain.sizes) return;
    Project next = *m_project;
    next.domain.sizes = std::move(after);
    change(name, std::move(next), mergeKey);
}

void Document::changeDepth(const QString& name, ValueLayers after, const QString& mergeKey) {
    if (after == m_project->depth) return;
    Project next = *m_project;
    next.depth = std::move(after);
    change(name, std::move(next), mergeKey);
}

void Document::changeBack(const QString& name, const std::shared_ptr<const Project>& before) {
    m_undo.push(new ProjectCommand(*this, name, m_project, before, {}));
}

bool Document::merges(const QString& mergeKey) const {
    const int last = m_undo.index() - 1;
    if (last < 0 || m_undo.index() == m_undo.cleanIndex()) return false;
    return static_cast<const ProjectCommand*>(m_undo.command(last))->mergeKey() == mergeKey;
}

void Document::setProject(const std::shared_ptr<const Project>& project) {
    if (m_project == project) return;
    m_project = project;
    const auto known = m_pictures.find({project->domain.path, project->domain.readings});
    if (known != m_pictures.end()) m_picture = known->second;
    emit projectChanged();
}

}  // namespace wend
