#pragma once

#include <QWidget>

#include "app/base/preferences.h"

class QToolButton;
class QVBoxLayout;

namespace wend {

/// A part of the side panel with a title that folds it; its state is stored.
class FoldingSection : public QWidget {
    Q_OBJECT

  public:
    /// `name`: of the setting that keeps whether it is open; closed at first.
    FoldingSection(const QString& title, const QString& help, const QString& name, QWidget* parent = nullptr);
    void add(QWidget* part);
    bool isOpen() const;
    void setOpen(bool open);

  private:
    QToolButton* m_title;
    QWidget* m_body;
    QVBoxLayout* m_parts;
    Preference<bool> m_isOpen;
};

}  // namespace wend
