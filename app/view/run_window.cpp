#include "app/view/run_window.h"

#include <QApplication>
#include <QProcess>
#include <QStyleFactory>
#include <clocale>
#include <optional>

#include "app/view/file_workflow.h"
#include "app/view/language_choice.h"
#include "app/view/main_window.h"

namespace wend {

namespace {

/// Until it is closed. Then, if it is to be opened again, the arguments for that.
std::optional<QStringList> showWindow(const QString& file) {
    MainWindow window;
    window.show();
    window.files().guardWork(Recovery::standardFolder());
    if (!file.isEmpty()) {
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
    const SpokenLanguage language;
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/wend/icons/wend.svg")));
    const std::optional<QStringList> again = showWindow(QApplication::arguments().value(1));
    if (again) QProcess::startDetached(QApplication::applicationFilePath(), *again);
    return 0;
}

}  // namespace wend
