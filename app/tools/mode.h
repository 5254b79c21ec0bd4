#pragma once

#include <array>

namespace wend {

/// The steps of the work, in their order. Each has tools and panels of its own.
enum class Mode { Mesh, Pins, Paint, Animate, Export };

constexpr std::array<Mode, 5> kModes = {Mode::Mesh, Mode::Pins, Mode::Paint, Mode::Animate, Mode::Export};

/// A set of steps.
class Modes {
  public:
    constexpr Modes() = default;
    constexpr Modes(Mode mode) : m_bits(1U << static_cast<unsigned>(mode)) {}
    static constexpr Modes all() { return Modes((1U << kModes.size()) - 1); }

    constexpr Modes operator|(Modes other) const { return Modes(m_bits | other.m_bits); }
    constexpr Modes without(Modes other) const { return Modes(m_bits & ~other.m_bits); }
    constexpr bool has(Mode mode) const { return (m_bits & Modes(mode).m_bits) != 0; }
    constexpr Mode first() const {
        for (const Mode mode : kModes)
            if (has(mode)) return mode;
        return Mode::Pins;
    }

  private:
    explicit constexpr Modes(unsigned bits) : m_bits(bits) {}
    unsigned m_bits = 0;
};

constexpr Modes operator|(Mode a, Mode b) {
    return Modes(a) | Modes(b);
}

}  // namespace wend
