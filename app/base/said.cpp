#include "app/base/said.h"

#include <QCoreApplication>
#include <vector>

#include "core/base/printable.h"

namespace wend {

QString said(const Message& message) {
    if (message.sentence().empty()) return QString::fromStdString(message.text());
    std::vector<std::string> arguments;
    for (const Message& argument : message.arguments()) arguments.push_back(said(argument).toStdString());
    const QString sentence = QCoreApplication::translate("Core", message.sentence().c_str());
    return QString::fromStdString(filled(sentence.toStdString(), arguments));
}

QString said(const std::exception& error) {
    return said(messageOf(error));
}

}  // namespace wend
