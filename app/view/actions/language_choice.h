#pragma once

#include <QMenu>
#include <QTranslator>
#include <memory>

#include "app/view/actions/action_maker.h"

namespace wend {

/// What the program says in the chosen language, as long as this lives: made before the window.
class SpokenLanguage {
  public:
    SpokenLanguage();
    ~SpokenLanguage();

  private:
    QTranslator m_ours, m_qts;
};

/// The language of the window: the desktop's, or one of those that it knows; remembered for other days.
class LanguageChoice : public ActionMaker {
    Q_OBJECT

  public:
    explicit LanguageChoice(QObject* parent);

    QMenu* menu() const { return m_menu.get(); }

  signals:
    /// Another language is chosen than the one that is spoken.
    void changed();

  private:
    void choose(const QString& code);

    std::unique_ptr<QMenu> m_menu;
    QString m_spoken;  // its code; empty: the desktop's
};

}  // namespace wend
