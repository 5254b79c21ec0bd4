#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/mesh/formats/scalar_type.h"

namespace wend::formats {

/// Reads a file's bytes as words, lines, numbers or raw bytes. Anything that does not fit throws InputError
/// that begins with the place: "line 17: …", or "byte offset 1234: …" once placesAreOffsets() was called.
/// `what` names what the caller expects, as in the error: "an x coordinate".
class Scanner {
  public:
    /// Skips everything from the comment character to the end of its line, unless the character is 0.
    explicit Scanner(std::string_view bytes, char comment = '\0');

    /// Returns whether nothing but blanks, line ends and comments is left.
    bool atEnd();
    /// Returns whether nothing but blanks and a comment is left on this line.
    bool atLineEnd();
    /// Fails if there is more; `known` names what determined where the end should be.
    void requireEnd(const char* known);
    /// Returns whether the next word, on any line, is this one; it is not taken.
    bool nextIs(std::string_view wanted);

    /// Returns the next word, on this or a later line.
    std::string_view word(const char* what);
    /// Returns the next word; fails if this line ends before it.
    std::string_view wordOnLine(const char* what);
    /// Returns the rest of this line without its end, and moves to the next line.
    std::string_view line();
    /// Returns the next bytes unchanged.
    std::string_view raw(std::size_t size, const char* what);

    /// Return a number on this or a later line; finite() refuses nan and inf.
    double real(const char* what);
    double finite(const char* what);
    std::int64_t integer(const char* what);
    /// Return the number that a word just taken represents.
    double realFrom(std::string_view word, const char* what) const;
    std::int64_t integerFrom(std::string_view word, const char* what) const;
    /// Returns a number of things, each of which takes at least `bytesEach` bytes of the rest of the file, so
    /// that the count of a damaged header is refused before anything is allocated.
    int count(const char* things, std::size_t bytesEach);
    int checkedCount(std::int64_t count, const char* things, std::size_t bytesEach) const;

    std::string_view bytes() const { return m_bytes; }
    std::size_t offset() const { return m_at; }
    std::size_t remaining() const { return m_bytes.size() - m_at; }
    /// Continues at an offset, which becomes the place of errors.
    void seek(std::size_t offset);
    /// Makes errors name this place from now on; reading continues where it was.
    void mark(std::size_t offset) { m_taken = offset; }
    /// Makes errors name byte offsets instead of lines.
    void placesAreOffsets() { m_byOffset = true; }
    /// Joins a line that ends in a backslash to the next one from now on.
    void joinLines() { m_joinsLines = true; }
    /// Returns the place, as it is in errors, of what begins at an offset.
    std::string placeOf(std::size_t offset) const;
    /// Throws InputError with the place of what was taken last.
    [[noreturn]] void fail(const Message& what) const;

  private:
    void skipBlanks();
    /// Returns the length of a backslash with the end of its line at an offset; 0 if there is none.
    std::size_t joint(std::size_t at) const;
    std::size_t lineEnd(std::size_t at) const;
    std::string place() const { return placeOf(m_taken); }

    std::string_view m_bytes;
    std::size_t m_at = 0;
    std::size_t m_taken = 0;  // where the last thing taken began
    char m_comment;
    bool m_byOffset = false, m_joinsLines = false;
};

/// Reads consecutive numbers as text or as bytes, for the formats that have both encodings.
class NumberReader {
  public:
    NumberReader(Scanner& scanner, bool binary, std::endian order)
        : m_scanner(&scanner), m_binary(binary), m_order(order) {}

    double real(Scalar type, const char* what);
    /// Reads a number of a field, and appends to `beyond` what it has beyond the double.
    double real(Scalar type, const char* what, std::vector<std::int16_t>& beyond);
    double finite(Scalar type, const char* what);
    std::int64_t integer(Scalar type, const char* what);
    /// Reads a count as Scanner::count does, for `numbersEach` numbers of `type` per thing.
    int count(Scalar countType, const char* things, std::size_t numbersEach, Scalar type);
    int checkedCount(std::int64_t count, const char* things, std::size_t numbersEach, Scalar type) const;

    bool binary() const { return m_binary; }
    std::endian order() const { return m_order; }
    Scanner& scanner() const { return *m_scanner; }

  private:
    template <class Whole>
    SplitNumber splitReal(Scalar type, const char* what);

    Scanner* m_scanner;
    bool m_binary;
    std::endian m_order;
};

/// Returns a word of a file as it may be in an error: short, in quotes and without control characters.
std::string inQuotes(std::string_view word);
/// Returns the text without blanks, tabs and carriage returns around it.
std::string_view trimmed(std::string_view text);
/// Returns whether two words are equal except for the case of ASCII letters.
bool sameWord(std::string_view a, std::string_view b);

}  // namespace wend::formats
