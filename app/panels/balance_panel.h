#pragma once

#include <QWidget>

#include "app/panels/fields/setting_rows.h"
#include "app/session/shape_session.h"

namespace wend {

/// Exact numbers for the energy of the whole shape and the smoothing length.
class BalancePanel : public QWidget {
    Q_OBJECT

  public:
    explicit BalancePanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void showProject();

    ShapeSession& m_session;
    SettingRows m_settings;
};

}  // namespace wend
