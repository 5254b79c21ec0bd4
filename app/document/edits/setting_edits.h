#pragma once

#include <string_view>

namespace wend {

class Document;

/// Another value of a setting, one undo step that is called as the table says, in the setting's range. Steps
/// of one gesture merge, and so do numbers of the same setting that follow each other.
void changeSetting(Document& document, std::string_view key, double value, int gesture = -1);

}  // namespace wend
