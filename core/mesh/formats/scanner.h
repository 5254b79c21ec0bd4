#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/mesh/formats/scalar_type.h"

namespace wend::formats {

/// Walks through a file's bytes by words, lines, numbers or raw bytes. Everything that does not fit throws
/// InputError that begins with the place: "line 17: …", or "byte offset 1234: …" once placesAreOffsets() was
/// called. `what` is what the caller expects, as it stands in the error: "an x coordinate".
class Scanner {
  public:
    /// From the comment character to the end of the line is skipped, unless it is 0.
    explicit Scanner(std::string_view bytes, char comment = '\0');

    /// True if nothing but blanks, line ends and comments is left.
    bool atEnd();
    /// True if nothing but blanks and a comment is left on this line.
    bool atLineEnd();
    /// Fails if there is more; `known` is what told where the end should be.
    void requireEnd(const char* known);
    /// True if the next word, on any line, is this one; it is not taken.
    bool nextIs(std::string_view wanted);

    std::string_view word(const char* what);
    /// Fails if this line ends before it.
    std::string_view wordOnLine(const char* what);
    /// The rest of this line without its end, which is passed.
    std::string_view line();
    /// The next bytes as they are.
    std::string_view raw(std::size_t size, const char* what);

    /// A number on this or a later line; finite() refuses nan and inf.
    double real(const char* what);
    double finite(const char* what);
    std::int64_t integer(const char* what);
    /// The number that a word just taken stands for.
    double realFrom(std::string_view word, const char* what) const;
    std::int64_t integerFrom(std::string_view word, const char* what) const;
    /// A number of things of which each takes at least `bytesEach` bytes of the rest of the file: what a
    /// damaged header says is refused before anybody allocates it.
    int count(const char* things, std::size_t bytesEach);
    int checkedCount(std::int64_t count, const char* things, std::size_t bytesEach) const;

    std::string_view bytes() const { return m_bytes; }
    std::size_t offset() const { return m_at; }
    std::size_t remaining() const { return m_bytes.size() - m_at; }
    /// Continues there; it becomes the place of errors.
    void seek(std::size_t offset);
    /// Errors have this place from now on; reading goes on where it was.
    void mark(std::size_t offset) { m_taken = offset; }
    void placesAreOffsets() { m_byOffset = true; }
    /// A line that ends in a backslash goes on in the next: both are one from now on.
    void joinLines() { m_joinsLines = true; }
    /// The place of errors of what begins there.
    std::string placeOf(std::size_t offset) const;
    /// Throws with the place of what was taken last.
    [[noreturn]] void fail(const std::string& what) const;

  private:
    void skipBlanks();
    /// How long a backslash with the end of its line is here; 0 if there is none.
    std::size_t joint(std::size_t at) const;
    std::size_t lineEnd(std::size_t at) const;
    std::string place() const { return placeOf(m_taken); }

    std::string_view m_bytes;
    std::size_t m_at = 0;
    std::size_t m_taken = 0;  // where the last thing taken began
    char m_comment;
    bool m_byOffset = false, m_joinsLines = false;
};

/// Numbers that follow each other as text or as bytes: what the formats with both encodings have in common.
class NumberReader {
  public:
    NumberReader(Scanner& scanner, bool binary, std::endian order)
        : m_scanner(&scanner), m_binary(binary), m_order(order) {}

    double real(Scalar type, const char* what);
    double finite(Scalar type, const char* what);
    std::int64_t integer(Scalar type, const char* what);
    /// See Scanner::count; `numbersEach` numbers of `type` per thing.
    int count(Scalar countType, const char* things, std::size_t numbersEach, Scalar type);
    int checkedCount(std::int64_t count, const char* things, std::size_t numbersEach, Scalar type) const;

    bool binary() const { return m_binary; }
    std::endian order() const { return m_order; }
    Scanner& scanner() const { return *m_scanner; }

  private:
    Scanner* m_scanner;
    bool m_binary;
    std::endian m_order;
};

/// A word of a file as it may stand in an error: short, in quotes and without control characters.
std::string inQuotes(std::string_view word);
/// Returns the text without blanks, tabs and carriage returns around it.
std::string_view trimmed(std::string_view text);
/// Equal but for the case of ASCII letters.
bool sameWord(std::string_view a, std::string_view b);

}  // namespace wend::formats
