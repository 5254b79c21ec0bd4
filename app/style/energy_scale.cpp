#include "app/style/energy_scale.h"

#include <QCoreApplication>
#include <cmath>

#include "core/energy/material.h"

namespace wend {

EnergyScale::EnergyScale(int dimension) : m_dimension(dimension) {
    m_stops[0] = {
        phi::kEquia, QCoreApplication::translate("EnergyScale", "Area"),
        QCoreApplication::translate("EnergyScale", "Nothing grows or shrinks. Parts may get thin.")};
    m_stops[1] = {phi::kMetr, QCoreApplication::translate("EnergyScale", "Length"),
                  QCoreApplication::translate("EnergyScale", "Stretches least. Start here.")};
    m_stops[2] = {phi::kAkvf, QCoreApplication::translate("EnergyScale", "Rigid"),
                  QCoreApplication::translate("EnergyScale", "Parts turn like card.")};
    m_stops[3] = {phi::conformal(dimension), QCoreApplication::translate("EnergyScale", "Angle"),
                  QCoreApplication::translate("EnergyScale", "Details keep their look. Parts may swell.")};
    if (dimension == 2) return;
    m_stops[0].name = QCoreApplication::translate("EnergyScale", "Volume");
}

double EnergyScale::phiAt(double position) const {
    return phiAtStop(position, m_dimension);
}

double EnergyScale::positionOf(double phi) const {
    return stopOfPhi(phi, m_dimension);
}

int EnergyScale::stopAt(double phi) const {
    for (int i = 0; i < kStops; ++i)
        if (std::abs(phi - m_stops[i].phi) < 5e-4) return i;
    return -1;
}

}  // namespace wend
