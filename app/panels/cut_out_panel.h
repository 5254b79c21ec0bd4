#pragma once

#include <QWidget>

#include "app/panels/fields/setting_rows.h"

namespace wend {

class Document;

/// Numbers of a cut-out's outline that are rarely needed.
class CutOutPanel : public QWidget {
    Q_OBJECT

  public:
    explicit CutOutPanel(Document& document, QWidget* parent = nullptr);
    /// Returns why the settings of a cut-out cannot be changed for other pictures.
    static QString notACutOut();

    /// Shows the settings of one part of the picture; −1: of all.
    void setPart(int part);

  private:
    SettingRows m_settings;
};

}  // namespace wend
