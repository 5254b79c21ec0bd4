#pragma once

#include <QString>
#include <array>

namespace wend {

/// The scale of the energy slider: four named energies at 0, 1, 2 and 3, φ linear between neighbours. What an
/// energy keeps changes fast in φ near Area and slowly near Angle; equal parts between the named ones make it
/// even to the eye.
struct EnergyStop {
    double phi;
    QString name;       // what is kept
    QString shortHelp;  // which error it trades
};

class EnergyScale {
  public:
    static constexpr int kStops = 4;

    explicit EnergyScale(int dimension = 2);
    const std::array<EnergyStop, kStops>& stops() const { return m_stops; }
    /// φ at a position in [0, 3], and the inverse.
    double phiAt(double position) const;
    double positionOf(double phi) const;
    /// The stop at φ, or −1.
    int stopAt(double phi) const;

  private:
    std::array<EnergyStop, kStops> m_stops;
};

}  // namespace wend
