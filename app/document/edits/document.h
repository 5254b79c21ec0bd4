#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/project_fwd.h"
#include "app/document/solid_view.h"

namespace wend {

struct Image;

/// What a file brings: a project, and the picture that it warps (null for a mesh without one).
struct OpenedFile {
    std::shared_ptr<const Project> project;
    std::shared_ptr<const Image> picture;
    QString path;    // of the project file; empty if a picture, a mesh or a sample was opened
    QString source;  // the file that was opened
    QStringList warnings;
    QString recoveredFrom;  // a copy of unsaved work: there are changes that `path` does not have
};

/// The project that is being worked on, as an immutable value that undo commands exchange.
class Document : public QObject {
    Q_OBJECT

  public:
    explicit Document(QObject* parent = nullptr);

    bool isEmpty() const { return !m_project; }
    const std::shared_ptr<const Project>& project() const { return m_project; }
    /// 2 or 3; 0 while empty.
    int dimension() const;
    /// The parts of the project: who needs one of them includes its header alone. There are none while empty.
    const Domain& domain() const;
    const AnyDesign& design() const;
    template <int Dim>
    const Design<Dim>& design() const;
    const DepthRegions& depth() const;
    double end() const;
    /// As solids are seen while empty, too.
    UpAxis up() const;
    const std::shared_ptr<const Image>& picture() const { return m_picture; }
    /// Counts the files that were opened: values of different generations have nothing in common.
    int generation() const { return m_generation; }
    /// The project file; empty if there is none yet.
    const QString& path() const { return m_path; }
    /// Where relative paths of the project start.
    QString folder() const;
    /// Of the project file, or until there is one, of the picture, mesh or sample that was opened.
    QString displayName() const;
    /// The file that was opened.
    const QString& source() const { return m_source; }
    QUndoStack* undoStack() { return &m_undo; }
    bool isModified() const { return !m_undo.isClean(); }
    /// From where a solid is seen, as the file has it or as it will be saved: kept with the project, but no
    /// change of it. None: as one that has just been opened.
    const std::optional<SavedCamera>& camera() const { return m_camera; }
    /// At viewWanted().
    void setCamera(const std::optional<SavedCamera>& camera) { m_camera = camera; }
    /// Asks the view where it looks from: true if the file has it otherwise.
    bool hasOtherView();

    /// Begins anew with what was read.
    void open(OpenedFile file);
    void close();
    /// Writes the project file; throws InputError, and the document stays modified.
    void save(const QString& path);

    /// One undo step. Steps with the same key that follow each other merge.
    void change(const QString& name, Project after, const QString& mergeKey = {});
    void change(const QString& name, std::shared_ptr<const Project> after, const QString& mergeKey = {});
    void changeDomain(const QString& name, Domain after, const QString& mergeKey = {});
    void changeDesign(const QString& name, AnyDesign after, const QString& mergeKey = {});
    void changeDepth(const QString& name, DepthRegions after, const QString& mergeKey = {});
    /// Back to what the project was.
    void changeBack(const QString& name, const std::shared_ptr<const Project>& before);
    /// All changes until the end are one step, with the name of the first …
    void beginStep();
    void endStep() { m_stepKey.clear(); }
    /// … unless it is dropped: then nothing of it has happened.
    void dropStep();
    /// True if a step with this key would merge with the last one.
    bool merges(const QString& mergeKey) const;

  signals:
    void opened();
    void projectChanged();
    void titleChanged();
    void saved();
    /// A view that keeps its camera with the project tells it now.
    void viewWanted();

  private:
    friend class ProjectCommand;
    /// A step that is undone is gone.
    bool isDropping() const { return m_drops; }
    void setProject(const std::shared_ptr<const Project>& project);

    std::shared_ptr<const Project> m_project;
    std::shared_ptr<const Image> m_picture;
    QString m_path, m_source;
    std::optional<SavedCamera> m_camera, m_cameraInFile;
    int m_generation = 0;
    QUndoStack m_undo;
    QString m_stepKey;  // of all changes, while a step goes on
    int m_steps = 0;
    bool m_drops = false;
};

}  // namespace wend
