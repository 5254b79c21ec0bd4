#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace wend::formats {

/// A file of OpenFOAM's mesh: a header, then a list whose numbers are text or, in binary files, raw. Every
/// failure is an InputError with the file and the line or byte.
class FoamText {
  public:
    /// Reads the header, if there is one.
    FoamText(std::string path, std::string bytes);

    bool isBinary() const { return m_binary; }
    std::size_t place() const { return m_at; }
    bool atEnd();
    /// Returns the next word or number; a character that stands for itself, such as "(", alone; or a text in
    /// quotes.
    std::string_view word();
    /// Returns the next word without taking it.
    std::string_view next();
    void expect(std::string_view what);
    long number();
    /// Reads a list of whole numbers, "2(0 1)".
    std::vector<long> numbers();
    /// Reads the lists of vertices of faces.
    std::vector<std::vector<long>> faces();
    /// Reads the points.
    Eigen::Matrix3Xd points();
    /// Takes everything up to the end of an entry of a dictionary, ";".
    void skipEntry();
    [[noreturn]] void fail(const std::string& what) const;

    /// Returns the bytes with other points; those that are the same keep their text.
    static std::string withPoints(const std::string& bytes, const Eigen::Matrix3Xd& points);

  private:
    void skipBlanks();
    void readHeader();
    std::size_t count();
    double coordinate();
    std::string_view raw(std::size_t size);
    long rawNumber(const char* bytes) const;

    std::string m_path, m_bytes;
    std::size_t m_at = 0;
    bool m_binary = false;
    std::size_t m_labelSize = 4, m_scalarSize = 8;
};

}  // namespace wend::formats
