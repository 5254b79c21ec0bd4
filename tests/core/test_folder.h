#pragma once

#include <QFile>
#include <QTemporaryDir>
#include <string>

namespace wend::samples {

/// A folder for a test's files, removed with it.
class Folder {
  public:
    std::string path(const std::string& name) const { return m_folder.filePath(name.c_str()).toStdString(); }
    std::string put(const std::string& name, const std::string& bytes) const {
        QFile file(path(name).c_str());
        if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write a test file");
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        return path(name);
    }
    std::string get(const std::string& name) const {
        QFile file(path(name).c_str());
        if (!file.open(QIODevice::ReadOnly)) qFatal("cannot read a test file");
        return file.readAll().toStdString();
    }

  private:
    QTemporaryDir m_folder;
};

}  // namespace wend::samples
