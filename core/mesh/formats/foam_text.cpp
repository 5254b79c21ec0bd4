#include "core/mesh/formats/foam_text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

bool isFoamBlank(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

bool isFoamMark(char c) {
    return std::string_view("(){}[];").find(c) != std::string_view::npos;
}

double foamNumber(std::string_view word, bool& isNumber) {
    double value = 0;
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto done = std::from_chars(word.data(), word.data() + word.size(), value);
    isNumber = done.ec == std::errc() && done.ptr == word.data() + word.size();
    return value;
}

}  // namespace

FoamText::FoamText(std::string path, std::string bytes) : m_path(std::move(path)), m_bytes(std::move(bytes)) {
    readHeader();
}

void FoamText::fail(const std::string& what) const {
    if (m_binary) throw InputError(m_path, "byte " + std::to_string(m_at) + ": " + what);
    const auto end = m_bytes.begin() + static_cast<std::ptrdiff_t>(std::min(m_at, m_bytes.size()));
    throw InputError(m_path,
                     "line " + std::to_string(1 + std::count(m_bytes.begin(), end, '\n')) + ": " + what);
}

/// Passes blanks and comments.
void FoamText::skipBlanks() {
    while (m_at < m_bytes.size()) {
        if (isFoamBlank(m_bytes[m_at])) {
            ++m_at;
        } else if (m_bytes.compare(m_at, 2, "//") == 0) {
            m_at = std::min(m_bytes.find('\n', m_at), m_bytes.size());
        } else if (m_bytes.compare(m_at, 2, "/*") == 0) {
            const auto end = m_bytes.find("*/", m_at + 2);
            if (end == std::string::npos) fail("the comment has no end");
            m_at = end + 2;
        } else {
            return;
        }
    }
}

bool FoamText::atEnd() {
    skipBlanks();
    return m_at >= m_bytes.size();
}

std::string_view FoamText::word() {
    if (atEnd()) fail("the file ends too early");
    const std::size_t begin = m_at;
    if (isFoamMark(m_bytes[m_at])) return std::string_view(m_bytes).substr(m_at++, 1);
    if (m_bytes[m_at] == '"') {
        const auto end = m_bytes.find('"', m_at + 1);
        if (end == std::string::npos) fail("the text in quotes has no end");
        m_at = end + 1;
        return std::string_view(m_bytes).substr(begin + 1, end - begin - 1);
    }
    while (m_at < m_bytes.size() && !isFoamBlank(m_bytes[m_at]) && !isFoamMark(m_bytes[m_at])) ++m_at;
    return std::string_view(m_bytes).substr(begin, m_at - begin);
}

std::string_view FoamText::next() {
    const std::size_t before = m_at;
    const std::string_view found = word();
    m_at = before;
    return found;
}

void FoamText::expect(std::string_view what) {
    if (const std::string_view found = word(); found != what)
        fail("\"" + std::string(found.substr(0, 20)) + "\" stands where " + std::string(what) + " should");
}

long FoamText::number() {
    const std::string_view text = word();
    long value = 0;
    const auto done = std::from_chars(text.data(), text.data() + text.size(), value);
    if (done.ec != std::errc() || done.ptr != text.data() + text.size())
        fail("\"" + std::string(text.substr(0, 20)) + "\" is not a whole number");
    return value;
}

void FoamText::skipEntry() {
    for (int depth = 0;;) {
        const std::string_view found = word();
        if (found == "(" || found == "{" || found == "[") ++depth;
        if (found == ")" || found == "}" || found == "]") --depth;
        if (found == ";" && depth <= 0) return;
    }
}

/// Reads "FoamFile { format binary; arch "LSB;label=32;scalar=64"; … }".
void FoamText::readHeader() {
    if (atEnd() || next() != "FoamFile") return;
    word();
    expect("{");
    for (std::string key; (key = std::string(word())) != "}";) {
        if (key == "format") m_binary = next() == "binary";
        if (key == "arch") {
            const std::string_view arch = next();
            if (arch.find("label=64") != std::string_view::npos) m_labelSize = 8;
            if (arch.find("scalar=32") != std::string_view::npos) m_scalarSize = 4;
            if (arch.find("MSB") != std::string_view::npos) fail("the order of bytes (MSB) is not supported");
        }
        skipEntry();
    }
}

/// Returns the number of entries of a list, which cannot be more than bytes.
std::size_t FoamText::count() {
    const long entries = number();
    if (entries < 0 || static_cast<std::size_t>(entries) > m_bytes.size())
        fail("a list of " + std::to_string(entries) + " entries does not fit into the file");
    return static_cast<std::size_t>(entries);
}

