#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "core/base/number_text.h"

namespace wend::formats {

/// Builds a file's text, with numbers in the C locale and 17 significant digits.
class TextWriter {
  public:
    TextWriter& operator<<(std::string_view text) {
        m_text += text;
        return *this;
    }
    TextWriter& operator<<(const char* text) { return *this << std::string_view(text); }
    TextWriter& operator<<(char c) {
        m_text += c;
        return *this;
    }
    TextWriter& operator<<(double value) {
        appendNumber(m_text, value);
        return *this;
    }
    TextWriter& operator<<(std::integral auto value) {
        m_text += std::to_string(value);
        return *this;
    }
    std::string& text() { return m_text; }

  private:
    std::string m_text;
};

/// Returns a text as XML has it, in an attribute too.
inline std::string asXml(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&' || c == '<' || c == '>' || c == '"')
            result += "&#" + std::to_string(static_cast<int>(c)) + ";";
        else
            result += static_cast<unsigned char>(c) < ' ' ? '_' : c;
    }
    return result;
}

}  // namespace wend::formats
