#pragma once

#include <string_view>

namespace wend {

class Document;

/// Returns a setting's value in the document, which is not empty; that of a choice is its place in the list.
double settingOf(const Document& document, std::string_view key);

/// Changes a setting, clamped to its range, in an undo step named in the table. Steps of one gesture merge,
/// and so do consecutive numbers of the same setting.
void changeSetting(Document& document, std::string_view key, double value, int gesture = -1);

/// Does the same for a setting of the outline, or the number of vertices, of one part of the picture.
void changePartSetting(Document& document, int part, std::string_view key, double value, int gesture = -1);

}  // namespace wend
