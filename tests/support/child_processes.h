#pragma once

#include <sys/types.h>

#include <QDir>
#include <QFile>
#include <QTest>

namespace wend::test {

/// Returns the children of a process, as the system lists them.
inline QList<pid_t> childrenOf(qint64 parent) {
    QList<pid_t> children;
    for (const QString& name : QDir("/proc").entryList(QDir::Dirs)) {
        QFile file("/proc/" + name + "/stat");
        if (!name.at(0).isDigit() || !file.open(QIODevice::ReadOnly)) continue;
        const QByteArray stat = file.readAll();
        if (stat.mid(stat.lastIndexOf(')') + 4).split(' ').at(0).toLongLong() == parent)
            children << name.toInt();
    }
    return children;
}

/// Waits until the process has such a child; 0 if it never has.
inline pid_t childCalled(const QString& name, qint64 parent) {
    pid_t found = 0;
    const auto looksLikeIt = [&](pid_t child) {
        return QFile::symLinkTarget(QString("/proc/%1/exe").arg(child)).endsWith('/' + name);
    };
    const auto look = [&] {
        for (const pid_t child : childrenOf(parent))
            if (looksLikeIt(child)) found = child;
        return found > 0;
    };
    return QTest::qWaitFor(look, 60000) ? found : 0;
}

inline bool lives(pid_t process) {
    QFile file(QString("/proc/%1/stat").arg(process));
    return file.open(QIODevice::ReadOnly) && !file.readAll().contains(") Z ");
}

}  // namespace wend::test
