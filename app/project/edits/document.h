#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/project/project_fwd.h"
#include "app/project/solid_view.h"

namespace wend {

struct Image;

/// The contents of a file: a project, and its picture (null for a mesh without one).
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
    /// Returns 2 or 3; 0 while empty.
    int dimension() const;
    /// Return the parts of the project. They require !isEmpty(); include only the header of the part that you
    /// use.
    const Domain& domain() const;
    const Design& design() const;
    const ValueLayers& depth() const;
    double end() const;
    /// Returns the up axis, or a default one while the document is empty.
    UpAxis up() const;
    const std::shared_ptr<const Image>& picture() const { return m_picture; }
    /// Keeps a picture for projects that name this file and this reading of it, so that undo finds it. Call
    /// this before the project changes to it.
    void keepPicture(const std::string& file, int reading, std::shared_ptr<const Image> picture);
    /// Counts the files that were opened: values of different generations have nothing in common.
    int generation() const { return m_generation; }
    /// Returns the path of the project file; empty if there is none yet.
    const QString& path() const { return m_path; }
    /// Returns the folder that relative paths of the project refer to.
    QString folder() const;
    /// Returns the name of the project file or, until there is one, of the opened picture, mesh or sample.
    QString displayName() const;
    /// Returns the file that was opened.
    const QString& source() const { return m_source; }
    QUndoStack* undoStack() { return &m_undo; }
    bool isModified() const { return !m_undo.isClean(); }
    /// Returns the camera of a solid as stored or to be stored. It is saved with the project without being a
    /// change of it. Nothing: the default view.
    const std::optional<SavedCamera>& camera() const { return m_camera; }
    /// Call this from slots of viewWanted().
    void setCamera(const std::optional<SavedCamera>& camera) { m_camera = camera; }
    /// Asks the view where it looks from: true if the file has it otherwise.
    bool hasOtherView();

    /// Replaces the document by the contents of a file.
    void open(OpenedFile file);
    void close();
    /// Writes the project file; throws InputError, and the document stays modified.
    void save(const QString& path);

    /// Changes the project in one undo step. Consecutive steps with the same key merge.
    void change(const QString& name, Project after, const QString& mergeKey = {});
    void change(const QString& name, std::shared_ptr<const Project> after, const QString& mergeKey = {});
    void changeDomain(const QString& name, Domain after, const QString& mergeKey = {});
    void changeDesign(const QString& name, Design after, const QString& mergeKey = {});
    void changeSizes(const QString& name, ValueLayers after, const QString& mergeKey = {});
    void changeDepth(const QString& name, ValueLayers after, const QString& mergeKey = {});
    /// Restores an earlier project in a new step.
    void changeBack(const QString& name, const std::shared_ptr<const Project>& before);
    /// Merges all changes until endStep() into one step with the name of the first.
    void beginStep();
    void endStep() { m_stepKey.clear(); }
    /// Undoes all changes since beginStep() and leaves no step.
    void dropStep();
    /// Returns whether a step with this key would merge with the last one.
    bool merges(const QString& mergeKey) const;
    /// Shows a line in the status bar: what could not be done, and where.
    void notify(const QString& text) { emit notice(text); }

  signals:
    /// Emitted with a line for the status bar.
    void notice(QString text);
    void opened();
    void projectChanged();
    void titleChanged();
    void saved();
    /// Asks views that store their camera with the project for it.
    void viewWanted();

  private:
    friend class ProjectCommand;
    /// Returns true while a dropped step is undone.
    bool isDropping() const { return m_drops; }
    void setProject(const std::shared_ptr<const Project>& project);

    std::shared_ptr<const Project> m_project;
    std::shared_ptr<const Image> m_picture;
    std::map<std::pair<std::string, int>, std::shared_ptr<const Image>> m_pictures;  // by file and reading
    QString m_path, m_source;
    std::optional<SavedCamera> m_camera, m_cameraInFile;
    int m_generation = 0;
    QUndoStack m_undo;
    QString m_stepKey;  // merge key of all changes during a step
    int m_steps = 0;
    bool m_drops = false;
};

}  // namespace wend
