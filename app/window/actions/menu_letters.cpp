#include "app/window/actions/menu_letters.h"

#include <QMenu>
#include <QRegularExpression>
#include <QSet>

#include "app/panels/fields/panel_parts.h"

namespace wend {

namespace {

/// Returns the mnemonic; null if there is none.
QChar letterOf(const QString& text) {
    static const QRegularExpression letter(QStringLiteral("&([^&\\s])"));
    const auto found = letter.match(QString(text).remove(QStringLiteral("&&")));
    return found.hasMatch() ? found.captured(1)[0].toUpper() : QChar();
}

/// Assigns a free letter; languages without an alphabet have one in brackets at the end.
QString withFreeLetter(const QString& text, const QSet<QChar>& taken) {
    static const QRegularExpression bracket(QStringLiteral("\\(&.\\)"));
    if (text.contains(bracket)) {
        for (char letter = 'A'; letter <= 'Z'; ++letter)
            if (!taken.contains(QLatin1Char(letter)))
                return QString(text).replace(bracket, QStringLiteral("(&%1)").arg(QLatin1Char(letter)));
        return QString(text).remove(bracket);
    }
    QString plain = withoutKey(text);
    for (qsizetype i = 0; i < plain.size(); ++i)
        if (plain[i].isLetter() && !taken.contains(plain[i].toUpper())) return plain.insert(i, u'&');
    return plain;
}

}  // namespace

void makeLettersUnique(QMenu& menu) {
    QSet<QChar> taken;
    QList<QAction*> others;
    for (QAction* action : menu.actions()) {
        if (action->menu()) makeLettersUnique(*action->menu());
        const QChar letter = letterOf(action->text());
        if (letter.isNull()) continue;
        if (taken.contains(letter))
            others << action;
        else
            taken << letter;
    }
    for (QAction* action : others) {
        action->setText(withFreeLetter(action->text(), taken));
        if (const QChar letter = letterOf(action->text()); !letter.isNull()) taken << letter;
    }
}

}  // namespace wend
