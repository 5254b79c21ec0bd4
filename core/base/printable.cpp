#include "core/base/printable.h"

#include <array>
#include <cstdio>

namespace wend {
namespace {

struct Character {
    char32_t code = 0;
    std::size_t length = 0;  // in bytes; 0 if they are no UTF-8
};

/// Decodes the first character of UTF-8 text; its length is 0 if the bytes are invalid.
Character firstOf(std::string_view text) {
    constexpr std::array<char32_t, 5> minimum{0, 0, 0x80, 0x800,
                                              0x10000};  // by length: no longer than needed
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x80) return {first, 1};
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 0;
    if (length == 0 || first > 0xf4 || text.size() < length) return {};
    char32_t code = first & (0x7fU >> length);
    for (const unsigned char byte : text.substr(1, length - 1)) {
        if ((byte & 0xc0U) != 0x80) return {};
        code = code << 6 | (byte & 0x3fU);
    }
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    if (code < minimum[length] || code > 0x10ffff || surrogate) return {};
    return {code, length};
}

bool isSafe(char32_t code) {
    if (code < ' ' || (code >= 0x7f && code < 0xa0)) return false;
    const bool turns = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) ||
                       code == 0x200e || code == 0x200f;
    return !turns && code != 0x2028 && code != 0x2029 && code != 0xfeff;
}

std::string asCode(const char* format, unsigned value) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace

std::string printable(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const Character one = firstOf(text);
        const std::size_t length = one.length == 0 ? 1 : one.length;
        if (one.length > 0 && isSafe(one.code))
            shown += text.substr(0, length);
        else if (text[0] == '\n' || text[0] == '\r')
            shown += ' ';
        else if (one.code < 0x80)
            shown += asCode("\\x%02x", static_cast<unsigned char>(text[0]));
        else
            shown += asCode("\\u{%x}", one.code);
        text.remove_prefix(length);
    }
    return shown;
}

Message printableMessage(const Message& message) {
    return withTexts(message, [](const std::string& text) { return printable(text); });
}

Message messageOf(const std::exception& error) {
    const auto* input = dynamic_cast<const InputError*>(&error);
    if (!input) return printable(error.what());
    const Message reason = printableMessage(input->message());
    return input->file().empty() ? reason : printable(input->file()) + ": " + reason;
}

}  // namespace wend
