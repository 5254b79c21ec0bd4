#pragma once

#include <QWidget>

#include "app/project/project_fwd.h"

class QLabel;
class QToolButton;

namespace wend {

/// The detailed surface that is embedded in a solid, with buttons to choose and remove it.
class DetailRow : public QWidget {
    Q_OBJECT

  public:
    explicit DetailRow(QWidget* parent = nullptr);
    void showDomain(const Domain& domain);

  signals:
    void wanted();
    void removed();

  private:
    QLabel* m_name;
    QToolButton *m_choose, *m_remove;
};

}  // namespace wend
