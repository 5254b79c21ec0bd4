#pragma once

#include <QAbstractButton>
#include <QImage>

namespace wend {

/// A sample project as a picture with its name; a click opens it. The picture is read in the background.
class SampleCard : public QAbstractButton {
    Q_OBJECT

  public:
    SampleCard(const QString& projectPath, QWidget* parent);
    QSize sizeHint() const override { return {136, 152}; }
    const QString& path() const { return m_path; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    void load();

    QString m_path;
    QImage m_picture;
};

}  // namespace wend
