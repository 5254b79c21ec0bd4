#pragma once

#include <QWidget>

#include "app/engine/motion/playback.h"
#include "app/panels/fields/jump_slider.h"
#include "app/project/edits/document.h"

class QPushButton;

namespace wend {

/// The strength of the memory: a slider from "not at all" to "fully", above it a picture of a strip whose pin
/// was moved in a circle.
class MemorySlider : public QWidget {
    Q_OBJECT

  public:
    explicit MemorySlider(QWidget* parent = nullptr);

    /// ρ, infinite at the slider's end; one beyond all other places shows as the last of them and is kept.
    double memory() const { return m_memory; }
    void setMemory(double memory);
    JumpSlider* slider() const { return m_slider; }
    QSize sizeHint() const override;

  signals:
    /// Emitted when the user chooses another memory; the number is the same for all values of one gesture.
    void memoryChosen(double memory, int gesture);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void choose(int value, int gesture);
    int lineHeight() const;

    JumpSlider* m_slider;
    double m_memory = 0;
};

/// How the shape follows its pins over time: the memory of the rest shape, and relaxation.
class FlowPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FlowPanel(Document& document, Playback& playback, QWidget* parent = nullptr);

  private:
    void showProject();

    Document& m_document;
    Playback& m_playback;
    MemorySlider* m_memory;
    QPushButton* m_settle;
};

}  // namespace wend
