#pragma once

#include <QString>
#include <string>

namespace wend {

/// Translates messages of core, pictures and files, which are English and contain numbers, names and reasons.
/// A sentence is recognized by its pattern, and its arguments are translated recursively. Untranslated
/// messages, such as technical faults of files, stay English. Thread-safe.
QString said(const std::string& message);
QString said(const std::exception& error);

}  // namespace wend
