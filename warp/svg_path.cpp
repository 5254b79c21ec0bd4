#include "warp/svg_path.h"

#include <Eigen/LU>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

namespace wend {
namespace {

using Kind = PathPiece::Kind;

Vec2 onEllipse(const Vec2& centre, const Mat2& axes, double angle) {
    return centre + axes * Vec2(std::cos(angle), std::sin(angle));
}

/// Appends an arc centre + axes · (cos, sin), in pieces of at most an eighth of a turn: with handles of
/// 4/3 tan(θ/4) a cubic then keeps to the circle within 4 millionths of its radius.
void appendArc(SvgPath& path, const Vec2& centre, const Mat2& axes, double from, double sweep) {
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 4))));
    const double step = sweep / count, handle = 4.0 / 3 * std::tan(step / 4);
    for (int k = 0; k < count; ++k) {
        const double a = from + k * step, b = a + step;
        const auto tangent = [&](double angle) {
            return Vec2(axes * Vec2(-std::sin(angle), std::cos(angle)));
        };
        path.push_back({Kind::Cubic,
                        {onEllipse(centre, axes, a) + handle * tangent(a),
                         onEllipse(centre, axes, b) - handle * tangent(b), onEllipse(centre, axes, b)}});
    }
}

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The arc of an ellipse between two points (SVG 1.1, appendix F.6.5).
struct EndpointArc {
    double rx = 0, ry = 0, turn = 0;
    bool isLarge = false, isPositive = false;

    void append(SvgPath& path, const Vec2& from, const Vec2& to) const {
        if (from == to) return;
        if (rx == 0 || ry == 0) return path.push_back({Kind::Line, {to}});
        Mat2 rotation;
        rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
        Vec2 radii(std::abs(rx), std::abs(ry));
        const Vec2 half = (rotation.transpose() * (from - to) / 2).cwiseQuotient(radii);
        const double square = half.squaredNorm();
        if (square > 1) radii *= std::sqrt(square);  // too small ones grow until they reach
        const Vec2 start = square > 1 ? Vec2(half / std::sqrt(square)) : half;
        const double lift = std::sqrt(std::max(0.0, 1 / start.squaredNorm() - 1));
        const double side = isLarge == isPositive ? -1 : 1;
        const Vec2 centre = side * lift * Vec2(start.y(), -start.x());
        const Vec2 a = start - centre, b = -start - centre;
        double sweep = std::atan2(cross(a, b), a.dot(b));
        if (isPositive && sweep < 0) sweep += 2 * std::numbers::pi;
        if (!isPositive && sweep > 0) sweep -= 2 * std::numbers::pi;
        const Mat2 axes = rotation * radii.asDiagonal();
        const auto first = static_cast<std::ptrdiff_t>(path.size());
        appendArc(path, axes * centre + (from + to) / 2, axes, std::atan2(a.y(), a.x()), sweep);
        if (std::ssize(path) > first) path.back().points[2] = to;
    }
};

/// Reads the grammar of `d`.
class PathReader {
  public:
    explicit PathReader(std::string_view d) : m_scanner(d) {}

    SvgPath read() {
        char command = 0;
        while (!m_scanner.atEnd()) {
            if (const char next = m_scanner.letter())
                command = next;
            else if (command == 'M')
                command = 'L';
            else if (command == 'm')
                command = 'l';
            if (m_path.empty() && command != 'M' && command != 'm') break;
            const bool isClose = command == 'Z' || command == 'z';
            if (!(isClose ? close() : append(command))) break;
            if (isClose) command = 0;
        }
        return std::move(m_path);
    }

  private:
    bool close() {
        m_path.push_back({Kind::Close, {}});
        m_at = m_start;
        m_lastControl.reset();
        return true;
    }

    /// Reads the numbers of one command. False if they are not there.
    bool append(char command) {
        const bool isRelative = std::islower(static_cast<unsigned char>(command)) != 0;
        const Vec2 origin = isRelative ? m_at : Vec2(0, 0);
        switch (std::toupper(static_cast<unsigned char>(command))) {
            case 'M': {
                Vec2 to;
                if (!point(origin, to)) return false;
                m_start = to;
                return add(Kind::Move, {to});
            }
            case 'L': {
                Vec2 to;
                return point(origin, to) && add(Kind::Line, {to});
            }
            case 'H':
                return along(0, isRelative);
            case 'V':
                return along(1, isRelative);
            case 'C':
                return cubic(origin, false);
            case 'S':
                return cubic(origin, true);
            case 'Q':
                return quadratic(origin, false);
            case 'T':
                return quadratic(origin, true);
            case 'A':
                return arc(origin);
            default:
                return false;
        }
    }

