#pragma once

#include <QList>
#include <QWidget>
#include <functional>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace wend {

/// Shows a line above the canvas that says what went wrong and what to do, or what is worth knowing. Each
/// line belongs to a topic and is valid until that is resolved, or until a click; the newest valid one is
/// shown.
class InfoBanner : public QWidget {
    Q_OBJECT

  public:
    /// The topic of a line, which determines when it disappears.
    enum class Topic {
        Opening,
        Saving,
        Copy,
        Disk,
        Picture,
        Export,
        Shape,
        Stop,
        Remark,
        Lost,
        Mesh,
        Border,
        SoftEdges,
        LineArt,
        Parts,
        Drawing,
        Riding,
        Spring
    };
    /// A button that puts it right.
    struct Remedy {
        QString text;
        std::function<void()> act;
    };

    explicit InfoBanner(QWidget* parent = nullptr);
    /// Shows the line of a topic, or removes it if the text is empty.
    void tell(Topic topic, const QString& text, const QList<Remedy>& remedies = {});
    void clear(Topic topic) { tell(topic, {}); }
    void clear();
    /// Returns the text that is shown; empty if there is none.
    QString text() const;

  private:
    struct Line {
        Topic topic;
        QString text;
        QList<Remedy> remedies;
    };
    void changeEvent(QEvent* event) override;
    void showNewest();
    void showSigns();

    QList<Line> m_lines;
    QLabel *m_sign, *m_text;
    QToolButton* m_close;
    QHBoxLayout* m_buttons;
};

}  // namespace wend
