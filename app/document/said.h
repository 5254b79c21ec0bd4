#pragma once

#include <QString>
#include <exception>

#include "core/mesh/message.h"

namespace wend {

/// Translates messages of core, pictures and files, and their arguments. A plain text is recognized by its
/// pattern. Untranslated messages, such as technical faults of files, stay English. Thread-safe.
QString said(const Message& message);
QString said(const std::exception& error);

}  // namespace wend
