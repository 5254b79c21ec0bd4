#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// A piece of a path: a move, a line, a cubic or the end of a closed curve. The last of the `points` that it
/// has is where it ends.
struct PathPiece {
    enum class Kind { Move, Line, Cubic, Close };
    Kind kind;
    std::array<Vec2, 3> points = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};

    int count() const { return kind == Kind::Cubic ? 3 : kind == Kind::Close ? 0 : 1; }
};
using SvgPath = std::vector<PathPiece>;

/// p ↦ A p + b.
struct Affine {
    Mat2 A = Mat2::Identity();
    Vec2 b = Vec2::Zero();

    Vec2 operator()(const Vec2& p) const { return A * p + b; }
    Affine operator*(const Affine& first) const { return {A * first.A, A * first.b + b}; }
    /// Returns the inverse; the map must have one.
    Affine inverse() const;
    bool isIdentity() const { return A == Mat2::Identity() && b == Vec2::Zero(); }
    /// Returns whether circles stay circles, within rounding.
    bool isSimilarity() const;
    /// Returns the factor by which lengths grow in the mean.
    double scale() const;
};

/// Reads the `d` of a path, up to the first fault, as SVG says. Curves become cubics: quadratic ones exactly,
/// arcs to a few millionths of their radius.
SvgPath pathOf(std::string_view d);

SvgPath rectanglePath(const Vec2& from, const Vec2& size, double rx, double ry);
SvgPath ellipsePath(const Vec2& centre, double rx, double ry);
/// Returns lines through the points of a `points` attribute.
SvgPath polygonPath(std::string_view points, bool isClosed);

SvgPath transformed(SvgPath path, const Affine& by);
bool isFinite(const SvgPath& path);

/// Returns the `d` of a path with that many decimals.
std::string pathText(const SvgPath& path, int decimals);
/// Returns a number with at most that many decimals.
std::string decimalText(double value, int decimals);
/// Reads a list of transforms. False for anything else.
bool readTransform(std::string_view text, Affine& transform);
/// Returns a `matrix()` with nine significant digits.
std::string transformText(const Affine& transform);

/// Reads numbers and flags that blanks and commas separate.
class NumberScanner {
  public:
    explicit NumberScanner(std::string_view text) : m_text(text) {}

    /// Reads the next number. False, and nothing is read, if there is none.
    bool number(double& value);
    bool flag(double& value);
    bool skip(char c);
    /// Returns the next letter, or 0 at the end and before other characters.
    char letter();
    std::string_view word();
    bool atEnd();

  private:
    void skipBlanks();

    std::string_view m_text;
};

}  // namespace wend
