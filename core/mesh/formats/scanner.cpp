#include "core/mesh/formats/scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace wend::formats {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
bool isSpace(char c) {
    return c == '\n' || isBlank(c);
}
char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

Scanner::Scanner(std::string_view bytes, char comment) : m_bytes(bytes), m_comment(comment) {
    if (bytes.starts_with("\xef\xbb\xbf")) m_at = 3;  // a byte order mark
}

std::size_t Scanner::joint(std::size_t at) const {
    if (!m_joinsLines || m_bytes[at] != '\\') return 0;
    std::size_t end = at + 1;
    while (end < m_bytes.size() && isBlank(m_bytes[end])) ++end;
    return end < m_bytes.size() && m_bytes[end] == '\n' ? end + 1 - at : 0;
}

/// Returns the end of a line, which continues behind a backslash if lines are joined.
std::size_t Scanner::lineEnd(std::size_t at) const {
    std::size_t end = std::min(m_bytes.find('\n', at), m_bytes.size());
    if (!m_joinsLines) return end;
    for (;;) {
        std::size_t last = end;
        while (last > at && isBlank(m_bytes[last - 1])) --last;
        if (end == m_bytes.size() || last == at || m_bytes[last - 1] != '\\') return end;
        end = std::min(m_bytes.find('\n', end + 1), m_bytes.size());
    }
}

void Scanner::skipBlanks() {
    while (m_at < m_bytes.size() && (isBlank(m_bytes[m_at]) || joint(m_at) > 0))
        m_at += std::max<std::size_t>(1, joint(m_at));
    if (m_comment && m_at < m_bytes.size() && m_bytes[m_at] == m_comment) m_at = lineEnd(m_at);
}

bool Scanner::atLineEnd() {
    skipBlanks();
    return m_at == m_bytes.size() || m_bytes[m_at] == '\n';
}

bool Scanner::atEnd() {
    while (atLineEnd() && m_at < m_bytes.size()) ++m_at;
    return m_at == m_bytes.size();
}

void Scanner::requireEnd(const char* known) {
    if (atEnd()) return;
    m_taken = m_at;
    fail(std::string("there is more behind it than ") + known + " says");
}

bool Scanner::nextIs(std::string_view wanted) {
    const auto here = m_at;  // what looks like blanks may be binary numbers: nothing is passed
    const bool found = !atEnd() && m_bytes.substr(m_at).starts_with(wanted);
    const auto end = m_at + wanted.size();
    m_at = here;
    return found && (end == m_bytes.size() || isSpace(m_bytes[end]));
}

std::string_view Scanner::word(const char* what) {
    if (atEnd()) {
        m_taken = m_at;
        fail(std::string("the file ends where ") + what + " is expected");
    }
    m_taken = m_at;
    while (m_at < m_bytes.size() && !isSpace(m_bytes[m_at]) && !(m_comment && m_bytes[m_at] == m_comment) &&
           joint(m_at) == 0)
        ++m_at;
    return m_bytes.substr(m_taken, m_at - m_taken);
}

std::string_view Scanner::wordOnLine(const char* what) {
    if (atLineEnd()) {
        m_taken = m_at;
        fail(std::string("the line ends where ") + what + " is expected");
    }
    return word(what);
}

