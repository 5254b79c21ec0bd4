#pragma once

#include <span>
#include <vector>

namespace wend {

/// How the parts of a system of unknowns that is divided among processes know of each other. The first
/// unknowns of a part are its own; those behind are copies of unknowns of other parts. All parts call the
/// same functions in the same order and get the same results. This class itself: the only part of a system
/// that is not divided.
class PartLinks {
  public:
    /// Rows of a sparse matrix, one after the other: how many entries each has, their columns, and so many
    /// numbers of each.
    struct Rows {
        std::vector<int> count, columns;
        std::vector<float> values;
    };

    PartLinks() = default;
    virtual ~PartLinks() = default;
    PartLinks(const PartLinks&) = delete;
    PartLinks& operator=(const PartLinks&) = delete;

    /// How many of its unknowns are its own.
    virtual int own(int unknowns) const { return unknowns; }
    /// The number of one of its own unknowns in the whole system.
    virtual int number(int unknown) const { return unknown; }
    /// Sets the copies to what their own parts have, so many numbers for every unknown.
    virtual void update(std::span<double>, int /*numbers*/) const {}
    /// The rows of the copies, from those of the own unknowns: row i has the entries [start[i], start[i +
    /// 1]).
    virtual Rows copiedRows(std::span<const int> /*start*/, std::span<const int> /*columns*/,
                            std::span<const float>, int /*numbers*/) const {
        return {};
    }
    /// The sum over all parts, and the largest value, which is not a number if one of them is not.
    virtual double sum(double part) const { return part; }
    virtual double largest(double part) const { return part; }
    /// Return the answer of the first part, and whether all answer yes.
    virtual bool decide(bool answer) const { return answer; }
    virtual bool all(bool answer) const { return answer; }
};

}  // namespace wend
