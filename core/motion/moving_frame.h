#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/motion/handle.h"
#include "core/motion/tangent_piece.h"

namespace wend {

/// The rotation Q(u) = F(u) F(0)ᵀ of a frame F that is carried along a curve with its first column on the
/// tangent.
///
/// It is the continuous solution of Q′ = [ω]× Q, Q(0) = I, with
///   Minimal: ω = T × T′ (no spin about the tangent; Wang et al. 2008),
///   Frenet:  ω = T × T′ + τ T, per unit of u; on straight pieces and past inflections, where the normal of
///   Frenet is
///            undefined or flips, the frame is carried on without spin (it keeps a fixed offset to the normal
///            from there).
/// In the plane both are the tangent's rotation. Straight, planar and Frenet pieces are closed forms; Minimal
/// on a spatial piece steps over a table by double reflection.
///
/// A corner of the curve would tear the shape if the frame jumped with the tangent. The turn (the least
/// rotation from tangent to tangent) is spread over half of the shorter neighbouring piece on either side
/// instead, with a continuous rate. Where the curve turns back exactly (cusp, hairpin), the frame goes on
/// backwards.
class MovingFrame {
  public:
    MovingFrame(const Curve<3>& curve, FrameKind kind);

    struct Sample {
        Mat<3> rotation = Mat<3>::Identity();  // Q(u)
        Vec<3> omega = Vec<3>::Zero();         // per unit of u
    };
    /// At u, which lies in the given piece of the curve.
    Sample at(double u, int piece) const;
    /// F(0): tangent, normal and binormal at the start; the normal is arbitrary if the curve starts straight
    /// (in the plane z = 0 it lies in the plane). Identity for a curve that never moves.
    const Mat<3>& start() const { return m_start; }

  private:
    struct Node {
        double v;
        Vec<3> normal;
    };
    struct Piece {
        TangentPiece tangent;
        double from, to;
        Eigen::Quaterniond rotation =
            Eigen::Quaterniond::Identity();  // Q at its start, without the spreading of corners
        std::vector<Node> table = {};        // Minimal on a spatial piece
        // The corner at its start.
        double turn = 0, halfWidth = 0;
        Vec<3> axis = Vec<3>::UnitZ();
    };
    void joinPieces();
    void joinAt(size_t piece, const Vec<3>& before, double& sign);
    void setStart();
    void makeTable(Piece& piece) const;
    bool usesTable(const Piece& piece) const;
    Mat<3> localFrame(const Piece& piece, double v) const;
    Mat<3> turnedWithin(const Piece& piece, double v) const;
    Vec<3> localOmega(const Piece& piece, double v) const;
    void spreadCorners(Sample& sample, double u, size_t piece) const;

    FrameKind m_kind;
    std::vector<Piece> m_pieces;
    Mat<3> m_start = Mat<3>::Identity();
};

}  // namespace wend
