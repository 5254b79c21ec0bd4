#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/motion/handle.h"
#include "core/motion/tangent_piece.h"

namespace wend {

/// The rotation Q(u) = F(u) F(0)ᵀ of a frame F along a curve, with the tangent as its first column.
/// It is the continuous solution of Q′ = [ω]× Q, Q(0) = I, with
///   Minimal: ω = T × T′ (no spin about the tangent; Wang et al. 2008),
///   Frenet:  ω = T × T′ + τ T, per unit of u; on straight pieces and past inflections, where the normal of
/// Frenet is undefined or flips, the frame continues without spin (at a fixed offset to the normal).
/// In the plane both are the tangent's rotation. Straight, planar and Frenet pieces have closed forms;
/// Minimal on a spatial piece integrates a table by double reflection.
/// A jump of the frame at a corner of the curve would tear the shape. The rotation (the smallest from tangent
/// to tangent) is therefore spread over half of the shorter neighbouring piece on either side, with a
/// continuous rate. At exact reversals (cusps, hairpins) the frame continues backwards.
class MovingFrame {
  public:
    MovingFrame(const Curve<3>& curve, FrameKind kind);

    /// The rotation of the frame at a parameter, and its rate.
    struct Sample {
        Mat3 rotation = Mat3::Identity();  // Q(u)
        Vec3 omega = Vec3::Zero();         // per unit of u
    };
    /// Returns the sample at u, which is in the given piece of the curve.
    Sample at(double u, int piece) const;
    /// Returns F(0): tangent, normal and binormal at the start; the normal is arbitrary if the curve starts
    /// straight (in the plane z = 0 it is in the plane). Identity for a curve that never moves.
    const Mat3& start() const { return m_start; }

  private:
    /// A node of a piece's table, which holds the normal at the local parameter v.
    struct Node {
        double v;
        Vec3 normal;
    };
    /// A piece of the curve with the rotation at its start, and the corner there.
    struct Piece {
        TangentPiece tangent;
        double from, to;
        Eigen::Quaterniond rotation =
            Eigen::Quaterniond::Identity();  // Q at its start, without the spreading of corners
        std::vector<Node> table = {};        // Minimal on a spatial piece
        // The corner at its start.
        double turn = 0, halfWidth = 0;
        Vec3 axis = Vec3::UnitZ();
    };
    void joinPieces();
    void joinAt(size_t piece, const Vec3& before, double& sign);
    void setStart();
    void makeTable(Piece& piece) const;
    bool usesTable(const Piece& piece) const;
    Mat3 localFrame(const Piece& piece, double v) const;
    Mat3 turnedWithin(const Piece& piece, double v) const;
    Vec3 localOmega(const Piece& piece, double v) const;
    void spreadCorners(Sample& sample, double u, size_t piece) const;

    FrameKind m_kind;
    std::vector<Piece> m_pieces;
    Mat3 m_start = Mat3::Identity();
};

}  // namespace wend
