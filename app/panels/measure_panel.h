#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QLabel;

namespace wend {

/// How large a solid and the part of it that is selected are, and all values at the place that is pointed at.
class MeasurePanel : public QWidget {
    Q_OBJECT

  public:
    explicit MeasurePanel(ShapeSession& session, QWidget* parent = nullptr);

  public slots:
    /// What is under the pointer: a cell, its nearest corner, and the point; cell −1 if nothing is.
    void setPointed(int cell, int vertex, const wend::Vec<3>& point);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void refresh();
    void showSizes();
    void showPointed();

    ShapeSession& m_session;
    QLabel *m_whole, *m_part, *m_point, *m_cell;
    int m_pointedCell = -1, m_vertex = -1;
    Vec<3> m_at = Vec<3>::Zero();
};

}  // namespace wend
