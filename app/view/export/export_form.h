#pragma once

#include <QTimer>
#include <map>

#include "app/document/options/option_values.h"
#include "app/view/export/export_preview.h"

class QComboBox;
class QFormLayout;
class QLabel;

namespace wend {

class OptionField;

/// What is to be written, and what the screen has of it already.
struct ExportSubject {
    ExportKind kind = ExportKind::Picture;
    std::shared_ptr<const FrameExport> shape = {};
    QImage solidView = {};  // stands for a solid in the preview; null of a picture
    std::shared_ptr<const ScreenPicture> picture = {};  // made when it is needed if there is none
    std::optional<PixelRect> part = {};                 // of the picture that was chosen to be kept
};

/// How something is written: the options that `wend run` has for it, a preview of what comes out, its size in
/// pixels, and what would be cut off.
class ExportForm : public QWidget {
    Q_OBJECT

  public:
    /// Where the fields are: beside the preview, or below it in a narrow column.
    enum class Fields { Beside, Below };
    explicit ExportForm(Fields place, QWidget* parent = nullptr);
    ~ExportForm() override;

    /// What has been chosen stays chosen, as far as this can be written so.
    void setSubject(const ExportSubject& subject);
    /// There is nothing to be written, and why.
    void setNothing(const QString& why);
    ExportKind kind() const { return m_subject.kind; }

    /// Of the format, with its dot.
    QString extension() const;
    /// For a file dialog.
    QString filter() const;
    /// Whether one file holds all frames.
    bool isFilm() const;
    /// What was chosen, of the options that the format knows.
    OptionValues values() const;
    /// What a file would get as an option's control: null if this kind of export has none.
    OptionField* field(const char* flag) const;
    /// Whether it can be written as it is chosen.
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
    bool isPicture() const;
    bool takes(const std::string& flag) const;
    void adapt();
    void tieRate(const OptionField& changed);
    void showFields();
    void showDepths();
    void showCrop();
    QString pixels() const;
    void preparePicture();
    void askPreview();
    void startPreview();
    void tellProblem(const QString& problem);

    ExportSubject m_subject;
    std::map<ExportKind, QString> m_formats;  // chosen last, by name
    std::optional<PixelRect> m_part;          // that is offered as canvas
    double m_seconds = 0;                     // of the motion that number and rate of frames were told for
    ExportPreview* m_preview;
    QComboBox* m_format;
    QFormLayout* m_form;
    QList<OptionField*> m_fields;
    QLabel *m_facts, *m_cropText, *m_problem;
    QWidget* m_crop;
    QTimer m_previewTimer;
    std::stop_source m_previewStop;
};

}  // namespace wend