    bool point(const Vec2& origin, Vec2& p) {
        if (!m_scanner.number(p.x()) || !m_scanner.number(p.y())) return false;
        p += origin;
        return true;
    }
    bool add(Kind kind, const std::array<Vec2, 3>& points) {
        // What follows a closed curve begins where that began.
        if (kind != Kind::Move && m_path.back().kind == Kind::Close) m_path.push_back({Kind::Move, {m_at}});
        m_path.push_back({kind, points});
        m_at = points[static_cast<std::size_t>(m_path.back().count() - 1)];
        m_lastControl.reset();
        return true;
    }
    bool along(int axis, bool isRelative) {
        double value = 0;
        if (!m_scanner.number(value)) return false;
        Vec2 to = m_at;
        to[axis] = isRelative ? to[axis] + value : value;
        return add(Kind::Line, {to});
    }
    Vec2 reflected(bool ofCubic) const {
        return m_lastControl && m_lastIsCubic == ofCubic ? Vec2(2 * m_at - *m_lastControl) : m_at;
    }
    bool cubic(const Vec2& origin, bool isSmooth) {
        Vec2 a = reflected(true), b, to;
        if (!isSmooth && !point(origin, a)) return false;
        if (!point(origin, b) || !point(origin, to)) return false;
        add(Kind::Cubic, {a, b, to});
        m_lastControl = b;
        m_lastIsCubic = true;
        return true;
    }
    bool quadratic(const Vec2& origin, bool isSmooth) {
        Vec2 control = reflected(false), to;
        if (!isSmooth && !point(origin, control)) return false;
        if (!point(origin, to)) return false;
        add(Kind::Cubic, {m_at + (control - m_at) * (2.0 / 3), to + (control - to) * (2.0 / 3), to});
        m_lastControl = control;
        m_lastIsCubic = false;
        return true;
    }
    bool arc(const Vec2& origin) {
        EndpointArc arc;
        double degrees = 0, large = 0, positive = 0;
        Vec2 to;
        if (!m_scanner.number(arc.rx) || !m_scanner.number(arc.ry) || !m_scanner.number(degrees) ||
            !m_scanner.flag(large) || !m_scanner.flag(positive) || !point(origin, to))
            return false;
        arc.turn = degrees * std::numbers::pi / 180;
        arc.isLarge = large != 0, arc.isPositive = positive != 0;
        if (m_path.back().kind == Kind::Close) m_path.push_back({Kind::Move, {m_at}});
        arc.append(m_path, m_at, to);
        m_at = to;
        m_lastControl.reset();
        return true;
    }

    NumberScanner m_scanner;
    SvgPath m_path;
    Vec2 m_at = Vec2::Zero(), m_start = Vec2::Zero();
    std::optional<Vec2> m_lastControl;
    bool m_lastIsCubic = false;
};

}  // namespace

// --- Maps ---

Affine Affine::inverse() const {
    const Mat2 back = A.inverse();
    return {back, -(back * b)};
}

bool Affine::isSimilarity() const {
    const Mat2 square = A.transpose() * A;
    const double size = square.trace() / 2;
    return std::abs(square(0, 0) - square(1, 1)) <= 1e-6 * size && std::abs(square(0, 1)) <= 1e-6 * size;
}

double Affine::scale() const {
    return std::sqrt(std::abs(A.determinant()));
}

// --- Shapes ---

SvgPath pathOf(std::string_view d) {
    return PathReader(d).read();
}

SvgPath rectanglePath(const Vec2& from, const Vec2& size, double rx, double ry) {
    const Vec2 to = from + size;
    rx = std::min(rx, size.x() / 2), ry = std::min(ry, size.y() / 2);
    if (rx <= 0 || ry <= 0)
        return {{Kind::Move, {from}},
                {Kind::Line, {Vec2(to.x(), from.y())}},
                {Kind::Line, {to}},
                {Kind::Line, {Vec2(from.x(), to.y())}},
                {Kind::Close, {}}};
    constexpr double kQuarter = std::numbers::pi / 2;
    const Mat2 axes = Vec2(rx, ry).asDiagonal();
    SvgPath path{{Kind::Move, {Vec2(from.x() + rx, from.y())}}};
    const auto corner = [&](double x, double y, double angle) {
        const Vec2 centre(x, y);
        path.push_back({Kind::Line, {onEllipse(centre, axes, angle)}});
        appendArc(path, centre, axes, angle, kQuarter);
    };
    corner(to.x() - rx, from.y() + ry, -kQuarter);
    corner(to.x() - rx, to.y() - ry, 0);
    corner(from.x() + rx, to.y() - ry, kQuarter);
    corner(from.x() + rx, from.y() + ry, 2 * kQuarter);
    path.push_back({Kind::Close, {}});
    return path;
}

SvgPath ellipsePath(const Vec2& centre, double rx, double ry) {
    const Mat2 axes = Vec2(rx, ry).asDiagonal();
    SvgPath path{{Kind::Move, {Vec2(centre.x() + rx, centre.y())}}};
    appendArc(path, centre, axes, 0, 2 * std::numbers::pi);
    path.back().points[2] = path.front().points[0];
    path.push_back({Kind::Close, {}});
    return path;
}

SvgPath polygonPath(std::string_view points, bool isClosed) {
    NumberScanner scanner(points);
    SvgPath path;
    for (Vec2 p; scanner.number(p.x()) && scanner.number(p.y());)
        path.push_back({path.empty() ? Kind::Move : Kind::Line, {p}});
    if (isClosed && !path.empty()) path.push_back({Kind::Close, {}});
    return path;
}

SvgPath transformed(SvgPath path, const Affine& by) {
    for (PathPiece& piece : path)
        for (int k = 0; k < piece.count(); ++k)
            piece.points[static_cast<std::size_t>(k)] = by(piece.points[static_cast<std::size_t>(k)]);
    return path;
}

bool isFinite(const SvgPath& path) {
    constexpr double kFarthestPoint = 1e9;
    return std::ranges::all_of(path, [](const PathPiece& piece) {
        return std::all_of(piece.points.begin(), piece.points.begin() + piece.count(), [](const Vec2& p) {
            return p.allFinite() && p.cwiseAbs().maxCoeff() < kFarthestPoint;
        });
    });
}

}  // namespace wend