/// Takes raw bytes between parentheses.
std::string_view FoamText::raw(std::size_t size) {
    expect("(");
    if (size > m_bytes.size() - m_at) fail("the file ends within a list");
    const std::string_view bytes = std::string_view(m_bytes).substr(m_at, size);
    m_at += size;
    expect(")");
    return bytes;
}

long FoamText::rawNumber(const char* bytes) const {
    if (m_labelSize == 8) {
        std::int64_t value = 0;
        std::memcpy(&value, bytes, sizeof value);
        return value;
    }
    std::int32_t value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

std::vector<long> FoamText::numbers() {
    const std::size_t entries = count();
    std::vector<long> list;
    list.reserve(entries);
    if (m_binary) {
        if (entries == 0 && next() != "(") return list;
        const std::string_view bytes = raw(entries * m_labelSize);
        for (std::size_t i = 0; i < entries; ++i) list.push_back(rawNumber(bytes.data() + i * m_labelSize));
        return list;
    }
    if (next() == "{") {  // all the same
        expect("{");
        list.assign(entries, number());
        expect("}");
        return list;
    }
    if (entries == 0 && (atEnd() || next() != "(")) return list;
    expect("(");
    for (std::size_t i = 0; i < entries; ++i) list.push_back(number());
    expect(")");
    return list;
}

/// Binary files have two lists: where each face begins, and the vertices of all.
std::vector<std::vector<long>> FoamText::faces() {
    std::vector<std::vector<long>> list;
    if (m_binary) {
        const std::vector<long> begins = numbers(), vertices = numbers();
        for (std::size_t f = 0; f + 1 < begins.size(); ++f) {
            if (begins[f] < 0 || begins[f] > begins[f + 1] || begins[f + 1] > std::ssize(vertices))
                fail("face " + std::to_string(f) + " ends before it begins, or after the last vertex");
            list.emplace_back(vertices.begin() + begins[f], vertices.begin() + begins[f + 1]);
        }
        return list;
    }
    const std::size_t entries = count();
    list.reserve(entries);
    expect("(");
    for (std::size_t f = 0; f < entries; ++f) list.push_back(numbers());
    expect(")");
    return list;
}

double FoamText::coordinate() {
    const std::string_view text = word();
    bool isNumber = false;
    const double value = foamNumber(text, isNumber);
    if (!isNumber) fail("\"" + std::string(text.substr(0, 20)) + "\" is not a number");
    return value;
}

Eigen::Matrix3Xd FoamText::points() {
    const std::size_t entries = count();
    Eigen::Matrix3Xd list(3, static_cast<Eigen::Index>(entries));
    if (m_binary) {
        const std::string_view bytes = raw(3 * entries * m_scalarSize);
        for (std::size_t i = 0; i < 3 * entries; ++i) {
            double value = 0;
            float single = 0;
            if (m_scalarSize == 8)
                std::memcpy(&value, bytes.data() + 8 * i, 8);
            else
                std::memcpy(&single, bytes.data() + 4 * i, 4), value = single;
            list.data()[i] = value;
        }
        return list;
    }
    expect("(");
    for (Eigen::Index v = 0; v < list.cols(); ++v) {
        expect("(");
        for (int k = 0; k < 3; ++k) list(k, v) = coordinate();
        expect(")");
    }
    expect(")");
    return list;
}

std::string FoamText::withPoints(const std::string& bytes, const Eigen::Matrix3Xd& all) {
    FoamText text("", bytes);
    const auto points = all.leftCols(std::min<Eigen::Index>(text.count(), all.cols()));
    text.expect("(");
    std::string out = bytes.substr(0, text.m_at);
    if (text.m_binary) {
        for (Eigen::Index i = 0; i < points.size(); ++i) {
            const double value = points.data()[i];
            const auto single = static_cast<float>(value);
            text.m_scalarSize == 8 ? out.append(reinterpret_cast<const char*>(&value), 8)
                                   : out.append(reinterpret_cast<const char*>(&single), 4);
        }
        return out + bytes.substr(text.m_at + static_cast<std::size_t>(points.size()) * text.m_scalarSize);
    }
    std::size_t done = text.m_at;
    TextWriter writer;
    for (Eigen::Index v = 0; v < points.cols(); ++v) {
        text.expect("(");
        for (int k = 0; k < 3; ++k) {
            const std::string_view old = text.word();
            const std::size_t begin = text.m_at - old.size();
            bool isNumber = false;
            writer << std::string_view(bytes).substr(done, begin - done);
            if (foamNumber(old, isNumber) == points(k, v))
                writer << old;
            else
                writer << points(k, v);
            done = text.m_at;
        }
        text.expect(")");
    }
    return out + writer.text() + bytes.substr(done);
}

}  // namespace wend::formats
