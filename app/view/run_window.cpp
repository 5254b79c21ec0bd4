#include "app/view/run_window.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QStyleFactory>
#include <QTranslator>
#include <clocale>

#include "app/view/file_workflow.h"
#include "app/view/main_window.h"

namespace wend {

int runWindow(int argc, char** argv) {
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's, but files have points in every country
    QApplication::setOrganizationName(QStringLiteral("Wend"));
    QApplication::setApplicationName(QStringLiteral("Wend"));
    QApplication::setApplicationVersion(QStringLiteral(WEND_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("wend"));
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QTranslator ours, qts;
    if (ours.load(QLocale(), QStringLiteral("wend"), QStringLiteral("_"), QStringLiteral(":/i18n")))
        QApplication::installTranslator(&ours);
    if (qts.load(QLocale(), QStringLiteral("qtbase"), QStringLiteral("_"),
                 QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QApplication::installTranslator(&qts);
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/wend/icons/wend.svg")));
    MainWindow window;
    window.show();
    const QString file = QApplication::arguments().value(1);
    window.files().guardWork(Recovery::standardFolder());
    if (!file.isEmpty()) {
        window.files().tellLostWhenOpened();
        window.openPath(file);
    }
    return QApplication::exec();
}

}  // namespace wend
