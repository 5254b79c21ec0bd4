#pragma once

#include <QWidget>

#include "app/panels/fields/setting_rows.h"
#include "app/project/edits/document.h"

namespace wend {

class JumpSlider;

/// The smoothing length as a logarithmic slider from near to far. Lengths beyond its ends are shown at the
/// ends and kept until it is moved.
class ReachRow : public QWidget {
    Q_OBJECT

  public:
    explicit ReachRow(Document& document, QWidget* parent = nullptr);

  private:
    void showProject();

    Document& m_document;
    JumpSlider* m_slider;
    int m_gesture = 0;
};

/// Exact numbers for the energy of the whole shape and the smoothing length.
class BalancePanel : public QWidget {
    Q_OBJECT

  public:
    explicit BalancePanel(Document& document, QWidget* parent = nullptr);

  private:
    void showProject();

    Document& m_document;
    SettingRows m_settings;
};

}  // namespace wend
