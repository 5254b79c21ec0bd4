#pragma once

#include <QObject>

namespace wend {

/// Shows why a menu entry is disabled while the pointer rests on it, because status tips do not cover
/// disabled entries.
class MenuReasons : public QObject {
    Q_OBJECT

  public:
    /// Watches all menus.
    explicit MenuReasons(QObject* parent);

  private:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace wend