std::string_view Scanner::line() {
    m_taken = m_at;
    const auto end = lineEnd(m_at);
    auto text = m_bytes.substr(m_at, end - m_at);
    m_at = std::min(end + 1, m_bytes.size());
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view Scanner::raw(std::size_t size, const char* what) {
    m_taken = m_at;
    if (size > remaining()) {
        m_taken = m_bytes.size();
        fail(std::string("the file ends where ") + what + " is expected");
    }
    m_at += size;
    return m_bytes.substr(m_taken, size);
}

double Scanner::realFrom(std::string_view word, const char* what) const {
    const auto value = parseNumber(word);
    if (!value) fail(inQuotes(word) + " is not a number (" + what + " is expected)");
    return *value;
}

std::int64_t Scanner::integerFrom(std::string_view word, const char* what) const {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        fail(inQuotes(word) + " is not a whole number (" + what + " is expected)");
    return value;
}

double Scanner::real(const char* what) {
    return realFrom(word(what), what);
}
std::int64_t Scanner::integer(const char* what) {
    return integerFrom(word(what), what);
}

double Scanner::finite(const char* what) {
    const auto text = word(what);
    const double value = realFrom(text, what);
    if (!std::isfinite(value)) fail(inQuotes(text) + " is not a finite number (" + what + " is expected)");
    return value;
}

int Scanner::checkedCount(std::int64_t count, const char* things, std::size_t bytesEach) const {
    const auto number = std::to_string(count);
    if (count < 0) fail(number + " is no number of " + things);
    // the last number of a text may lack its separator
    const auto most = bytesEach ? (remaining() + 1) / bytesEach : std::numeric_limits<std::size_t>::max();
    if (count > std::numeric_limits<int>::max() || static_cast<std::size_t>(count) > most)
        fail("there should be " + number + " " + things + ", but the file is too short for so many");
    return static_cast<int>(count);
}

int Scanner::count(const char* things, std::size_t bytesEach) {
    const std::string what = std::string("the number of ") + things;
    return checkedCount(integer(what.c_str()), things, bytesEach);
}

void Scanner::seek(std::size_t offset) {
    m_taken = m_at = std::min(offset, m_bytes.size());
}

std::string Scanner::placeOf(std::size_t offset) const {
    if (m_byOffset) return "byte offset " + std::to_string(offset);
    // an error at the very end belongs to the last line that has something on it
    auto before = m_bytes.substr(0, offset);
    if (offset == m_bytes.size())
        while (!before.empty() && isSpace(before.back())) before.remove_suffix(1);
    return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
}

void Scanner::fail(const Message& what) const {
    throw InputError(place() + ": " + what);
}

double NumberReader::real(Scalar type, const char* what) {
    return m_binary ? decodeReal(m_scanner->raw(sizeOf(type), what), type, m_order) : m_scanner->real(what);
}

/// Reads a whole number of eight bytes, or a real one where a text has such.
template <class Whole>
SplitNumber NumberReader::splitReal(Scalar type, const char* what) {
    if (m_binary)
        return splitNumber(
            static_cast<Whole>(decodeInteger(m_scanner->raw(sizeOf(type), what), type, m_order)));
    const std::string_view word = m_scanner->word(what);
    Whole number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isWhole = error == std::errc() && end == word.data() + word.size();
    return isWhole ? splitNumber(number) : SplitNumber{m_scanner->realFrom(word, what), 0};
}

double NumberReader::real(Scalar type, const char* what, std::vector<std::int16_t>& beyond) {
    if (type != Scalar::Int64 && type != Scalar::UInt64) return real(type, what);
    const SplitNumber split =
        type == Scalar::UInt64 ? splitReal<std::uint64_t>(type, what) : splitReal<std::int64_t>(type, what);
    beyond.push_back(split.beyond);
    return split.value;
}

double NumberReader::finite(Scalar type, const char* what) {
    const double value = real(type, what);
    if (!std::isfinite(value)) m_scanner->fail(std::string("not a finite number (") + what + " is expected)");
    return value;
}

std::int64_t NumberReader::integer(Scalar type, const char* what) {
    return m_binary ? decodeInteger(m_scanner->raw(sizeOf(type), what), type, m_order)
                    : m_scanner->integer(what);
}

int NumberReader::checkedCount(std::int64_t count, const char* things, std::size_t numbersEach,
                               Scalar type) const {
    const std::size_t bytes = m_binary ? sizeOf(type) : 2;  // a digit and a blank
    return m_scanner->checkedCount(count, things, numbersEach * bytes);
}

int NumberReader::count(Scalar countType, const char* things, std::size_t numbersEach, Scalar type) {
    const std::string what = std::string("the number of ") + things;
    return checkedCount(integer(countType, what.c_str()), things, numbersEach, type);
}

std::string inQuotes(std::string_view word) {
    constexpr std::size_t longest = 30;
    std::string text = "'";
    for (char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > longest ? "…'" : "'");
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

bool sameWord(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace wend::formats
