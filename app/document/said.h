#pragma once

#include <QString>
#include <string>

namespace wend {

/// What the core, the pictures and the files say, in the window's language. They know no other than English
/// and put numbers, names and reasons into their sentences; here a sentence is known by its pattern, and what
/// was put in is looked at again. What nobody has translated, such as the technical faults of files, stays as
/// it is. From any thread.
QString said(const std::string& message);
QString said(const std::exception& error);

}  // namespace wend
