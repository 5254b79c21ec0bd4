#pragma once

#include <QString>
#include <array>

#include "app/style/colours.h"

namespace wend {

/// The scale of the energy slider: the four named energies (see energy_stops.h) in words.
struct EnergyStop {
    double phi;
    QString name;       // name of the kept quantity
    QString shortHelp;  // which error it trades
};

class EnergyScale {
  public:
    static constexpr int kStops = kEnergyStops;

    explicit EnergyScale(int dimension = 2);
    const std::array<EnergyStop, kStops>& stops() const { return m_stops; }
    /// Return φ at a position in [0, 3], and the position of φ.
    double phiAt(double position) const;
    double positionOf(double phi) const;
    /// Returns the stop at φ, or −1.
    int stopAt(double phi) const;

  private:
    int m_dimension;
    std::array<EnergyStop, kStops> m_stops;
};

}  // namespace wend
