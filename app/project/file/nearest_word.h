#pragma once

#include <string>
#include <vector>

namespace wend {

/// Returns the number of insertions, deletions, replacements and exchanges of neighbours that make one text
/// of the other (optimal string alignment).
int editDistance(const std::string& a, const std::string& b);

/// Returns the word that was probably meant by a misspelt one: the nearest by edit distance, capitals,
/// hyphens and underscores aside, if at most a third of its letters differ, or it begins with the text.
/// Empty: none is near.
std::string nearestWord(const std::string& text, const std::vector<std::string>& words);

/// Returns the key that was probably meant: the nearest word, else the one for which other programs use that
/// name. Empty: there is none.
std::string meantKey(const std::string& text, const std::vector<std::string>& keys);

}  // namespace wend
