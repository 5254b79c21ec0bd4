#pragma once

#include <QObject>

namespace wend {

/// While the pointer rests on an entry of a menu that cannot be chosen, why is told beside it; of those the
/// status line hears nothing.
class MenuReasons : public QObject {
    Q_OBJECT

  public:
    /// Of all menus.
    explicit MenuReasons(QObject* parent);

  private:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace wend
