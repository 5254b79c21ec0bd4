#include "app/window/run_window.h"

#include <QApplication>
#include <QStyleFactory>
#include <clocale>

#include "app/window/actions/language_choice.h"
#include "app/window/files/file_workflow.h"
#include "app/window/main_window.h"

namespace wend {

int runWindow(int argc, char** argv) {
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's, but files have points in every country
    QApplication::setOrganizationName(QStringLiteral("Wend"));
    QApplication::setApplicationName(QStringLiteral("Wend"));
    QApplication::setApplicationVersion(QStringLiteral(WEND_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("wend"));
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/wend/icons/wend.svg")));
    const SpokenLanguage language;
    MainWindow window;
    window.files().guardWork(Recovery::standardFolder());
    window.show();
    if (const QString file = QApplication::arguments().value(1); !file.isEmpty()) {
        window.files().tellLostWhenOpened();
        window.openPath(file);
    }
    return QApplication::exec();
}

}  // namespace wend
