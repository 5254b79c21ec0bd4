#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QPushButton;

namespace wend {

class MemorySlider;

/// How the shape follows its pins over time: the memory of the rest shape, and relaxation.
class FlowPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FlowPanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void showProject();

    ShapeSession& m_session;
    MemorySlider* m_memory;
    QPushButton* m_settle;
};

}  // namespace wend
