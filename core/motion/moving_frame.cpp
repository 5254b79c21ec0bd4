#include "core/motion/moving_frame.h"

#include <algorithm>
#include <cmath>

namespace wend {

namespace {

using Shape = TangentPiece::Shape;

/// Moves the normal r at v of a piece to w by two reflections: in the bisecting plane of the two points, then
/// in that of the reflected and the new tangent (Wang, Jüttler, Zheng, Liu 2008, Table I). The error of one
/// step is O((w − v)⁵).
Vec3 doubleReflection(const TangentPiece& piece, double v, double w, const Vec3& r) {
    const Vec3 chord = piece.chord(v, w), before = piece.tangent(v), after = piece.tangent(w);
    const double squared = chord.squaredNorm();
    const Vec3 rLeft = r - 2 / squared * chord.dot(r) * chord;
    const Vec3 tLeft = before - 2 / squared * chord.dot(before) * chord;
    const Vec3 second = after - tLeft;
    return rLeft - 2 / second.squaredNorm() * second.dot(rLeft) * second;
}

Mat3 columns(const Vec3& tangent, const Vec3& normal) {
    Mat3 frame;
    frame << tangent, normal, tangent.cross(normal);
    return frame;
}

/// Returns the least rotation from one unit vector to another that is not its opposite; the axis is arbitrary
/// if they are equal.
Eigen::AngleAxisd minimalRotation(const Vec3& from, const Vec3& to) {
    const Vec3 cross = from.cross(to);
    const double sine = cross.norm();
    if (sine == 0) return {0, Vec3::UnitZ()};
    return {std::atan2(sine, from.dot(to)), cross / sine};
}

}  // namespace

MovingFrame::MovingFrame(const Curve<3>& curve, FrameKind kind) : m_kind(kind) {
    double size = 0;
    for (const auto& piece : curve.pieces) size += piece.coefficients.rightCols<3>().norm();
    for (const auto& piece : curve.pieces)
        m_pieces.push_back({TangentPiece(piece, size), piece.from, piece.to});
    for (Piece& piece : m_pieces) {
        if (usesTable(piece)) makeTable(piece);
    }
    joinPieces();
    setStart();
}

bool MovingFrame::usesTable(const Piece& piece) const {
    return m_kind == FrameKind::Minimal && piece.tangent.shape() == Shape::Spatial;
}

/// Tabulates the normal in steps whose halving changes it by less than 1e-14, so that the sum over a table
/// stays below 1e-11. The steps adapt to the torsion; the error of one is of fifth order.
void MovingFrame::makeTable(Piece& piece) const {
    const TangentPiece& tangent = piece.tangent;
    constexpr double kTolerance = 1e-14, kMinimum = 1.0 / (1 << 15);
    Node node{0, tangent.tangent(0).unitOrthogonal()};
    piece.table = {node};
    double step = 1.0 / 64;
    while (node.v < 1) {
        const double middle = node.v + step / 2, end = node.v + step;
        const Vec3 half = doubleReflection(tangent, node.v, middle, node.normal);
        const Vec3 full = doubleReflection(tangent, middle, end, half);
        const double error = (full - doubleReflection(tangent, node.v, end, node.normal)).norm();
        if (error > kTolerance && step > kMinimum) {
            step /= 2;
            continue;
        }
        piece.table.push_back({middle, half});
        piece.table.push_back(node = {end, full});
        // Steps are powers of two, and grow only if the doubled one still divides the part that is done, so
        // that they end at 1 exactly.
        if (error < kTolerance / 64 && std::fmod(end, 2 * step) == 0 && step < 1.0 / 16) step *= 2;
    }
}

/// Returns the frame of the piece itself; only its change along the piece has a meaning.
Mat3 MovingFrame::localFrame(const Piece& piece, double v) const {
    const Vec3 tangent = piece.tangent.tangent(v);
    if (!usesTable(piece)) return columns(tangent, piece.tangent.binormal(v).cross(tangent));
    const auto after = std::upper_bound(piece.table.begin(), piece.table.end(), v,
                                        [](double value, const Node& node) { return value < node.v; });
    const Node& node = *(after == piece.table.begin() ? after : after - 1);
    return columns(tangent,
                   v == node.v ? node.normal : doubleReflection(piece.tangent, node.v, v, node.normal));
}

Mat3 MovingFrame::turnedWithin(const Piece& piece, double v) const {
    const Shape shape = piece.tangent.shape();
    if (shape == Shape::Still || shape == Shape::Straight) return Mat3::Identity();
    return localFrame(piece, v) * localFrame(piece, 0).transpose();
}

/// Returns ω per unit of v.
Vec3 MovingFrame::localOmega(const Piece& piece, double v) const {
    const TangentPiece& tangent = piece.tangent;
    if (tangent.shape() == Shape::Still || tangent.shape() == Shape::Straight) return Vec3::Zero();
    Vec3 omega = tangent.tangent(v).cross(tangent.tangentRate(v));
    if (m_kind == FrameKind::Frenet && tangent.shape() == Shape::Spatial) {
        omega += tangent.torsionRate(v) * tangent.tangent(v);
    }
    return omega;
}

/// Carries the rotation from piece to piece, and joins consecutive pieces that move at their corner.
void MovingFrame::joinPieces() {
    double sign = 1;  // of the direction of travel relative to the carried tangent
    Vec3 before = Vec3::Zero();
    for (size_t i = 0; i < m_pieces.size(); ++i) {
        Piece& piece = m_pieces[i];
        if (i > 0) {
            const Piece& last = m_pieces[i - 1];
            piece.rotation = Eigen::Quaterniond(turnedWithin(last, 1)) * last.rotation;
            piece.rotation.normalize();
        }
        if (piece.tangent.shape() == Shape::Still) continue;
        if (!before.isZero()) joinAt(i, before, sign);
        sign *= piece.tangent.endSign();
        before = piece.tangent.endSign() * piece.tangent.tangent(1);
    }
}

/// Makes the corner at the start of a piece that is entered in direction `before`: the least rotation between
/// both tangents, to be spread by spreadCorners(). At a reversal no least rotation exists, and the frame
/// continues backwards.
void MovingFrame::joinAt(size_t index, const Vec3& before, double& sign) {
    Piece& piece = m_pieces[index];
    const Piece& last = m_pieces[index - 1];
    const Vec3 after = piece.tangent.tangent(0);
    if (before.dot(after) < -1 + 1e-9) {
        sign = -sign;
        return;
    }
    const Eigen::AngleAxisd turn = minimalRotation(before, after);
    if (turn.angle() < 1e-10) return;
    piece.rotation = turn * piece.rotation;
    piece.turn = turn.angle();
    piece.axis = turn.axis();
    piece.halfWidth = std::min(piece.to - piece.from, last.to - last.from) / 2;
}

void MovingFrame::setStart() {
    const auto first = std::find_if(m_pieces.begin(), m_pieces.end(),
                                    [](const Piece& p) { return p.tangent.shape() != Shape::Still; });
    if (first == m_pieces.end()) return;
    const TangentPiece& tangent = first->tangent;
    const Vec3 t = tangent.tangent(0);
    if (tangent.shape() != Shape::Straight) {
        m_start = columns(t, tangent.binormal(0).cross(t));
    } else {
        const bool flat = std::abs(t[2]) < 1e-12;
        m_start = columns(t, flat ? Vec3(-t[1], t[0], 0).normalized() : t.unitOrthogonal());
    }
}

/// Turns the rotation near a corner of angle α at u_c: back by α (1 − x)²/2 behind it and forward by as much
/// before it, x = |u − u_c| / half width. This is continuous, with the rate α (1 − x) / half width on both
/// sides.
void MovingFrame::spreadCorners(Sample& sample, double u, size_t index) const {
    const auto turnBy = [&](const Piece& corner, double direction) {
        const double x = std::abs(u - corner.from) / corner.halfWidth;
        if (!(x < 1)) return;
        const Mat3 extra = Eigen::AngleAxisd(direction * corner.turn * (1 - x) * (1 - x) / 2, corner.axis)
                               .toRotationMatrix();
        sample.rotation = extra * sample.rotation;
        sample.omega = extra * sample.omega + corner.turn * (1 - x) / corner.halfWidth * corner.axis;
    };
    if (m_pieces[index].turn > 0) turnBy(m_pieces[index], -1);
    if (index + 1 < m_pieces.size() && m_pieces[index + 1].turn > 0) turnBy(m_pieces[index + 1], 1);
}

MovingFrame::Sample MovingFrame::at(double u, int index) const {
    const Piece& piece = m_pieces[index];
    const double length = piece.to - piece.from, v = (u - piece.from) / length;
    Sample sample;
    sample.rotation = turnedWithin(piece, v) * piece.rotation.toRotationMatrix();
    sample.omega = localOmega(piece, v) / length;
    spreadCorners(sample, u, index);
    return sample;
}

}  // namespace wend
