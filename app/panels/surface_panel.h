#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace wend {

/// Why a surface bounds no solid: what is wrong, and what can be done about it. Hidden while nothing is.
class SurfacePanel : public QWidget {
    Q_OBJECT

  public:
    explicit SurfacePanel(QWidget* parent = nullptr);
    void showProblems(const QStringList& problems, int triangles, bool mayRepair);

  signals:
    void showRequested();
    void saveRequested();
    void repairRequested();

  private:
    QLabel* m_text;
    QPushButton *m_show, *m_save, *m_repair;
};

}  // namespace wend
