#pragma once

#include <span>
#include <vector>

namespace wend {

/// Connects the parts of a system of unknowns that is divided among processes. The first unknowns of a part
/// are its own; those behind are copies of unknowns of other parts. All parts call the same functions in the
/// same order and get the same results. This class itself is the only part of a system that is not divided.
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

    /// Returns how many of its unknowns are its own.
    virtual int own(int unknowns) const { return unknowns; }
    /// Returns the number of one of its own unknowns in the whole system.
    virtual int number(int unknown) const { return unknown; }
    /// Sets the copies to the values in the parts that own them, with that many numbers for every unknown.
    virtual void update(std::span<double>, int /*numbers*/) const {}
    /// Returns the rows of the copies, from those of the own unknowns: row i has the entries [start[i],
    /// start[i + 1]).
    virtual Rows copiedRows(std::span<const int> /*start*/, std::span<const int> /*columns*/,
                            std::span<const float>, int /*numbers*/) const {
        return {};
    }
    /// Return the sum over all parts, and the largest value, which is NaN if one of them is.
    virtual double sum(double part) const { return part; }
    virtual double largest(double part) const { return part; }
    /// Return the answer of the first part, and whether all answer yes.
    virtual bool decide(bool answer) const { return answer; }
    virtual bool all(bool answer) const { return answer; }
};

}  // namespace wend
