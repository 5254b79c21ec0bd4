#pragma once

#include <QWidget>
#include <memory>

#include "app/base/latest.h"
#include "app/session/shape_motion.h"

class QLabel;
class QPushButton;

namespace wend {

/// Facts about a solid: size, area, volume and edges of the file's surface, the cell quality, and the gaps
/// that a cage closes; with buttons for the worst cell, the next gap, and a cage that opens the gaps. The
/// file is read in a background thread while the panel is visible.
class FactsPanel : public QWidget {
    Q_OBJECT

  public:
    FactsPanel(Document& document, ShapeMotion& motion, QWidget* parent = nullptr);

  signals:
    /// Emitted to request a view of a tetrahedron.
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

    Document& m_document;
    ShapeMotion& m_motion;
    QLabel *m_surface, *m_mesh, *m_cage;
    QPushButton *m_worst, *m_gap, *m_open;
    QString m_path;                       // of the file that was looked at …
    int m_generation = -1;                // … in this document
    std::shared_ptr<const void> m_shape;  // that m_nextGap is of
    std::size_t m_nextGap = 0;
    Latest m_looking{this};
};

}  // namespace wend
