#pragma once

#include <span>

namespace wend {

/// How the parts of a system of unknowns that is divided among processes know of each other. The first
/// unknowns of a part are its own; those behind are copies of unknowns of other parts. All parts call the
/// same functions in the same order and get the same results. This class itself: the only part of a system
/// that is not divided.
class PartLinks {
  public:
    PartLinks() = default;
    virtual ~PartLinks() = default;
    PartLinks(const PartLinks&) = delete;
    PartLinks& operator=(const PartLinks&) = delete;

    /// How many of its unknowns are its own.
    virtual int own(int unknowns) const { return unknowns; }
    /// Sets the copies to what their own parts have, so many numbers for every unknown.
    virtual void update(std::span<double>, int /*numbers*/) const {}
    /// The sum over all parts, and the largest value, which is not a number if one of them is not.
    virtual double sum(double part) const { return part; }
    virtual double largest(double part) const { return part; }
    /// What the first part answers.
    virtual bool decide(bool answer) const { return answer; }
};

}  // namespace wend
