#pragma once

#include <QAction>
#include <QDialog>
#include <QList>
#include <QObject>
#include <functional>

#include "app/base/latest.h"
#include "app/project/edits/document.h"
#include "app/window/notices/info_banner.h"
#include "warp/vector_drawing.h"

class QDoubleSpinBox;
class QSpinBox;
class QWidget;

namespace wend {

struct Project;
class ProjectWatch;

/// Asks for a detailed surface that is to be embedded in the solid, and looks at it before the project gets
/// it.
class DetailChooser : public QObject {
    Q_OBJECT

  public:
    DetailChooser(Document& document, InfoBanner& banner, QWidget& window);
    void ask();
    void remove();

  signals:
    /// Emitted when the project has taken over the file.
    void chosen();

  private:
    void read(const QString& path);

    Document& m_document;
    InfoBanner& m_banner;
    QWidget& m_window;
    Latest m_reading{this};
};

/// Asks for another project and gives the document that project's motion, in one undo step.
class MotionChooser : public QObject {
    Q_OBJECT

  public:
    MotionChooser(Document& document, InfoBanner& banner, QWidget& window);

    void ask();
    /// Does so in the background, because both shapes are built. A document that changes meanwhile keeps its
    /// own motion.
    void apply(const QString& path);

  private:
    Document& m_document;
    InfoBanner& m_banner;
    QWidget& m_window;
    Latest m_applying{this};
};

/// Asks for the size at which a drawing is drawn, in pixels or in percent of that at which it is opened:
/// width, height and percent follow each other.
class DrawingSizeDialog : public QDialog {
    Q_OBJECT

  public:
    DrawingSizeDialog(const DrawnSize& now, const DrawnSize& first, QWidget* parent);

    DrawnSize size() const;

  private:
    void tie(QSpinBox* side, QSpinBox* other, double proportion);
    void takePercent(double percent);

    const DrawnSize m_first;
    QSpinBox *m_width, *m_height;
    QDoubleSpinBox* m_percent;
};

/// Follows the pictures of the document: notices when another program has changed one, and exchanges the
/// picture for another one of the same proportions, with the motion.
class PictureKeeper : public QObject {
    Q_OBJECT

  public:
    /// `fit`: shows the whole picture.
    PictureKeeper(Document& document, InfoBanner& banner, QAction& fit, QWidget& window);

    void askReplace();
    /// Does so in the background. Pins, paths and regions are scaled if the sizes differ.
    void replace(const QString& path);
    /// Asks for the width at which the document's drawing is drawn.
    void askSize();
    /// Draws the document's drawing in another size, in an undo step. Pins, paths and regions are scaled.
    void redraw(const DrawnSize& size);
    /// Reads the pictures of the document again, in an undo step.
    void reload();

  private:
    void follow();
    void tellChanged(ProjectWatch& watch, const QString& file);
    void exchange(const Project& next, const QString& name, bool mayDiffer);

    Document& m_document;
    InfoBanner& m_banner;
    QAction& m_fit;
    QWidget& m_window;
    QStringList m_files;           // that are watched
    QList<ProjectWatch*> m_watch;  // one for each
    Latest m_reading{this};
};

}  // namespace wend
