#pragma once

#include <QString>
#include <exception>

#include "core/base/message.h"

namespace wend {

/// Translates a message and its arguments. Plain texts, such as technical faults of files, stay English.
/// Thread-safe.
QString said(const Message& message);
QString said(const std::exception& error);

}  // namespace wend
