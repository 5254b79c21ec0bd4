#include "app/window/actions/language_choice.h"
#include "app/base/preferences.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace wend {

namespace {

struct Language {
    const char *code, *name;
};
constexpr Language kLanguages[] = {{"de", "Deutsch"},  {"en", "English"}, {"es", "Español"},
                                   {"fr", "Français"}, {"ja", "日本語"},  {"zh_CN", "简体中文"}};

/// Returns the code from the settings; empty for the desktop's language.
QString chosenCode() {
    const QString kept = preferences::language.value();
    for (const Language& one : kLanguages)
        if (kept == QLatin1String(one.code)) return kept;
    return {};
}

QLocale localeOf(const QString& code) {
    return code.isEmpty() ? QLocale::system() : QLocale(code);
}

/// Loads nothing where English is the first choice: the sources are English, so a second choice must not win.
bool loadWords(QTranslator& translator, const QLocale& locale, const QString& name, const QString& folder) {
    const QString first = locale.uiLanguages().value(0);
    return locale.language() != QLocale::C && !first.startsWith(QStringLiteral("en")) &&
           translator.load(locale, name, QStringLiteral("_"), folder);
}

bool loadOurs(QTranslator& translator, const QLocale& locale) {
    return loadWords(translator, locale, QStringLiteral("wend"), QStringLiteral(":/i18n"));
}

}  // namespace

/// Also sets the number format, unless the desktop uses the same language.
SpokenLanguage::SpokenLanguage() {
    const QLocale locale = localeOf(chosenCode());
    if (locale.language() != QLocale::system().language()) QLocale::setDefault(locale);
    if (loadOurs(m_ours, locale)) QCoreApplication::installTranslator(&m_ours);
    if (loadWords(m_qts, locale, QStringLiteral("qtbase"),
                  QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qts);
}

SpokenLanguage::~SpokenLanguage() {
    for (QTranslator* one : {&m_ours, &m_qts}) QCoreApplication::removeTranslator(one);
    QLocale::setDefault(QLocale::system());
}

LanguageChoice::LanguageChoice(QObject* parent)
    : ActionMaker(parent), m_menu(new QMenu), m_spoken(chosenCode()) {
    m_menu->setTitle(tr("&Language"));
    m_menu->menuAction()->setStatusTip(tr("The language of the window, from the next start of Wend"));
    QActionGroup* group = oneOf({});
    const auto offer = [&](const Words& words, const QString& code) {
        QAction* one = addToggle(
            QStringLiteral("language-%1").arg(code.isEmpty() ? QStringLiteral("desktop") : code), words, {});
        one->setData(code);
        one->setChecked(code == m_spoken);
        m_menu->addAction(group->addAction(one));
    };
    offer({tr("Like the &Desktop"), tr("Speak the desktop's language, if Wend knows it")}, {});
    for (const Language& one : kLanguages) {
        const QString name = QString::fromUtf8(one.name);
        offer({name, tr("Speak %1").arg(name)}, QLatin1String(one.code));
    }
    connect(group, &QActionGroup::triggered, this,
            [this](const QAction* chosen) { choose(chosen->data().toString()); });
}

void LanguageChoice::choose(const QString& code) {
    preferences::language.set(code);
    if (code != m_spoken) emit changed(tr("The language changes when Wend starts the next time."));
}

}  // namespace wend
