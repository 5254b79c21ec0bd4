#pragma once

#include <QTimer>
#include <map>

#include "app/base/latest.h"
#include "app/project/options/option_values.h"
#include "app/window/export/export_preview.h"

class QComboBox;
class QFormLayout;
class QLabel;

namespace wend {

class OptionField;

/// The subject of an export, and what the screen already has of it.
struct ExportSubject {
    ExportKind kind = ExportKind::Picture;
    std::shared_ptr<const FrameExport> shape = {};
    QImage solidView = {};                              // preview of a solid; null for a picture
    std::shared_ptr<const ScreenPicture> picture = {};  // made on demand if null
    std::optional<PixelRect> part = {};                 // of the picture that was chosen to be kept
};

/// The choices of the last exports. All but the formats belong to a document.
struct ExportChoices {
    std::map<ExportKind, QString> formats = {};                         // by name
    std::map<std::string, std::pair<std::string, double>> values = {};  // of fields, by flag
    std::optional<PixelRect> part =
        {};                        // the crop that the canvas was last set to, or that was last declined
    bool wasTransparent = false;   // the background before a format that has no transparency
    double seconds = 0, rate = 0;  // duration and rate for which the number of frames was computed
};

/// The options of an export, as `wend run` has them, with a preview, the size in pixels, and a warning about
/// what would be cut off.
class ExportForm : public QWidget {
    Q_OBJECT

  public:
    /// Placement of the fields: beside the preview, or below it in a narrow column.
    enum class Fields { Beside, Below };
    /// Starts with the choices and keeps them current.
    ExportForm(Fields place, ExportChoices& choices, QWidget* parent = nullptr);

    /// Sets the subject and takes the choices that apply to it.
    void setSubject(const ExportSubject& subject);
    /// Sets the fields to the choices, or to their defaults.
    void takeChoices();
    /// Clears the subject and shows the reason.
    void setNothing(const QString& why);
    ExportKind kind() const { return m_subject.kind; }

    /// Returns the extension with its dot.
    QString extension() const;
    /// Returns the filter for a file dialog.
    QString filter() const;
    /// Returns whether one file holds all frames.
    bool isFilm() const;
    /// Returns the chosen values of the format's options.
    OptionValues values() const;
    /// Returns the field of an option; null if this kind of export does not have it.
    OptionField* field(const char* flag) const;
    /// Returns whether the current choice can be written.
    bool isReady() const;
    const ExportPreview& preview() const { return *m_preview; }

  signals:
    void readyChanged(bool ready);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    const FrameExport* shape() const { return m_subject.shape.get(); }
    void makeFields();
    void makeCropNote(Fields place);
    void addRow(OptionField& field, bool hasKey);
    void lay(Fields place);
    void showFormats();
    void showPart();
    void keepChoices();
    bool isPicture() const;
    bool takes(const std::string& flag) const;
    void adapt();
    bool shows(const std::string& flag) const;
    QString missingProgram() const;
    void tie(const OptionField& changed);
    void tieRate(const OptionField& changed);
    void tieWidth();
    void showWidth();
    void showFields();
    void showDepths();
    bool holdsTransparency() const;
    void showBackgrounds();
    void showCrop();
    QString pixels() const;
    void preparePicture();
    void askPreview();
    void startPreview();
    void tellProblem(const QString& problem);

    ExportSubject m_subject;
    ExportChoices& m_choices;
    std::optional<PixelRect> m_part;  // the crop that is offered as canvas
    ExportPreview* m_preview;
    QComboBox* m_format;
    QFormLayout* m_form;
    QList<OptionField*> m_fields;
    std::vector<std::pair<std::string, double>> m_defaults;  // of the fields, as value() and number()
    QLabel *m_facts, *m_cropText, *m_problem;
    QWidget* m_crop;
    QTimer m_previewTimer;
    Latest m_previews{this};
};

}  // namespace wend
