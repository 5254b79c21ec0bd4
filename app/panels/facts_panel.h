#pragma once

#include <QWidget>
#include <memory>

#include "app/session/shape_session.h"

class QLabel;
class QPushButton;

namespace wend {

/// What an engineer asks of a solid: size, area, volume and edges of the surface as its file has it, how good
/// the cells are, and which gaps a cage closes; with ways to the worst cell, from gap to gap, and to a cage
/// that opens them. The file is looked at while the panel is seen, in a thread of its own.
class FactsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FactsPanel(ShapeSession& session, QWidget* parent = nullptr);

  signals:
    /// A tetrahedron is to be seen.
    void cellWanted(int cell);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void arrange();
    void refresh();
    void lookAtFile();
    void showMesh(const Shape<3>& shape);
    void showCage(const Shape<3>& shape);
    void goToGap();
    void openGap();

    ShapeSession& m_session;
    QLabel *m_surface, *m_mesh, *m_cage;
    QPushButton *m_worst, *m_gap, *m_open;
    QString m_path;                       // of the file that was looked at …
    int m_generation = -1;                // … in this document
    std::shared_ptr<const void> m_shape;  // that m_nextGap is of
    std::size_t m_nextGap = 0;
};

}  // namespace wend
