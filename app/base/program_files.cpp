#include "app/base/program_files.h"

#include <QCoreApplication>
#include <QDir>

namespace wend {

namespace {

QString programFolder(const char* installed, const char* inSources) {
    const QString beside = QCoreApplication::applicationDirPath() + QStringLiteral("/../share/wend/");
    for (const QString& folder :
         {beside + QLatin1String(installed), QStringLiteral(WEND_SOURCES "/") + QLatin1String(inSources)})
        if (QDir(folder).exists()) return QDir(folder).canonicalPath();
    return {};
}

}  // namespace

QString sampleFolder() {
    return programFolder("samples", "resources/samples");
}

QString manualFolder() {
    return programFolder("manual", "docs");
}

}  // namespace wend
