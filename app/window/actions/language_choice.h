#pragma once

#include <QMenu>
#include <QTranslator>
#include <memory>

#include "app/window/actions/action_maker.h"

namespace wend {

/// Installs the translators of the chosen language for its lifetime; made before the window.
class SpokenLanguage {
  public:
    SpokenLanguage();
    ~SpokenLanguage();

  private:
    QTranslator m_ours, m_qts;
};

/// The menu of languages: the desktop's, or one that Wend knows. The choice is stored and applies from the
/// next start on.
class LanguageChoice : public ActionMaker {
    Q_OBJECT

  public:
    explicit LanguageChoice(QObject* parent);

    QMenu* menu() const { return m_menu.get(); }

  signals:
    /// Emitted when the chosen language differs from the spoken one, with a message that says when it
    /// applies.
    void changed(const QString& message);

  private:
    void choose(const QString& code);

    std::unique_ptr<QMenu> m_menu;
    QString m_spoken;  // code of the language; empty: that of the desktop
};

}  // namespace wend
