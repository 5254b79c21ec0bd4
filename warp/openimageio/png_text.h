#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "warp/byte_numbers.h"
#include "warp/openimageio/checked_proxy.h"

namespace wend {

/// Returns the characters of UTF-8 text; nothing if the bytes are something else.
inline std::optional<std::u32string> charactersOf(std::string_view utf8) {
    std::u32string text;
    while (!utf8.empty()) {
        const auto first = static_cast<unsigned char>(utf8[0]);
        const std::size_t length = first < 0x80   ? 1
                                   : first < 0xc2 ? 0
                                   : first < 0xe0 ? 2
                                   : first < 0xf0 ? 3
                                                  : 4;
        if (length == 0 || first > 0xf4 || utf8.size() < length) return std::nullopt;
        char32_t code = length == 1 ? first : first & (0x7fU >> length);
        for (const unsigned char byte : utf8.substr(1, length - 1)) {
            if ((byte & 0xc0U) != 0x80) return std::nullopt;
            code = code << 6U | (byte & 0x3fU);
        }
        const bool isTooLong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
        if (isTooLong || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return std::nullopt;
        text += code;
        utf8.remove_prefix(length);
    }
    return text;
}

/// Returns the UTF-8 of Latin-1 text.
inline std::string utf8OfLatin1(std::string_view latin1) {
    std::string text;
    for (const unsigned char c : latin1) {
        if (c >= 0x80) text += static_cast<char>(0xc0U | c >> 6U);
        text += static_cast<char>(c < 0x80 ? c : 0x80U | (c & 0x3fU));
    }
    return text;
}

/// A PNG file whose texts arrive as UTF-8 in tEXt chunks, which are Latin-1 by the standard: OpenImageIO
/// writes no others. They become Latin-1, or iTXt chunks if they have further characters.
class PngTextProxy final : public CheckedProxy {
  public:
    using CheckedProxy::CheckedProxy;

    std::size_t write(const void* bytes, std::size_t size) override {
        if (m_hasPixels) return CheckedProxy::write(bytes, size);
        m_held.append(static_cast<const char*>(bytes), size);
        passOn();
        return size;
    }
    /// Returns whether any of the pixels have been written.
    bool hasPixels() const { return m_hasPixels; }

  private:
    static constexpr std::size_t kMark = 8, kHead = 8, kSum = 4;

    void passOn() {
        if (!m_isMarked) {
            if (m_held.size() < kMark) return;
            pass(kMark, m_held.substr(0, kMark));
            m_isMarked = true;
        }
        while (m_held.size() >= kHead) {
            const std::string name = m_held.substr(4, 4);
            const std::size_t length = bigEndian(m_held), size = kHead + length + kSum;
            m_hasPixels = name == "IDAT";
            if (m_hasPixels) return pass(m_held.size(), m_held);
            if (m_held.size() < size) return;
            pass(size, name == "tEXt" ? textChunk(m_held.substr(kHead, length)) : m_held.substr(0, size));
        }
    }
    /// Writes `bytes` in place of the first ones that are held.
    void pass(std::size_t held, const std::string& bytes) {
        CheckedProxy::write(bytes.data(), bytes.size());
        m_held.erase(0, held);
    }

    /// Returns the chunk of a keyword, 0, and text.
    static std::string textChunk(const std::string& data) {
        const std::size_t end = data.find('\0');
        const std::string text = end == std::string::npos ? std::string() : data.substr(end + 1);
        const auto characters = charactersOf(text);
        if (!characters) return chunk("tEXt" + data);
        std::string latin1;
        for (const char32_t c : *characters) {
            if (c > 0xff) return chunk("iTXt" + data.substr(0, end) + std::string(5, '\0') + text);
            latin1 += static_cast<char>(c);
        }
        return chunk("tEXt" + data.substr(0, end + 1) + latin1);
    }
    static std::string chunk(const std::string& named) {
        return number(named.size() - 4) + named + number(checksum(named));
    }
    static std::string number(std::size_t value) {
        std::string bytes;
        for (unsigned shift = 32; shift > 0; shift -= 8)
            bytes += static_cast<char>(value >> (shift - 8) & 0xffU);
        return bytes;
    }
    /// CRC-32 as PNG has it.
    static std::uint32_t checksum(std::string_view bytes) {
        std::uint32_t sum = 0xffffffff;
        for (const unsigned char byte : bytes) {
            sum ^= byte;
            for (int bit = 0; bit < 8; ++bit) sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
        }
        return ~sum;
    }

    std::string m_held;  // of a chunk that is not complete
    bool m_isMarked = false, m_hasPixels = false;
};

}  // namespace wend
