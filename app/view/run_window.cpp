#include "app/view/run_window.h"

#include <QApplication>
#include <QStyleFactory>
#include <clocale>
#include <optional>

#include "app/view/actions/language_choice.h"
#include "app/view/files/file_workflow.h"
#include "app/view/main_window.h"

namespace wend {

namespace {

/// Until it is closed. Then, if another one is to take its place, what that takes over.
std::optional<WindowState> showWindow(const QString& file, const std::optional<WindowState>& before) {
    MainWindow window;
    window.files().guardWork(Recovery::standardFolder());
    if (before) window.takeOver(*before);
    window.show();
    if (!before && !file.isEmpty()) {
        window.files().tellLostWhenOpened();
        window.openPath(file);
    }
    QApplication::exec();
    return window.again();
}

}  // namespace

int runWindow(int argc, char** argv) {
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's, but files have points in every country
    QApplication::setOrganizationName(QStringLiteral("Wend"));
    QApplication::setApplicationName(QStringLiteral("Wend"));
    QApplication::setApplicationVersion(QStringLiteral(WEND_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("wend"));
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/wend/icons/wend.svg")));
    std::optional<WindowState> state;
    do {  // another language is spoken by another window
        const SpokenLanguage language;
        state = showWindow(QApplication::arguments().value(1), state);
    } while (state);
    return 0;
}

}  // namespace wend
