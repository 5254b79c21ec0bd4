#pragma once

#include <QObject>

class QWidget;

namespace wend {

/// How the fields of the panels take keys, all alike.
class PanelFields : public QObject {
    Q_OBJECT

  public:
    /// For all fields that are in `panels` by now.
    explicit PanelFields(QWidget& panels);
};

}  // namespace wend
