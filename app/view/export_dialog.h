#pragma once

#include <QDialog>
#include <QTimer>

#include "app/document/option_values.h"
#include "app/view/export_preview.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace wend {

class OptionField;

/// How something is written: the options that `wend run` has for it, a preview of what comes out, its size in
/// pixels and as a file, and what would be lost.
class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    /// `solidView`: what stands for a solid in the preview.
    ExportDialog(ExportKind kind, std::shared_ptr<const FrameExport> shape, const QImage& solidView,
                 QWidget* parent);
    ~ExportDialog() override;

    /// Of the format, with its dot.
    QString extension() const;
    /// For a file dialog.
    QString filter() const;
    /// What was chosen, of the options that the format knows.
    OptionValues values() const;
    /// What a file would get as an option's control: null if this kind of export has none.
    OptionField* field(const char* flag) const;

  signals:
    /// The size of the file is known, or why there will be none.
    void sizeTold();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void makeFormats();
    void makeFields();
    void lay();
    QWidget* makeCropNote();
    bool isPicture() const;
    bool takes(const std::string& flag) const;
    void adapt();
    void tieRate(const OptionField& changed);
    void showDepths();
    void showCrop();
    void showSize(const FileSize& size);
    QString pixels() const;
    void preparePicture();
    void askPreview();
    void startPreview();
    void startSize();
    void tellProblem(const QString& problem);

    ExportKind m_kind;
    std::shared_ptr<const FrameExport> m_shape;
    std::shared_ptr<const ScreenPicture> m_picture;
    ExportPreview* m_preview;
    QComboBox* m_format;
    QFormLayout* m_form = nullptr;
    QList<OptionField*> m_fields;
    QLabel *m_facts, *m_cropText, *m_problem;
    QWidget* m_crop;
    QPushButton* m_write;
    QTimer m_previewTimer, m_sizeTimer;
    std::stop_source m_previewStop, m_sizeStop;
    int m_asked = 0;  // the newest question for a size
};

}  // namespace wend
