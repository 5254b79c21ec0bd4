#pragma once

#include <QDialog>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/output/run.h"
#include "warp/film.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QImage;
class QLabel;
class QPushButton;
class QSpinBox;

namespace wend {

/// The choices for a picture of a view.
struct PictureChoice {
    QSize size;
    bool transparent = true;
    bool marks = false;   // pins, paths and axes
    bool legend = false;  // of the map, if one is shown
    bool lossy = false;   // of WebP
    int frames = 0;       // of a film; 0: a picture
    double framesPerSecond = 24;
    bool loop = false;                   // the end of the span has no frame
    std::optional<FrameSpan> span = {};  // of a film; without: the whole motion
    FilmSound sound = {};
};

/// The choices of the dialog for the last picture or film.
struct PictureSettings {
    QString format;                            // its name
    std::optional<PictureChoice> choice = {};  // without: only the format is known
    bool tied = true;                          // width and height
};

/// The motion that a film shows.
struct FilmSubject {
    std::shared_ptr<const Project> project;
    double end = 0;
    std::string folder;  // of the project's files
};

struct FilmFormatFacts;
class ExportPreview;
class OptionField;

/// Asks for the size and content of a picture of a view or of a film of its motion, with a small preview.
class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    using Draw = std::function<QImage(const PictureChoice&)>;

    /// Asks for a film with `film`, else for a picture.
    PictureDialog(const QSize& proposal, bool hasLegend, QWidget* parent, Draw draw = {},
                  std::optional<FilmSubject> film = {});
    PictureChoice choice() const;
    PictureSettings settings() const;
    /// Starts with the settings of an earlier dialog.
    void set(const PictureSettings& settings);
    /// Returns the extension with its dot.
    QString extension() const;
    /// Returns the filter for a file dialog.
    QString filter() const;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void addFormats();
    void describeControls();
    void lay();
    void connectControls();
    void tie(QSpinBox* changed);
    void check();
    void showTransparency(bool isHeld);
    void showPreview();
    QString pixels() const;
    const FilmFormatFacts* filmFormat() const;
    QString problem() const;

    QSize m_proportions;  // of the view
    QSpinBox *m_width, *m_height;
    QCheckBox* m_tied;  // width and height, as in the view
    QLabel* m_note;     // why it cannot be written
    QDialogButtonBox* m_buttons;
    QPushButton* m_write;
    ExportPreview* m_preview;
    QComboBox* m_format;
    QFormLayout* m_form;
    OptionField *m_rate, *m_loop, *m_quality;
    std::optional<FilmSubject> m_film;
    QLabel* m_facts;
    Draw m_draw;
    QTimer m_timer;
    QCheckBox *m_transparent, *m_marks, *m_legend;
    bool m_wantsTransparent = true;  // also while the format cannot hold it
};

}  // namespace wend
